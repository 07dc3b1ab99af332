#include "seismic/synthesis/shipped.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "seismic/constants.h"
#include "seismic/describe.h"
#include "seismic/formats/csmnc.h"
#include "seismic/formats/file_text.h"
#include "seismic/formats/knet.h"
#include "seismic/formats/peer_at2.h"
#include "seismic/formats/write_record.h"
#include "seismic/numerics/parse_number.h"
#include "seismic/synthesis/scenario.h"

namespace dougong::seismic {
namespace {

using Json = nlohmann::ordered_json;

constexpr double recorder_step = 1e-6 * standard_gravity;  // m/s2

struct Component {
  std::string name;  // of the file
  std::string bytes;
  Record record;  // as a reader sees it
};

// Without the mean, which K-NET's readers take off: so the files of all formats hold the same motion.
std::vector<double> as_recorded(std::vector<double> motion) {
  double mean = 0.0;
  for (const double a : motion) mean += a / static_cast<double>(motion.size());
  for (double& a : motion) a = std::round((a - mean) / recorder_step) * recorder_step;
  return motion;
}

// On a sphere of 6371 km.
std::optional<Place> station_place(const Scenario& s) {
  if (!s.hypocentre) return std::nullopt;
  constexpr double degree = 6371e3 * two_pi / 360.0;  // m
  const double latitude = s.hypocentre->latitude;
  return Place{latitude + s.site.north / degree,
               s.hypocentre->longitude + s.site.east / (degree * std::cos(latitude * two_pi / 360.0)),
               {}};
}

Record record_of(const Scenario& s, const char* component, Axis axis, double azimuth,
                 std::vector<double> motion) {
  Record record;
  record.acceleration = as_recorded(std::move(motion));
  record.interval = s.interval;
  record.component = component;
  record.axis = axis;
  if (axis == Axis::horizontal) record.azimuth = azimuth;
  record.provenance.event = fmt::format("{}; seed {}", s.title, s.seed);
  record.provenance.station = "SYN001";
  record.provenance.hypocentre = s.hypocentre;
  record.provenance.station_place = station_place(s);
  record.provenance.synthetic = true;
  return record;
}

std::string name_of(const Scenario& s, const std::string& component, const WrittenFile& file,
                    WrittenFormat format) {
  return s.id + (format == WrittenFormat::at2 ? "-" + component + ".at2" : file.suffix);
}

std::vector<Component> files_of(const Scenario& s, const std::vector<Record>& records, WrittenFormat format) {
  std::vector<Component> out;
  for (WrittenFile& file : write_records(records, format)) {
    Component c{name_of(s, file.components.front(), file, format), std::move(file.bytes), {}};
    FileText text;
    set_bytes(c.name, c.bytes, text);
    c.record = format == WrittenFormat::at2    ? read_peer_at2(text, {})
               : format == WrittenFormat::knet ? read_knet(text, {})
                                               : read_csmnc(text, {});
    out.push_back(std::move(c));
  }
  return out;
}

// Six digits: enough to recognise the motion, and the same on every machine.
double rounded(double value) {
  return parse_number(fmt::format("{:.6g}", value)).value();
}

Json file_entry(const Component& component) {
  const RecordInfo info = describe(component.record);
  return {{"name", component.name},
          {"component", component.record.component},
          {"sha256", component.record.provenance.sha256},
          {"measures",
           {{"pga", rounded(info.pga)},
            {"pgv", rounded(info.pgv)},
            {"arias", rounded(info.arias)},
            {"d5_95", rounded(info.d5_95)},
            {"psa_0.2", rounded(info.psa_0_2)},
            {"psa_0.5", rounded(info.psa_0_5)},
            {"psa_1.0", rounded(info.psa_1_0)},
            {"psa_2.0", rounded(info.psa_2_0)}}}};
}

const char* table_text(SiteTable table) {
  if (table == SiteTable::japan_500) return "Japan, Vs30 500 m/s";
  if (table == SiteTable::california_500) return "California, Vs30 500 m/s";
  return "generic rock, Vs30 760 m/s";
}

std::string plane_text(const RupturePlane& plane, const Scenario& s) {
  const FiniteFault& f = plane.fault;
  Scenario alone = s;
  alone.planes = {plane};
  std::string text = fmt::format(
      "Mw {:.3g}, {:g} x {:g} km, strike {:.3g}, dip {:.3g}, {:g} MPa, subfaults of {:g} x {:g} km with "
      "random slip, "
      "broken from ({:.3g}, {:.3g}) of its sides at {:g} beta from {:.3g} s on",
      f.magnitude, f.length * 1e-3, f.width * 1e-3, f.strike * 360.0 / two_pi, f.dip * 360.0 / two_pi,
      f.stress_drop * 1e-6, f.subfault_length * 1e-3, f.subfault_width * 1e-3, f.hypocentre_along,
      f.hypocentre_down, f.rupture_ratio, plane.onset);
  for (const Asperity& a : f.asperities)
    text += fmt::format(", {:g} times the slip in {:g} x {:g} km about ({:g}, {:g}) km", a.slip,
                        a.length * 1e-3, a.width * 1e-3, a.along * 1e-3, a.down * 1e-3);
  return text + fmt::format(", {:.3g} km away", closest_distance(alone) * 1e-3);
}

std::string how_made(const Scenario& s) {
  std::string text = fmt::format(
      "stochastic finite fault (Motazedian & Atkinson 2005; Boore 2009): beta {:g} m/s, density {:g} kg/m3, "
      "Q {:g} f^{:g}, kappa {:g} s, amplification of {} times {:g}; vertical {:.3f} of the horizontal "
      "spectrum; "
      "planes:",
      s.region.shear_velocity, s.region.density, s.region.q0, s.region.q_exponent, s.region.kappa,
      table_text(s.region.site), s.region.site_factor, s.vertical_ratio);
  for (const RupturePlane& plane : s.planes) text += " (" + plane_text(plane, s) + ")";
  return text;
}

Json entry(const Scenario& s, const std::vector<Component>& components, const Json& also) {
  Json files = Json::array();
  for (const Component& component : components) files.push_back(file_entry(component));
  return {{"id", s.id},
          {"alias", s.alias},
          {"title", s.title},
          {"synthetic", true},
          {"made_by", how_made(s)},
          {"command", "make_records records"},
          {"seed", s.seed},
          {"interval", s.interval},
          {"duration", s.duration},
          {"files", files},
          {"also", also}};
}

// The format that the name of a record stands for, then the others.
std::vector<WrittenFormat> shipped_formats(const Scenario& s) {
  if (s.alias == "wenchuan") return {WrittenFormat::at2, WrittenFormat::knet, WrittenFormat::csmnc};
  if (s.alias == "tohoku") return {WrittenFormat::knet, WrittenFormat::at2, WrittenFormat::csmnc};
  return {WrittenFormat::at2};
}

// Adds the files of a record to `out`; its entry of the catalogue.
Json ship(const Scenario& s, std::vector<ShippedFile>& out) {
  const std::vector<Record> motion = shipped_motion(s);
  std::vector<Component> first;
  Json also = Json::array();
  for (const WrittenFormat format : shipped_formats(s)) {
    std::vector<Component> components = files_of(s, motion, format);
    for (const Component& c : components) {
      out.push_back({c.name, c.bytes});
      if (!first.empty()) also.push_back({{"name", c.name}, {"sha256", c.record.provenance.sha256}});
    }
    if (first.empty()) first = std::move(components);
  }
  return entry(s, first, also);
}

}  // namespace

std::vector<Record> shipped_motion(const Scenario& s) {
  ThreeComponents motion = simulate(s);
  return {record_of(s, "EW", Axis::horizontal, 90.0, std::move(motion.east_west)),
          record_of(s, "NS", Axis::horizontal, 0.0, std::move(motion.north_south)),
          record_of(s, "UD", Axis::vertical, 0.0, std::move(motion.up_down))};
}

std::vector<ShippedFile> shipped_files() {
  std::vector<ShippedFile> out;
  Json records = Json::array();
  for (const Scenario& scenario : shipped_scenarios()) records.push_back(ship(scenario, out));
  const Json catalogue = {{"note",
                           "Synthetic motions made by this project; none of them is a recording. SI units; "
                           "PGV after removal of the mean. also: the same motion in other formats."},
                          {"records", records}};
  out.push_back({"catalogue.json", catalogue.dump(2) + "\n"});
  return out;
}

}  // namespace dougong::seismic
