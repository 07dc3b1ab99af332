// Another program, run to its end in a folder of its own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace dougong::app {

inline constexpr const char* messages_name = "messages.txt";  // in the folder: whatever it says

/// Whether a program of that name can be started.
bool on_path(const std::string& program);

/// Standard input is the file `input` (of the folder where it is relative). True when it ended well. Throws
/// std::system_error, with ENOENT where the program is not installed, when it cannot be started or is lost.
bool run_in(const std::filesystem::path& folder, std::vector<std::string> words, const std::string& input);

}  // namespace dougong::app
