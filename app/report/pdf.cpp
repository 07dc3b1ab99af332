#include "app/report/pdf.h"

#include <unistd.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "app/report/safe_file.h"
#include "app/report/subprocess.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> printers{"chromium", "chromium-browser", "google-chrome", "weasyprint"};

// Of a page of ours in a folder of ours, so that no path has to be written as an address.
std::vector<std::string> words_for(const std::string& printer, const fs::path& folder) {
  if (printer == "weasyprint") return {printer, "page.html", "page.pdf"};
  std::vector<std::string> words{printer,
                                 "--headless",
                                 "--disable-gpu",
                                 "--no-pdf-header-footer",
                                 "--user-data-dir=" + (folder / "profile").string(),
                                 "--print-to-pdf=page.pdf"};
  if (::geteuid() == 0) words.push_back("--no-sandbox");  // as root it starts without only
  words.push_back("page.html");
  return words;
}

}  // namespace

std::string page_printer() {
  const auto found = std::ranges::find_if(printers, on_path);
  return found == printers.end() ? "" : *found;
}

void print_page(const fs::path& page, const fs::path& pdf) {
  const std::string printer = page_printer();
  if (printer.empty()) throw std::runtime_error("neither chromium nor weasyprint is installed");
  const TemporaryDirectory folder;
  write_file(folder.path() / "page.html", read_file(page));
  const bool ended_well = run_in(folder.path(), words_for(printer, folder.path()), "/dev/null");
  if (!ended_well || !fs::exists(folder.path() / "page.pdf"))
    throw std::runtime_error(printer + " could not print it: " + read_file(folder.path() / messages_name));
  write_file(pdf, read_file(folder.path() / "page.pdf"));
}

}  // namespace dougong::app
