// One libFuzzer target for each format: whatever the bytes, the reader refuses them with an InputError or
// gives sound records. "any" leaves the choice to the sniffers, "archive" unpacks.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "seismic/formats/archive.h"
#include "seismic/input_error.h"
#include "seismic/read_record.h"

namespace {

using dougong::seismic::ReadOptions;
using dougong::seismic::Record;

constexpr std::string_view target = DOUGONG_FORMAT;

// What these files do not say themselves.
ReadOptions options_of_target() {
  ReadOptions options;
  if (target != "any") options.format = std::string(target);
  if (target == "columns" || target == "sac" || target == "miniseed") options.units = "gal";
  if (target == "cosmos") options.count_scale = 1e-6;
  return options;
}

void require_sound(const Record& record) {
  if (record.acceleration.size() < 2 || !(record.interval > 0.0)) std::abort();
  for (const double a : record.acceleration)
    if (!std::isfinite(a)) std::abort();
}

void unpack_all(const std::string& bytes) {
  dougong::seismic::ArchiveLimits limits;
  limits.bytes = std::size_t{1} << 24;
  dougong::seismic::unpack(bytes, "fuzz", limits);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ReadOptions options = options_of_target();
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  try {
    if (target == "archive") return unpack_all(bytes), 0;
    for (const Record& record : dougong::seismic::read_bytes_as_record("fuzz", bytes, options))
      require_sound(record);
  } catch (const dougong::seismic::InputError&) {
  }
  return 0;
}
