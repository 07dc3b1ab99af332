#include "app/report/weight_joints_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/axis.h"
#include "app/report/block_drawing.h"
#include "app/report/csv.h"
#include "app/report/page.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

constexpr std::size_t told = 12;

/// The round number that a colour scale ends at: not above 1 unless more than all is used.
double scale_end(const std::vector<WeightJoint>& joints) {
  double most = 0.0;
  for (const WeightJoint& joint : joints) most = std::max(most, joint.used);
  if (most >= 0.5) return 1.0;
  const double below = round_below(std::max(most, 1e-3));
  for (const double end : {below, 2.0 * below, 2.5 * below})
    if (end >= most) return end;
  return 5.0 * below;
}

}  // namespace

Figure weight_figure(const ModelSheet& model, const std::vector<WeightJoint>& joints) {
  BlockDrawing drawing;
  drawing.title = "Use of the joints under the weight alone";
  drawing.subtitle = model.layout + ": " + model.title;
  drawing.fill.assign(model.blocks.size(), mixed(ink::white, ink::block, 0.6));
  drawing.scale_title = "used (-)";
  drawing.scale_end = scale_end(joints);
  for (auto joint = joints.rbegin(); joint != joints.rend(); ++joint)
    drawing.lines.push_back({joint->start, joint->end, viridis(joint->used / drawing.scale_end)});
  drawing.legend = {
      "Of the nearest limit: bonds by tension, yield or shear; dry faces by the place of the force (1: at "
      "the end) or "
      "friction."};
  return block_figure(model, drawing);
}

std::string weight_joints_csv(const std::vector<WeightJoint>& joints) {
  std::string out =
      "joint,bonded,start x (m),start y (m),end x (m),end y (m),compression (N),shear (N),eccentricity (1),"
      "greatest compression (Pa),greatest tension (Pa),used (1),of,through x (m),through y (m),"
      "stiffness (N/m),stiffness of the blocks (N/m)\n";
  for (const WeightJoint& j : joints)
    out += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_text(j.name),
                       j.bonded ? 1 : 0, exact(j.start.x), exact(j.start.y), exact(j.end.x), exact(j.end.y),
                       exact(j.normal), exact(j.shear), exact(j.eccentricity), exact(j.compression),
                       exact(j.tension), exact(j.used), j.limit, exact(j.through.x), exact(j.through.y),
                       exact(j.stiffness), exact(j.blocks_stiffness));
  return out;
}

std::vector<std::vector<std::string>> weight_rows(const std::vector<WeightJoint>& joints, std::size_t most) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < std::min(most, joints.size()); ++i) {
    const WeightJoint& j = joints[i];
    const std::string stress = std::isfinite(j.compression) ? fixed(j.compression / 1e3, 1) : "at a corner";
    rows.push_back({j.name, j.bonded ? "bonded" : "dry", fixed(j.normal / 1e3, 2),
                    fixed(std::abs(j.shear) / 1e3, 2), j.bonded ? "" : fixed(j.eccentricity, 3), stress,
                    fixed(j.tension / 1e3, 1), fixed(100.0 * j.used, 1), j.limit});
  }
  return rows;
}

const WeightJoint* most_compressed(const std::vector<WeightJoint>& joints) {
  const WeightJoint* most = nullptr;
  for (const WeightJoint& j : joints)
    if (std::isfinite(j.compression) && (!most || j.compression > most->compression)) most = &j;
  return most;
}

std::string weight_text(const std::vector<WeightJoint>& joints) {
  const WeightJoint& first = joints.front();
  return fmt::format("most used joint {}: {} % of {}; greatest compression {}", first.name,
                     fixed(100.0 * first.used, 1), first.limit, greatest_compression(joints));
}

std::string greatest_compression(const std::vector<WeightJoint>& joints) {
  const WeightJoint* most = most_compressed(joints);
  return most ? significant(most->compression / 1e6, 3) + " MPa in " + most->name : "none";
}

Html page_weight(const RunResult& run, const std::vector<Picture>& pictures) {
  if (run.weight_joints.empty()) return {};
  return paragraph(
             "Forces and stresses in the joints at rest, before the motion. A dry face uses its width by the "
             "place "
             "where the force passes (2 e/L: 1 at its end) and its friction; a bonded face its tensile "
             "strength at the "
             "edge, its yield force or its shear strength. Compression without a strength is "
             "given, not "
             "judged.") +
         figure_named(pictures, "figures/weight.svg", "Faces coloured by the use of their nearest limit.",
                      {"figures/weight.svg", "figures/weight.png", "weight_joints.csv"}) +
         figure_named(pictures, "figures/load_path.svg",
                      "The load path: how the weight goes from block to block to the ground. Of an arch it "
                      "is the line of thrust.",
                      {"figures/load_path.svg", "figures/load_path.png", "weight_joints.csv"}) +
         table(fmt::format("The most used of {}", plural(run.weight_joints.size(), "joint")),
               {{"Joint", "", false},
                {"Kind", "", false},
                {"N", "kN"},
                {"T", "kN"},
                {"2 e/L", "-"},
                {"Compression", "kPa"},
                {"Tension", "kPa"},
                {"Used", "%"},
                {"of", "", false}},
               weight_rows(run.weight_joints, told)) +
         paragraph("Greatest compression: " + greatest_compression(run.weight_joints) + ".");
}

}  // namespace dougong::app
