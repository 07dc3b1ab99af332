// The verdict on a building, with its evidence. A blow-up is never a collapse; silent sinking is
// never survival.
#pragma once

#include <string>
#include <vector>

namespace dougong::structures {

enum class VerdictKind { survived, collapsed, numerically_invalid, undecided };

struct Verdict {
  VerdictKind kind = VerdictKind::undecided;
  std::string headline;               // one sentence
  std::vector<std::string> evidence;  // one sentence each, numbers with units
};

std::string to_string(VerdictKind kind);  // "survived", "collapsed", "numerically invalid", "undecided"

}  // namespace dougong::structures
