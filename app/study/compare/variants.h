// The variants of a comparison: the base scenario with other values of some keys, each with a name. They come
// from key = value, value ... of the command line, every value with every value of the next key, and from the
// tables [[variant]] of the scenario file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/study/override.h"

namespace dougong::app {

struct Variant {
  std::string name;  // "left_column_width = 0.6 m, isolation = none"
  std::vector<Override> overrides;
};

/// One key with its values, the first of which is that of the reference. A unit at the end of the last value
/// counts for bare numbers before it: "width = 0.3, 0.6 m". Values in brackets or quotes keep their commas.
/// Throws ScenarioError.
std::vector<Variant> variants_of_key(const std::string& text);

/// The tables [[variant]] of a scenario file: `name`, and `set`, a list of "key=value". Files that a value
/// names are meant from where the scenario lies. None is no error. Throws ScenarioError.
std::vector<Variant> variants_of_file(const std::filesystem::path& scenario);

/// Every variant of the first list with every one of the second; an empty list changes nothing.
std::vector<Variant> crossed(const std::vector<Variant>& first, const std::vector<Variant>& second);

/// A name as that of a folder: letters, digits, "." and "_", with "-" for anything else.
std::string folder_name(const std::string& name);
/// The same names, told apart by "-2", "-3" where they are equal.
std::vector<std::string> told_apart(std::vector<std::string> names);

}  // namespace dougong::app
