#include "app/report/model_dxf.h"

#include <dxflib/dl_dxf.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>

#include "app/report/camera.h"
#include "app/report/safe_file.h"

namespace dougong::app {
namespace {

using engine::Vec2;

constexpr int by_layer = 256;  // colour
constexpr int closed = 1;      // flag of a polyline

DL_Attributes on_layer(const std::string& layer) {
  return {layer, by_layer, -1, "CONTINUOUS", 1.0};
}

class Writer {
 public:
  explicit Writer(const std::filesystem::path& path) : writer_(dxf_.out(path.c_str(), DL_Codes::AC1009_MIN)) {
    if (!writer_) throw FileError(path, "write DXF", "cannot be opened");
    writer_->sectionEntities();
  }
  ~Writer() {
    writer_->sectionEnd();
    writer_->dxfEOF();
    writer_->close();
  }

  void polygon(const std::vector<Vec2>& corners, const std::string& layer) {
    dxf_.writePolyline(*writer_, {static_cast<int>(corners.size()), 0, 0, closed}, on_layer(layer));
    for (const Vec2 p : corners) dxf_.writeVertex(*writer_, {p.x, p.y});
    dxf_.writePolylineEnd(*writer_);
  }
  void line(Vec2 a, Vec2 b, const std::string& layer) {
    dxf_.writeLine(*writer_, {a.x, a.y, 0.0, b.x, b.y, 0.0}, on_layer(layer));
  }

 private:
  DL_Dxf dxf_;
  std::unique_ptr<DL_WriterA> writer_;
};

Vec2 place_of(const ModelSheet& model, std::size_t owner, Vec2 local) {
  const Pose pose = described_pose(owner < model.blocks.size() ? model.blocks[owner]
                                                               : model.terrains[owner - model.blocks.size()]);
  return pose.position + engine::rotated(local, pose.angle);
}

void write(const ModelSheet& model, Writer& writer) {
  for (const DrawnShape& terrain : model.terrains)
    for (const auto& outline : outlines(terrain, described_pose(terrain))) writer.polygon(outline, "ground");
  for (const DrawnShape& block : model.blocks) {
    const std::string layer =
        block.storey < 0 ? "blocks" : model.storeys[static_cast<std::size_t>(block.storey)].name;
    for (const auto& outline : outlines(block, described_pose(block))) writer.polygon(outline, layer);
  }
  for (const DrawnBond& bond : model.bonded)
    writer.line(place_of(model, bond.owner, bond.start), place_of(model, bond.owner, bond.end), "bonds");
  for (const DrawnLink& link : model.links)
    writer.line(place_of(model, link.a, link.anchor_a), place_of(model, link.b, link.anchor_b), "joints");
}

/// A file of this process that is gone afterwards: dxflib writes by name.
struct ScratchFile {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("dougong-" + std::to_string(getpid()) + ".dxf");
  ~ScratchFile() {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
};

}  // namespace

std::string model_dxf(const ModelSheet& model) {
  const ScratchFile scratch;
  {
    Writer writer(scratch.path);
    write(model, writer);
  }
  std::ifstream file(scratch.path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace dougong::app
