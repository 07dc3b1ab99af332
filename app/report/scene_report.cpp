#include "app/report/scene_report.h"

#include <algorithm>
#include <numeric>

#include "app/report/csv.h"
#include "app/report/results_fields.h"
#include "app/report/results_writer.h"
#include "app/report/safe_file.h"
#include "app/report/scene.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

using engine::Vec2;

/// The rows of the kept bodies of a history [time][body].
template <class T>
std::vector<T> kept(const SceneResult& r, const std::vector<T>& all) {
  const std::size_t n = r.run.trajectory.blocks;
  const std::vector<std::size_t> bodies = kept_bodies(r);
  std::vector<T> out;
  for (std::size_t k = 0; n > 0 && k < all.size() / n; ++k)
    for (const std::size_t i : bodies) out.push_back(all[k * n + i]);
  return out;
}

std::vector<Vec2> positions(const structures::Trajectory& t) {
  std::vector<Vec2> out;
  for (std::size_t k = 0; k < t.poses.size(); k += 3) out.push_back({t.poses[k], t.poses[k + 1]});
  return out;
}

std::vector<double> angles(const structures::Trajectory& t) {
  std::vector<double> out;
  for (std::size_t k = 2; k < t.poses.size(); k += 3) out.push_back(t.poses[k]);
  return out;
}

/// Datasets of the shape [time][thing] or [time][thing][2].
class Histories {
 public:
  Histories(hid_t group, std::size_t times, std::size_t things)
      : group_(group), times_(times), things_(things) {}

  void write(const char* name, const char* unit, const std::vector<Vec2>& values) const {
    h5::write_numbers(group_, name, unit, {times_, things_, 2}, values.empty() ? nullptr : &values[0].x);
  }
  void write(const char* name, const char* unit, const std::vector<double>& values) const {
    h5::write_numbers(group_, name, unit, {times_, things_}, values.data());
  }

 private:
  hid_t group_;
  hsize_t times_, things_;
};

void write_bodies(hid_t file, const SceneResult& r) {
  const h5::Handle group = h5::make_group(file, "bodies");
  std::vector<std::string> names;
  std::vector<double> masses;
  for (const std::size_t i : kept_bodies(r)) {
    names.push_back(r.run.model.blocks[i].name);
    masses.push_back(r.run.model.blocks[i].mass);
  }
  h5::write_texts(group, "name", {names.size()}, names);
  h5::write_numbers(group, "mass", "kg", {masses.size()}, masses.data());
  const Histories histories(group, r.run.trajectory.times.size(), names.size());
  if (keeps(r, "position")) {
    histories.write("position", "m", kept(r, positions(r.run.trajectory)));
    histories.write("angle", "rad", kept(r, angles(r.run.trajectory)));
  }
  if (keeps(r, "velocity")) {
    histories.write("velocity", "m/s", kept(r, r.velocities));
    histories.write("spin", "rad/s", kept(r, r.spins));
  }
  if (keeps(r, "acceleration")) {
    histories.write("acceleration", "m/s2", kept(r, r.accelerations));
    histories.write("angular_acceleration", "rad/s2", kept(r, r.angular_accelerations));
  }
}

void write_terrains(hid_t file, const SceneResult& r) {
  const h5::Handle group = h5::make_group(file, "terrains");
  h5::write_texts(group, "name", {r.terrain_names.size()}, r.terrain_names);
  Histories(group, r.run.trajectory.times.size(), r.terrain_names.size())
      .write("displacement", "m", r.terrain_displacements);
}

