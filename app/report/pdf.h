// A page printed as PDF by a program that prints pages: chromium, Chrome or WeasyPrint, whichever is
// installed.
#pragma once

#include <filesystem>
#include <string>

namespace dougong::app {

/// The first of them that is on the PATH; empty without one.
std::string page_printer();
/// `page` holds all that it shows. Throws std::runtime_error, with the printer's own words where it failed,
/// and FileError.
void print_page(const std::filesystem::path& page, const std::filesystem::path& pdf);

}  // namespace dougong::app
