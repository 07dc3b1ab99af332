// Who includes whom: the directions of docs/architecture.md, checked on the text of the sources.
//
// Only #include "..." counts. A path is taken from the project's root; a name without a folder is a
// generated header (report_css.h) and belongs to whoever includes it.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace dougong::architecture {

/// Text of every source file, by its path from the project's root: "engine/drive.cpp".
using Sources = std::map<std::string, std::string>;

/// The paths in #include "..." lines, in order. Lines in // and /* */ comments do not count.
std::vector<std::string> includes_of(const std::string& text);
/// "engine", "seismic", "structures", "tests"; below app "app/study", "app/report", "app/cli".
std::string module_of(const std::string& path);

/// What is wrong, one sentence each: "engine/model.h includes seismic/record.h: ...".
std::vector<std::string> wrong_directions(const Sources& sources);
std::vector<std::string> headers_without_pragma_once(const Sources& sources);
/// Tests are free in this and in the next.
std::vector<std::string> sources_without_own_header_first(const Sources& sources);
/// Included paths that lead to a file only from the including one's folder, or to none.
std::vector<std::string> includes_not_from_the_root(const Sources& sources);
/// A cycle among the files, "a.h -> b.h -> a.h"; one for every file that closes one.
std::vector<std::string> include_cycles(const Sources& sources);

}  // namespace dougong::architecture
