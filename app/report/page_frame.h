// The frame of every page that is written: one file with its style, the answer first, then the contents and
// the sections.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/report/html.h"

namespace dougong::app {

struct PagePart {
  const char* id;
  const char* title;
  Html body;
};
/// `answer` holds the id "answer". A part without a body is left out.
std::string framed_page(std::string_view title, const Html& answer, const std::vector<PagePart>& parts);

}  // namespace dougong::app
