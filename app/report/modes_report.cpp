#include "app/report/modes_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/report/block_drawing.h"
#include "app/report/csv.h"
#include "app/report/page.h"
#include "app/report/page_frame.h"
#include "app/report/report_output.h"
#include "app/report/safe_file.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

double frequency_of(const engine::Mode& mode) {
  return mode.period() > 0.0 ? 1.0 / mode.period() : 0.0;
}

/// Horizontal, vertical and turn of a block, with the greatest horizontal movement of all of 1 (m).
struct Part {
  engine::Vec2 translation;
  double turn;
};
Part part_of(const ModesResult& r, const engine::Mode& mode, std::size_t block) {
  const std::size_t n = r.model.blocks.size();
  const double scale = 1.0 / horizontal_size(mode, n);
  return {{scale * mode.shape[block], scale * mode.shape[n + block]}, scale * mode.shape[2 * n + block]};
}

std::string caption_of(const ModesResult& r, std::size_t index) {
  const engine::Mode& mode = r.modes[index];
  if (mode.period() <= 0.0) return fmt::format("Mode {}: unstable, it does not swing", index + 1);
  return fmt::format("Mode {}: T = {} s, {} Hz, {} % of the mass", index + 1, significant(mode.period(), 4),
                     significant(frequency_of(mode), 4), fixed(100.0 * mode.participation, 1));
}

Html page_body(const ModesResult& r, const std::vector<Picture>& pictures) {
  Html out;
  for (std::size_t i = 0; i < r.modes.size(); ++i) {
    const std::string name = fmt::format("figures/mode_{}", i + 1);
    out += figure_named(pictures, name + ".svg", caption_of(r, i) + ".", {name + ".svg", name + ".png"});
  }
  return out;
}

Html answer_of(const ModesResult& r) {
  return raw("<header id=\"answer\">\n<h1>") + text(r.model.layout + ": modes of small vibration") +
         raw("</h1>\n") + paragraph(r.model.title, "quiet") +
         table("Horizontal modes about the building at rest under its weight",
               {{"Mode", "", false},
                {"Period, T", "s"},
                {"Frequency", "Hz"},
                {"Effective mass", "%"},
                {"Sum", "%"}},
               mode_rows(r)) +
         paragraph(
             "Every contact that touches is stuck and stays closed: joints that open or slide lengthen the "
             "periods. The stiffness is that of contacts and bonds at rest under the weight, with its "
             "overturning (P-Delta).") +
         raw("</header>\n");
}

}  // namespace

std::vector<std::vector<std::string>> mode_rows(const ModesResult& r) {
  std::vector<std::vector<std::string>> rows;
  double sum = 0.0;
  for (std::size_t i = 0; i < r.modes.size(); ++i) {
    const engine::Mode& mode = r.modes[i];
    sum += mode.participation;
    const bool swings = mode.period() > 0.0;
    rows.push_back({std::to_string(i + 1), swings ? significant(mode.period(), 4) : "unstable",
                    swings ? significant(frequency_of(mode), 4) : "", fixed(100.0 * mode.participation, 2),
                    fixed(100.0 * sum, 2)});
  }
  return rows;
}

std::string modes_csv(const ModesResult& r) {
  std::string out =
      "mode,period (s),frequency (Hz),angular frequency squared (rad2/s2),effective mass over mass (1)\n";
  for (std::size_t i = 0; i < r.modes.size(); ++i) {
    const engine::Mode& mode = r.modes[i];
    const bool swings = mode.period() > 0.0;
    out += fmt::format("{},{},{},{},{}\n", i + 1, swings ? exact(mode.period()) : "",
                       swings ? exact(frequency_of(mode)) : "", exact(mode.angular_frequency_squared),
                       exact(mode.participation));
  }
  return out;
}

std::string mode_shapes_csv(const ModesResult& r) {
  std::string out = "mode,block,horizontal (1),vertical (1),turn (rad/m)\n";
  for (std::size_t i = 0; i < r.modes.size(); ++i)
    for (std::size_t block = 0; block < r.model.blocks.size(); ++block) {
      const Part part = part_of(r, r.modes[i], block);
      out += fmt::format("{},{},{},{},{}\n", i + 1, csv_text(r.model.blocks[block].name),
                         exact(part.translation.x), exact(part.translation.y), exact(part.turn));
    }
  return out;
}

Figure mode_figure(const ModesResult& r, std::size_t index) {
  BlockDrawing drawing;
  drawing.title = caption_of(r, index);
  drawing.subtitle = r.model.layout + ": " + r.model.title;
  std::vector<engine::Vec2> motions;
  for (std::size_t i = 0; i < r.model.blocks.size(); ++i)
    motions.push_back(part_of(r, r.modes[index], i).translation);
  const double factor = drawn_magnification(r.model, motions);
  for (std::size_t i = 0; i < r.model.blocks.size(); ++i) {
    const Part part = part_of(r, r.modes[index], i);
    const Pose pose = described_pose(r.model.blocks[i]);
    drawing.moved.push_back({pose.position + factor * part.translation, pose.angle + factor * part.turn});
    drawing.fill.push_back(mixed(ink::white, category(index), 0.35));
  }
  drawing.legend = {"Shape of the vibration, its size arbitrary; pale: at rest."};
  return block_figure(r.model, drawing);
}

std::vector<std::string> write_modes(const ModesResult& r, const std::string& command,
                                     const std::filesystem::path& folder) {
  make_directory(folder / "figures");
  Output output(folder);
  std::vector<Picture> pictures;
  output.write("modes.csv", modes_csv(r));
  output.write("mode_shapes.csv", mode_shapes_csv(r));
  for (std::size_t i = 0; i < r.modes.size(); ++i)
    write_figure({fmt::format("mode_{}", i + 1), caption_of(r, i), mode_figure(r, i)}, output, pictures);
  output.write("modes.html",
               framed_page(r.model.layout + ": modes", answer_of(r),
                           {{"shapes", "The shapes", page_body(r, pictures)},
                            {"reproduce", "To repeat it",
                             raw("<pre>") + text(command) + raw("</pre>\n") +
                                 paragraph("The numbers: modes.csv, mode_shapes.csv.", "small quiet")}}));
  std::vector<std::string> names = output.names();
  std::rotate(names.begin(), names.end() - 1, names.end());
  return names;
}

}  // namespace dougong::app
