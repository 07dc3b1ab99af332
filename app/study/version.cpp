#include "app/study/version.h"

#include "version_facts.h"

namespace dougong::app {

std::string program_version() {
  return version_facts::version;
}
std::string program_git_hash() {
  return version_facts::git_hash;
}
std::string program_compiler() {
  return version_facts::compiler;
}

}  // namespace dougong::app
