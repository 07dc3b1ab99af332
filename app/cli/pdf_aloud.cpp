#include "app/cli/pdf_aloud.h"

#include <stdexcept>

#include "app/cli/run_text.h"
#include "app/report/pdf.h"

namespace dougong::app {

void pdf_aloud(const std::filesystem::path& page, bool wanted, const Terminal& terminal) {
  if (!wanted) return;
  const auto pdf = std::filesystem::path(page).replace_extension(".pdf");
  try {
    print_page(page, pdf);
    terminal.line(row("PDF", pdf.string()));
  } catch (const std::runtime_error& error) {
    terminal.line(row("PDF", error.what()), Tone::doubtful);
  }
}

}  // namespace dougong::app
