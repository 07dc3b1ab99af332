#include "tests/architecture/includes.h"

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>

namespace dougong::architecture {
namespace {

// What a module may include. A path stands for itself and, when it ends in a slash, for all below it.
struct Rule {
  std::string module;
  std::vector<std::string> allowed;
};

const std::vector<Rule>& rules() {
  static const std::vector<Rule> table{
      {"engine", {"engine/"}},
      {"seismic", {"seismic/", "engine/motion.h", "engine/vec2.h"}},
      {"structures", {"structures/", "engine/"}},
      {"app/study", {"app/study/", "engine/", "seismic/", "structures/"}},
      {"app/report", {"app/report/", "app/study/", "engine/", "seismic/", "structures/"}},
      {"app/cli", {"app/", "engine/", "seismic/", "structures/"}},
      {"tests", {"tests/", "app/", "engine/", "seismic/", "structures/"}},
  };
  return table;
}

const Rule* rule_of(const std::string& module) {
  const auto found = std::ranges::find(rules(), module, &Rule::module);
  return found == rules().end() ? nullptr : &*found;
}

bool covers(const std::string& allowed, const std::string& path) {
  return allowed.ends_with('/') ? path.starts_with(allowed) : path == allowed;
}

bool has_folder(const std::string& path) {
  return path.find('/') != std::string::npos;
}

bool is_header(const std::string& path) {
  return path.ends_with(".h");
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

// The text without comments; line breaks stay. Quotes are not looked at: a source that hides an #include
// behind "/*" in a string does not exist.
std::string without_comments(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    if (text.compare(i, 2, "//") == 0) {
      i = std::min(text.find('\n', i), text.size());
    } else if (text.compare(i, 2, "/*") == 0) {
      const std::size_t end = std::min(text.find("*/", i + 2), text.size() - 2) + 2;
      for (; i < end; ++i)
        if (text[i] == '\n') out += '\n';
    } else {
      out += text[i++];
    }
  }
  return out;
}

// The path of a line `#include "path"`, with blanks wherever the language allows them.
std::optional<std::string> included_path(std::string line) {
  const auto skip = [&line](std::string_view word) {
    line.erase(0, std::min(line.find_first_not_of(" \t"), line.size()));
    if (!line.starts_with(word)) return false;
    line.erase(0, word.size());
    return true;
  };
  if (!skip("#") || !skip("include") || !skip("\"")) return std::nullopt;
  const std::size_t end = line.find('"');
  if (end == std::string::npos) return std::nullopt;
  return line.substr(0, end);
}

// Walks along the includes, depth first; a file on the present path that is met again closes a cycle.
class CycleSearch {
 public:
  explicit CycleSearch(const Sources& sources) : sources_(sources) {}

  std::vector<std::string> run() {
    for (const auto& [path, text] : sources_) visit(path);
    return cycles_;
  }

 private:
  void visit(const std::string& path) {
    if (const auto on_trail = std::ranges::find(trail_, path); on_trail != trail_.end()) {
      std::string cycle;
      for (auto it = on_trail; it != trail_.end(); ++it) cycle += *it + " -> ";
      cycles_.push_back(cycle + path);
      return;
    }
    if (!sources_.contains(path) || !seen_.insert(path).second) return;
    trail_.push_back(path);
    for (const std::string& included : includes_of(sources_.at(path))) visit(included);
    trail_.pop_back();
  }

  const Sources& sources_;
  std::set<std::string> seen_;
  std::vector<std::string> trail_;
  std::vector<std::string> cycles_;
};

}  // namespace

std::vector<std::string> includes_of(const std::string& text) {
  std::vector<std::string> paths;
  std::istringstream lines(without_comments(text));
  for (std::string line; std::getline(lines, line);)
    if (const auto path = included_path(line)) paths.push_back(*path);
  return paths;
}

std::string module_of(const std::string& path) {
  const std::size_t first = path.find('/');
  if (first == std::string::npos) return "";
  if (!path.starts_with("app/")) return path.substr(0, first);
  return path.substr(0, std::min(path.find('/', first + 1), path.size()));
}

std::vector<std::string> wrong_directions(const Sources& sources) {
  std::vector<std::string> wrong;
  for (const auto& [path, text] : sources) {
    const Rule* rule = rule_of(module_of(path));
    if (!rule) {
      wrong.push_back(path + " belongs to no module that this test knows");
      continue;
    }
    for (const std::string& included : includes_of(text)) {
      if (!has_folder(included)) continue;
      const auto allows = [&](const std::string& allowed) { return covers(allowed, included); };
      if (std::ranges::none_of(rule->allowed, allows))
        wrong.push_back(path + " includes " + included + ": " + rule->module + " may include only " +
                        listed(rule->allowed));
    }
  }
  return wrong;
}

std::vector<std::string> headers_without_pragma_once(const Sources& sources) {
  std::vector<std::string> wrong;
  for (const auto& [path, text] : sources)
    if (is_header(path) && without_comments(text).find("#pragma once\n") == std::string::npos)
      wrong.push_back(path);
  return wrong;
}

std::vector<std::string> sources_without_own_header_first(const Sources& sources) {
  std::vector<std::string> wrong;
  for (const auto& [path, text] : sources) {
    if (!path.ends_with(".cpp") || module_of(path) == "tests") continue;
    const std::string own = path.substr(0, path.size() - 4) + ".h";
    if (!sources.contains(own)) continue;
    // Before any other include, of either kind.
    const std::string code = without_comments(text);
    const std::size_t first = code.find("#include");
    if (first == std::string::npos || !code.substr(first).starts_with("#include \"" + own + "\""))
      wrong.push_back(path + " must include " + own + " first");
  }
  return wrong;
}

std::vector<std::string> includes_not_from_the_root(const Sources& sources) {
  std::vector<std::string> wrong;
  for (const auto& [path, text] : sources) {
    if (module_of(path) == "tests") continue;
    for (const std::string& included : includes_of(text)) {
      const std::string neighbour = path.substr(0, path.rfind('/') + 1) + included;
      if (has_folder(included) ? !sources.contains(included) : sources.contains(neighbour))
        wrong.push_back(path + " includes " + included + ", which is no path from the project's root");
    }
  }
  return wrong;
}

std::vector<std::string> include_cycles(const Sources& sources) {
  return CycleSearch(sources).run();
}

}  // namespace dougong::architecture