// Datasets of one value a field, at the start and at the end of the run.
void write_trees(ResultsWriter& writer, const SceneResult& r) {
  if (r.tree_at_start.empty()) return;
  const auto each = [](const std::vector<engine::TreeError>& errors, auto member) {
    std::vector<double> values;
    for (const engine::TreeError& e : errors) values.push_back(static_cast<double>(e.*member));
    return values;
  };
  std::vector<std::string> fields;
  for (const engine::TreeError& e : r.tree_at_start) fields.push_back(e.field);
  writer.group("tree", [&] {
    writer.field("field", "", fields);
    writer.field("opening_angle", "", each(r.tree_at_start, &engine::TreeError::opening_angle));
    writer.field("compared", "", each(r.tree_at_start, &engine::TreeError::compared));
    writer.field("force_error_at_start", "", each(r.tree_at_start, &engine::TreeError::relative));
    writer.field("force_error_at_end", "", each(r.tree_at_end, &engine::TreeError::relative));
  });
}

std::string image_of(const SceneResult& r) {
  const h5::Handle file = h5::new_file_in_memory();
  h5::write_text_attribute(file, "format", "dougong scene results");
  h5::write_integer_attribute(file, "format_version", scene_results_version);
  ResultsWriter writer(file);
  writer.field("title", "", r.run.model.layout);
  writer.field("partial", "", r.run.partial);
  writer.field("valid", "", r.valid);
  writer.field("reason", "", r.reason);
  writer.field("time", "s", r.run.trajectory.times);
  writer.field("modelled", "", r.run.model.modelled);
  writer.field("not_modelled", "", r.run.model.not_modelled);
  write_bodies(file, r);
  write_terrains(file, r);
  writer.group("energy", [&] {
    walk_energy(writer, r.run.energy);
    writer.field("field", "J", r.run.energy.field);
  });
  write_trees(writer, r);
  writer.group("numerics", [&] { walk_numerics(writer, r.run.numerics); });
  writer.group("reproducibility", [&] { walk_reproducibility(writer, r.run.reproducibility); });
  return h5::image(file);
}

void write_pictures(const SceneResult& result, const std::filesystem::path& directory,
                    std::vector<std::string>& files) {
  const std::vector<Frame> frames = result.run.moments.empty() ? std::vector<Frame>{} : frames_of(result.run);
  if (frames.empty()) return;
  const SceneView view = view_of(result.run, frames);
  const auto add = [&](const std::string& name, const Image& image) {
    write_file(directory / name, png_of(image));
    files.push_back(name);
  };
  add("film-strip.png", draw_film_strip(result.run, frames, view));
  add("start.png", draw_scene(result.run, frames.front(), view));
  add("end.png", draw_scene(result.run, frames.back(), view));
}

}  // namespace

std::vector<std::size_t> kept_bodies(const SceneResult& r) {
  std::vector<std::size_t> kept;
  const auto& names = r.output.bodies;
  for (std::size_t i = 0; i < r.run.model.blocks.size(); ++i)
    if (names.empty() || std::ranges::find(names, r.run.model.blocks[i].name) != names.end())
      kept.push_back(i);
  return kept;
}

bool keeps(const SceneResult& r, const std::string& quantity) {
  return std::ranges::find(r.output.quantities, quantity) != r.output.quantities.end();
}

void write_scene_results(const SceneResult& result, const std::filesystem::path& path) {
  const h5::Quiet quiet;
  std::string bytes;
  try {
    bytes = image_of(result);
  } catch (const h5::Error& error) {
    throw FileError(path, "write", error.what());
  }
  write_file(path, bytes);
}

std::vector<std::string> write_scene_report(const SceneResult& result,
                                            const std::filesystem::path& directory) {
  std::vector<std::string> files{"results.h5", "scene.toml", "bodies.csv", "energy.csv"};
  write_scene_results(result, directory / "results.h5");
  write_file(directory / "scene.toml", result.run.reproducibility.scenario);
  write_file(directory / "bodies.csv", bodies_csv(result));
  write_file(directory / "energy.csv", energy_csv(result.run));
  if (!result.run.model.bonded.empty()) {
    write_file(directory / "bonds.csv", bonds_csv(result));
    files.push_back("bonds.csv");
  }
  write_pictures(result, directory, files);
  return files;
}

}  // namespace dougong::app
