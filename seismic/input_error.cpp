#include "seismic/input_error.h"

#include <fmt/format.h>

#include <utility>

namespace dougong::seismic {
namespace {

// A broken file can hold thousands of bad fields; the first few say what is wrong.
constexpr std::size_t most_printed = 20;

std::string joined(const std::vector<InputProblem>& problems) {
  std::string text;
  for (std::size_t i = 0; i < problems.size() && i < most_printed; ++i) {
    if (i > 0) text += '\n';
    text += problems[i].text();
  }
  if (problems.size() > most_printed) text += fmt::format("\nand {} more", problems.size() - most_printed);
  return text;
}

}  // namespace

std::string InputProblem::text() const {
  const std::string where = line ? fmt::format("{}:{}", file, line) : file;
  return fmt::format("{}: expected {}, found {}", where, expected, found);
}

InputError::InputError(std::vector<InputProblem> problems)
    : std::runtime_error(joined(problems)), problems_(std::move(problems)) {}

InputError::InputError(std::string file, std::size_t line, std::string expected, std::string found)
    : InputError(std::vector{InputProblem{std::move(file), line, std::move(expected), std::move(found)}}) {}

}  // namespace dougong::seismic
