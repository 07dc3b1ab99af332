#include "app/cli/record_choice.h"

#include <filesystem>

#include "app/study/scene_build.h"

namespace dougong::app {

Override record_override(const std::string& text) {
  std::error_code error;
  if (std::filesystem::exists(text, error) || names_a_file(text)) return {"record.file", text, "--record"};
  return {"record.name", text, "--record"};
}

}  // namespace dougong::app
