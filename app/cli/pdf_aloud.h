// The PDF of a page that a command was asked for.
#pragma once

#include <filesystem>

#include "app/cli/terminal.h"

namespace dougong::app {

/// Beside the page, under its name. What keeps it from being printed is said: the page stands.
void pdf_aloud(const std::filesystem::path& page, bool wanted, const Terminal& terminal);

}  // namespace dougong::app
