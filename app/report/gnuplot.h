// gnuplot as a subprocess: script on its standard input, working folder a private one that holds the
// data, so that no path ever has to be quoted. Why gnuplot: docs/decisions/0003-plots-by-gnuplot.md.
#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>

namespace dougong::app {

class PlotError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs the script in `folder`. Throws PlotError with gnuplot's own message, or naming the package to
/// install when there is no gnuplot.
void run_gnuplot(const std::string& script, const std::filesystem::path& folder);

/// Found out before a long run, not after it: that gnuplot is there and can draw. Throws PlotError.
void require_gnuplot();

/// A text as gnuplot's single-quoted string, on one line.
std::string gnuplot_text(const std::string& text);

/// A figure before it is drawn: everything but the terminal and the output.
struct Figure {
  int width = 880;   // px at 1x
  int height = 360;  // px at 1x
  std::string script;
  std::map<std::string, std::string> data;  // file name -> contents
};

struct DrawnFigure {
  std::string svg;
  std::string png;  // at 2x
};

DrawnFigure draw(const Figure& figure);

}  // namespace dougong::app
