// Which program this is.
#pragma once

#include <string>

namespace dougong::app {

std::string program_version();  // "0.1.0"
std::string
program_git_hash();  // of the commit it was built from, "-dirty" with uncommitted changes; "unknown"
std::string program_compiler();  // "GNU 12.2.0, Release"

}  // namespace dougong::app
