#include "app/report/gnuplot.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "app/report/safe_file.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* script_name = "script.gp";
constexpr const char* message_name = "messages.txt";
constexpr const char* font = "Arial";
constexpr const char* font_stack = "Arial, Liberation Sans, Helvetica, sans-serif";
constexpr int font_size = 13;  // px at 1x

/// Files of the child: script in, whatever it says to one file.
class FileActions {
 public:
  explicit FileActions(const fs::path& folder) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, script_name, O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, message_name, O_WRONLY | O_CREAT | O_TRUNC,
                                     0600);
    posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
  }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

pid_t start(const FileActions& files) {
  char program[] = "gnuplot", no_user_settings[] = "-d";
  char* const arguments[] = {program, no_user_settings, nullptr};
  pid_t child = 0;
  const int error = posix_spawnp(&child, program, files.get(), nullptr, arguments, environ);
  if (error == ENOENT) {
    throw PlotError("gnuplot is not installed, and the plots need it: install the package gnuplot-nox");
  }
  if (error != 0) throw PlotError("cannot start gnuplot: " + std::generic_category().message(error));
  return child;
}

int wait_for(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw PlotError("lost gnuplot: " + std::generic_category().message(errno));
  }
  return status;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

std::string svg_terminal(const Figure& f) {
  return fmt::format("set terminal svg size {},{} fixed font '{},{}' noenhanced background rgb 'white'\n",
                     f.width, f.height, font, font_size);
}

std::string png_terminal(const Figure& f) {
  return fmt::format(
      "set terminal pngcairo size {},{} font '{},{}' fontscale 2 linewidth 2 pointscale 2 noenhanced "
      "background rgb 'white'\n",
      2 * f.width, 2 * f.height, font, font_size * 3 / 4.0);
}

}  // namespace

void run_gnuplot(const std::string& script, const fs::path& folder) {
  write_file(folder / script_name, script);
  const int status = wait_for(start(FileActions(folder)));
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  const std::string said = read_file(folder / message_name);
  throw PlotError("gnuplot failed: " + (said.empty() ? "no message" : said.substr(0, 2000)));
}

std::string gnuplot_text(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'')
      out += "''";
    else
      out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out + "'";
}

DrawnFigure draw(const Figure& figure) {
  const TemporaryDirectory folder;
  for (const auto& [name, contents] : figure.data) write_file(folder.path() / name, contents);
  const std::string start = "set encoding utf8\nset minussign\n";
  run_gnuplot(start + svg_terminal(figure) + "set output 'figure.svg'\n" + figure.script +
                  "unset output\nreset\n" + start + png_terminal(figure) + "set output 'figure.png'\n" +
                  figure.script + "unset output\n",
              folder.path());
  const std::string quoted_font = fmt::format("font-family=\"{}\"", font);
  return {replaced(read_file(folder.path() / "figure.svg"), quoted_font,
                   fmt::format("font-family=\"{}\"", font_stack)),
          read_file(folder.path() / "figure.png")};
}

}  // namespace dougong::app
