#include "app/report/moved_joints_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/axis.h"
#include "app/report/block_drawing.h"
#include "app/report/csv.h"
#include "app/report/page.h"
#include "app/report/text.h"
#include "app/study/weight_joints.h"

namespace dougong::app {
namespace {

using structures::Peak;

constexpr std::size_t told = 12;
constexpr double least_scale = 1e-6;  // m

std::string millimetres(double metres) {
  return fixed(1e3 * metres, std::abs(metres) < 1e-3 ? 3 : 1);
}

std::string peak_cells(const Peak& peak) {
  return exact(peak.value) + "," + exact(peak.time);
}

const MovedJoint& widest(const std::vector<MovedJoint>& joints) {
  return *std::ranges::max_element(joints, {}, [](const MovedJoint& j) { return j.opening.value; });
}

const MovedJoint& farthest(const std::vector<MovedJoint>& joints) {
  return *std::ranges::max_element(joints, {}, [](const MovedJoint& j) { return std::abs(j.slip.value); });
}

std::string what_moved_most(const std::vector<MovedJoint>& joints) {
  const MovedJoint &open = widest(joints), &slid = farthest(joints);
  return fmt::format("The widest opening is {} mm, {} at {}; the farthest slip {} mm, {} at {}.",
                     millimetres(open.opening.value), open.name, seconds(open.opening.time),
                     millimetres(std::abs(slid.slip.value)), slid.name, seconds(slid.slip.time));
}

}  // namespace

Figure moved_joints_figure(const ModelSheet& model, const std::vector<MovedJoint>& joints) {
  double most = least_scale;
  for (const MovedJoint& joint : joints) most = std::max(most, movement(joint));
  BlockDrawing drawing;
  drawing.title = "How far the joints opened or slid";
  drawing.subtitle = model.layout + ": " + model.title;
  drawing.fill.assign(model.blocks.size(), mixed(ink::white, ink::block, 0.6));
  drawing.scale_title = "mm";
  drawing.scale_end = round_up(1e3 * most);
  for (auto joint = joints.rbegin(); joint != joints.rend(); ++joint)
    drawing.lines.push_back({joint->start, joint->end, viridis(1e3 * movement(*joint) / drawing.scale_end)});
  drawing.legend = {
      "The greater of widest opening and farthest slip, until a block of the joint lost its support."};
  return block_figure(model, drawing);
}

std::string moved_joints_csv(const std::vector<MovedJoint>& joints) {
  std::string out =
      "joint,bonded,start x (m),start y (m),end x (m),end y (m),opening (m),at (s),slip (m),at (s),"
      "residual opening (m),residual slip (m),compression (N),at (s),tension (N),at (s),shear (N),at (s)\n";
  for (const MovedJoint& j : joints)
    out +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_text(j.name), j.bonded ? 1 : 0,
                    exact(j.start.x), exact(j.start.y), exact(j.end.x), exact(j.end.y), peak_cells(j.opening),
                    peak_cells(j.slip), exact(j.residual_opening), exact(j.residual_slip),
                    peak_cells(j.compression), peak_cells(j.tension), peak_cells(j.shear));
  return out;
}

std::vector<std::vector<std::string>> moved_joint_rows(const std::vector<MovedJoint>& joints,
                                                       std::size_t most) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < std::min(most, joints.size()); ++i) {
    const MovedJoint& j = joints[i];
    rows.push_back({j.name, j.bonded ? "bonded" : "dry", millimetres(j.opening.value),
                    fixed(j.opening.time, 2), millimetres(j.residual_opening),
                    millimetres(std::abs(j.slip.value)), fixed(j.slip.time, 2),
                    millimetres(std::abs(j.residual_slip)), fixed(j.compression.value / 1e3, 2),
                    fixed(j.tension.value / 1e3, 2), fixed(std::abs(j.shear.value) / 1e3, 2)});
  }
  return rows;
}

Html page_moved_joints(const RunResult& run, const std::vector<Picture>& pictures) {
  if (run.moved_joints.empty()) return {};
  return paragraph(what_moved_most(run.moved_joints) +
                   " Joints are the faces that blocks shared at rest; they are followed until one of their "
                   "blocks loses its support. Forces are the greatest at the output times.") +
         figure_named(pictures, "figures/joints.svg", "Faces coloured by how far they opened or slid.",
                      {"figures/joints.svg", "figures/joints.png", "joints.csv"}) +
         table(fmt::format("Those that moved most, of {}", plural(run.moved_joints.size(), "joint")),
               {{"Joint", "", false},
                {"Kind", "", false},
                {"Opening", "mm"},
                {"at", "s"},
                {"left", "mm"},
                {"Slip", "mm"},
                {"at", "s"},
                {"left", "mm"},
                {"N, pressed", "kN"},
                {"N, pulled", "kN"},
                {"T", "kN"}},
               moved_joint_rows(run.moved_joints, told));
}

}  // namespace dougong::app
