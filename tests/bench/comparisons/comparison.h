// A comparison with a published table or measurement: the table that its page shows, and its figure.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/report/colour.h"
#include "app/report/gnuplot.h"

namespace dougong::comparisons {

struct Comparison {
  std::string table;  // Markdown
  app::Figure figure;
};

using Arguments = std::vector<std::string>;

Comparison dry_walls();                                                // C01
Comparison arch_thickness();                                           // C02
Comparison tilting_arch();                                             // C03
Comparison drum_column();                                              // C04
Comparison single_degree(const Arguments& el_centro_at2);              // C05
Comparison five_storey_frame(const Arguments& el_centro_at2);          // C06
Comparison newmark_tables();                                           // C07
Comparison steel_frame();                                              // C08
Comparison stick_slip();                                               // C09
Comparison brick_array(const Arguments& rate_restitution_step);        // M02
Comparison granite_boulder(const Arguments& motions_and_block);        // M01
Comparison laboratory_frame();                                         // M03
Comparison casks(const Arguments& records_folder);                     // M05
Comparison rocking_restitution(const Arguments& settings_and_ratios);  // M04

/// Lines of numbers in columns of equal length, as gnuplot reads them. Keeps every `stride`-th line.
std::string columns(const std::vector<std::vector<double>>& values, std::size_t stride = 1);

/// What all figures have: light grid, no box.
inline const std::string look =
    "set grid lc rgb '#dddddd'\nset border 3 lc rgb '#555555'\nset tics nomirror\n"
    "set key outside top center horizontal samplen 2 noenhanced\n";

}  // namespace dougong::comparisons
