// Histories stacked over one time axis, so that a vertical line through all of them is one moment.
//
// Panels share the left and right edge. Peaks carry a dot with value and time, curves a label at their
// right end instead of a legend, and labels that would meet are pushed apart.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/report/axis.h"
#include "app/report/colour.h"
#include "app/report/gnuplot.h"
#include "structures/response.h"

namespace dougong::app {

struct Curve {
  std::vector<double> x, y;
  Colour colour;
  double width = 1.0;
  bool dashed = false;
  std::string end_label;  // at the right edge; empty for none
};

/// Between two curves over the same times, behind the curves.
struct Shade {
  std::vector<double> x, low, high;
  Colour colour;
};

struct Mark {
  double x = 0.0, y = 0.0;
  std::string label;
  Colour colour;
  bool cross = false;  // a loss; a dot otherwise
};

struct Panel {
  std::string label;  // quantity, symbol and unit
  std::vector<Curve> curves;
  std::vector<Mark> marks;
  std::string note;  // in the upper left corner
  Colour note_colour = ink::quiet;
  double height = 120;  // px
  double flat = 1.2;    // half range when nothing moves
  std::vector<Shade> shades = {};
};

struct Stack {
  std::string title, subtitle;
  std::string x_label = "Time, t (s)";
  Range x;
  std::vector<Panel> panels;
  int right_margin = 30;    // px; room for labels at the ends
  std::string labels = {};  // "set label ..." of the whole sheet, beside the heading
  int room_below = 0;       // px under the panels, for `below`: plots of another kind on the same sheet
  std::string below = {};
};

Figure stacked(const Stack& stack);

/// Left, right, top and bottom of a plot on a sheet, px from its upper left corner.
struct Frame {
  int left, right, top, bottom;
};
/// "set lmargin at screen ..." on a sheet of this size.
std::string margins(const Frame& frame, int width, int height);
inline constexpr int stack_width = 880;  // px
int stack_height(const Stack& stack);    // px, with the room below

/// Factor and name of J, kJ or MJ, so that numbers up to this one stay short.
std::pair<double, std::string> energy_unit(double joules);
/// Less the first value.
std::vector<double> since_start(std::vector<double> values);

/// A history up to the loss of the first storey: afterwards the ground feels debris, and its blows would hide
/// what the building did.
std::vector<double> until_first_loss(const structures::Response& response, std::vector<double> values);

/// "set grid, no box, ..." common to all figures.
std::string plain_style();
/// Title and subtitle at the upper left.
std::string heading(const std::string& title, const std::string& subtitle, int width, int height);

}  // namespace dougong::app
