#include "app/report/page_frame.h"

#include "app/report/text.h"
#include "report_css.h"

namespace dougong::app {
namespace {

Html section(const PagePart& part) {
  return raw(std::string("<section id=\"") + part.id + "\">\n") + heading2(part.title) + part.body +
         raw("</section>\n");
}

Html contents(const std::vector<PagePart>& parts) {
  std::string out = "<nav aria-label=\"Contents\"><ol>\n";
  for (const PagePart& part : parts)
    out += std::string("<li><a href=\"#") + part.id + "\">" + escape_markup(part.title) + "</a></li>\n";
  return raw(out + "</ol></nav>\n");
}

Html head(std::string_view title) {
  return raw("<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
             "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>") +
         text(title) + raw("</title>\n<style>\n") + raw(report_css) +
         raw("</style>\n</head>\n<body>\n"
             "<a class=\"skip\" href=\"#answer\">To the answer</a>\n<main>\n");
}

}  // namespace

std::string framed_page(std::string_view title, const Html& answer, const std::vector<PagePart>& all) {
  std::vector<PagePart> parts = all;
  std::erase_if(parts, [](const PagePart& part) { return part.body.code.empty(); });
  Html page = head(title) + answer + contents(parts);
  for (const PagePart& part : parts) page += section(part);
  return (page + raw("</main>\n</body>\n</html>\n")).code;
}

}  // namespace dougong::app
