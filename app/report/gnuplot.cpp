#include "app/report/gnuplot.h"

#include <fmt/format.h>

#include <system_error>

#include "app/report/safe_file.h"
#include "app/report/subprocess.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* script_name = "script.gp";
constexpr const char* font = "Arial";
constexpr const char* font_stack = "Arial, Liberation Sans, Helvetica, sans-serif";
constexpr int font_size = 13;  // px at 1x

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

std::string svg_terminal(const Figure& f) {
  return fmt::format("set terminal svg size {},{} fixed font '{},{}' noenhanced background rgb 'white'\n",
                     f.width, f.height, font, font_size);
}

std::string png_terminal(const Figure& f) {
  return fmt::format(
      "set terminal pngcairo size {},{} font '{},{}' fontscale 2 linewidth 2 pointscale 2 noenhanced "
      "background rgb 'white'\n",
      2 * f.width, 2 * f.height, font, font_size * 3 / 4.0);
}

}  // namespace

void run_gnuplot(const std::string& script, const fs::path& folder) {
  write_file(folder / script_name, script);
  try {
    if (run_in(folder, {"gnuplot", "-d"}, script_name)) return;  // -d: no settings of the user
  } catch (const std::system_error& error) {
    if (error.code() != std::errc::no_such_file_or_directory) throw PlotError(error.what());
    throw PlotError("gnuplot is not installed, and the plots need it: install the package gnuplot-nox");
  }
  const std::string said = read_file(folder / messages_name);
  throw PlotError("gnuplot failed: " + (said.empty() ? "no message" : said.substr(0, 2000)));
}

void require_gnuplot() {
  const TemporaryDirectory folder;
  run_gnuplot("set terminal svg\nset terminal pngcairo\n", folder.path());
}

std::string gnuplot_text(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'')
      out += "''";
    else
      out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out + "'";
}

DrawnFigure draw(const Figure& figure) {
  const TemporaryDirectory folder;
  for (const auto& [name, contents] : figure.data) write_file(folder.path() / name, contents);
  const std::string start = "set encoding utf8\nset minussign\n";
  run_gnuplot(start + svg_terminal(figure) + "set output 'figure.svg'\n" + figure.script +
                  "unset output\nreset\n" + start + png_terminal(figure) + "set output 'figure.png'\n" +
                  figure.script + "unset output\n",
              folder.path());
  const std::string quoted_font = fmt::format("font-family=\"{}\"", font);
  return {replaced(read_file(folder.path() / "figure.svg"), quoted_font,
                   fmt::format("font-family=\"{}\"", font_stack)),
          read_file(folder.path() / "figure.png")};
}

}  // namespace dougong::app
