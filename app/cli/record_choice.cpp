#include "app/cli/record_choice.h"

#include <filesystem>

namespace dougong::app {

Override record_override(const std::string& text) {
  std::error_code error;
  const bool path_like = text.find('/') != std::string::npos || text.find('.') != std::string::npos;
  if (std::filesystem::exists(text, error) || path_like) return {"record.file", text, "--record"};
  return {"record.name", text, "--record"};
}

}  // namespace dougong::app
