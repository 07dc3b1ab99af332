// Wrong input, said so that it can be put right: where, what was expected, what was found.
//
// A reader collects every problem it meets and throws them together, so that a file is corrected once.
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace dougong::seismic {

struct InputProblem {
  std::string file;      // path as given, or the name of the options
  std::size_t line = 0;  // from 1; 0 when no line is to blame
  std::string expected;
  std::string found;

  std::string text() const;  // "file:line: expected ..., found ..."
};

class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<InputProblem> problems);
  InputError(std::string file, std::size_t line, std::string expected, std::string found);

  const std::vector<InputProblem>& problems() const { return problems_; }

 private:
  std::vector<InputProblem> problems_;
};

/// A sound file of another quantity: velocity, displacement, spectra.
class NotAcceleration : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace dougong::seismic
