#include "app/report/report.h"

#include <fmt/format.h>

#include "app/report/collapse_sequence.h"
#include "app/report/csv.h"
#include "app/report/figures.h"
#include "app/report/model_svg.h"
#include "app/report/moved_joints_report.h"
#include "app/report/page.h"
#include "app/report/report_output.h"
#include "app/report/safe_file.h"
#include "app/report/scene.h"
#include "app/report/screening_text.h"
#include "app/report/summary.h"
#include "app/report/text.h"
#include "app/report/weight_joints_report.h"
#include "app/study/floor_spectra.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* svg_type = "image/svg+xml";
constexpr double first_screen_width = 330;  // px at 1x, beside the drift profile

void write_tables(const RunResult& run, Output& output) {
  output.write("drift.csv", drift_csv(run));
  output.write("shear_drift.csv", shear_drift_csv(run));
  output.write("acceleration.csv", acceleration_csv(run));
  output.write("roof_and_base_shear.csv", roof_and_base_shear_csv(run));
  output.write("energy.csv", energy_csv(run));
  output.write("storeys.csv", storeys_csv(run));
  output.write("overlap.csv", overlap_csv(run));
  if (!run.motion.spectrum_psa.empty()) output.write("spectrum.csv", spectrum_csv(run.motion));
  if (!run.model.bonded.empty()) output.write("damage.csv", damage_csv(run));
  output.write("motion.csv", motion_csv(run));
  if (!run.weight_joints.empty()) output.write("weight_joints.csv", weight_joints_csv(run.weight_joints));
  if (!run.end_joints.empty()) output.write("load_path_end.csv", weight_joints_csv(run.end_joints));
  if (!run.moved_joints.empty()) output.write("joints.csv", moved_joints_csv(run.moved_joints));
  if (const FloorSpectra spectra = floor_spectra(run); !spectra.floors.empty())
    output.write("floor_spectra.csv", floor_spectra_csv(spectra));
  if (!run.screening.checks.empty()) output.write("screening.csv", screening_csv(run.screening));
  if (run.ensemble.members.size() > 1) {
    output.write("ensemble.csv", ensemble_csv(run.ensemble));
    output.write("ensemble_roof_drift.csv", ensemble_roof_drift_csv(run.ensemble));
  }
  if (!run.collapse.happened()) return;
  output.write("collapse_sequence.csv", collapse_sequence_csv(run));
  output.write("falls.csv", falls_csv(run));
  output.write("mass_lost.csv", mass_lost_csv(run));
}

void write_plots(const RunResult& run, Output& output, std::vector<Picture>& pictures) {
  for (const NamedFigure& named : all_figures(run)) write_figure(named, output, pictures);
}

void add_png(const std::string& name, const Image& image, const std::string& alt, Output& output,
             std::vector<Picture>& pictures) {
  write_image(name, image, SceneView{}.scale, alt, output, pictures);
}

void write_model(const RunResult& run, Output& output, std::vector<Picture>& pictures) {
  const std::string svg = model_svg(run.model), name = "figures/model.svg";
  output.write(name, svg);
  output.write("figures/model.png", png_of(draw_model(run.model)));
  pictures.push_back({name, svg_type, svg, "Elevation of " + run.model.layout + ": " + run.model.title, 0});
}

std::string strip_words(const std::vector<Frame>& frames) {
  std::string words = "The building at";
  for (const Frame& frame : frames) words += " " + seconds(frame.time) + " (" + frame.caption + ");";
  return words;
}

void write_scenes(const RunResult& run, Output& output, std::vector<Picture>& pictures) {
  const std::vector<Frame> frames = frames_of(run);
  if (frames.empty()) return;
  const SceneView view = view_of(run, frames);
  const Frame& telling = telling_frame(run, frames);
  SceneView beside = view;
  beside.width = first_screen_width;
  add_png("figures/scene.png", draw_scene(run, telling, beside),
          "The building at " + seconds(telling.time) + ", " + telling.caption + ".", output, pictures);
  add_png("figures/film_strip.png", draw_film_strip(run, frames, view), strip_words(frames), output,
          pictures);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    output.write(fmt::format("figures/frame_{}.png", i + 1), png_of(draw_scene(run, frames[i], view)));
  }
}

}  // namespace

std::vector<fs::path> write_report(const RunResult& run, const fs::path& folder) {
  make_directory(folder / "figures");
  Output output(folder);
  std::vector<Picture> pictures;
  write_tables(run, output);
  write_plots(run, output, pictures);
  write_model(run, output, pictures);
  write_scenes(run, output, pictures);
  output.write("report.html", report_page(run, pictures));
  std::vector<std::string> files = output.names();
  files.push_back("summary.json");
  output.write("summary.json", summary_json(run, files));
  return output.paths();
}

}  // namespace dougong::app
