// The built program as a person meets it: run in a folder of its own, with what it printed and left there.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/report/safe_file.h"

namespace dougong::app {

struct Ran {
  int exit_code = -1;  // -1 when a signal ended it
  int signal = 0;
  std::string out, err;
};

struct Surroundings {
  std::map<std::string, std::string> environment;  // added to that of the test
  std::size_t largest_file = 0;                    // bytes a file may grow to; 0: any
  bool as_nobody = false;                          // gives up the rights of root
  int signal = 0;                                  // sent ...
  std::string when_it_says;                        // ... as soon as standard output holds this
  std::string input;                               // on standard input, through a file
};

class ProgramTest : public testing::Test {
 protected:
  /// Runs `dougong arguments...` in folder().
  Ran run(const std::vector<std::string>& arguments, const Surroundings& around = {}) const;

  const std::filesystem::path& folder() const { return folder_.path(); }
  std::filesystem::path write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const { return read_file(folder() / name); }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder() / name); }
  /// Surroundings in which gnuplot is a shell script of this body.
  Surroundings with_gnuplot(const std::string& script) const;
  /// Surroundings in which ffmpeg is a shell script of this body, or missing when it is empty.
  Surroundings with_ffmpeg(const std::string& script) const { return with_only("ffmpeg", script); }
  /// The same of another program.
  Surroundings with_only(const std::string& name, const std::string& script) const;
  /// A gnuplot that draws nothing, for tests of everything but the figures.
  Surroundings with_quick_plots() const;
  /// Every file and folder below folder(), sorted.
  std::vector<std::string> listing() const;

  /// Exit code 2, each of the words on standard error, nothing written and nothing changed.
  void expect_refusal(const std::vector<std::string>& arguments, const std::vector<std::string>& words,
                      const Surroundings& around = {}) const;

 private:
  Surroundings with_tool(const std::string& name, const std::string& script) const;

  TemporaryDirectory folder_, outputs_, tools_;
};

/// One second of the four-storey building on a shipped record, unless `more` says otherwise.
std::vector<std::string> short_run(const std::string& out, const std::vector<std::string>& more = {});

}  // namespace dougong::app
