#include "seismic/synthesis/shipped.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "seismic/constants.h"
#include "seismic/describe.h"
#include "seismic/formats/file_text.h"
#include "seismic/formats/knet.h"
#include "seismic/formats/peer_at2.h"
#include "seismic/numerics/parse_number.h"
#include "seismic/synthesis/scenario.h"

namespace dougong::seismic {
namespace {

using Json = nlohmann::ordered_json;

constexpr double recorder_step = 1e-6 * standard_gravity;  // m/s2, of the AT2 files
constexpr double knet_scale_gal = 3920.0;                  // the scale of K-NET instruments
constexpr long knet_scale_counts = 6182761;

struct Component {
  std::string name;  // of the file
  std::string bytes;
  Record record;  // as a reader sees it
};

std::string at2_bytes(const Scenario& s, const std::string& component, std::vector<double> motion) {
  for (double& a : motion) a = std::round(a / recorder_step) * recorder_step;
  return write_peer_at2({"SYNTHETIC motion made by dougong, not a recording", s.title, "undated",
                         fmt::format("station SYN1 (invented; seed {})", s.seed), component, s.interval,
                         std::move(motion)});
}

std::string knet_bytes(const Scenario& s, const std::string& direction, const std::vector<double>& motion) {
  KnetSheet sheet;
  sheet.origin_time = sheet.record_time = "2011/03/11 00:00:00";
  sheet.latitude = "38.1";
  sheet.longitude = "142.9";
  sheet.depth = "24";
  sheet.magnitude = "9.0";
  sheet.station_code = "SYN001";
  sheet.station_latitude = "38.4000";
  sheet.station_longitude = "141.2000";
  sheet.station_height = "10";
  sheet.direction = direction;
  sheet.memo = fmt::format("SYNTHETIC motion made by dougong, not a recording; seed {}", s.seed);
  sheet.sampling_frequency = static_cast<int>(std::lround(1.0 / s.interval));
  sheet.scale_gal = knet_scale_gal;
  sheet.scale_counts = knet_scale_counts;
  const double count = knet_scale_gal / static_cast<double>(knet_scale_counts) * 0.01;  // m/s2
  for (const double a : motion) sheet.counts.push_back(std::lround(a / count));
  return write_knet(sheet);
}

Component read_back(std::string name, std::string bytes,
                    Record (*read)(const FileText&, const ReadOptions&)) {
  Component out{std::move(name), std::move(bytes), {}};
  FileText text;
  set_bytes(out.name, out.bytes, text);
  out.record = read(text, {});
  return out;
}

std::vector<Component> at2_files(const Scenario& s) {
  const ThreeComponents motion = simulate(s);
  std::vector<Component> out;
  const auto add = [&](const char* component, const std::vector<double>& a) {
    out.push_back(read_back(s.id + "-" + component + ".at2", at2_bytes(s, component, a), read_peer_at2));
  };
  add("EW", motion.east_west);
  add("NS", motion.north_south);
  add("UD", motion.up_down);
  return out;
}

std::vector<Component> knet_files(const Scenario& s) {
  const ThreeComponents motion = simulate(s);
  std::vector<Component> out;
  const auto add = [&](const char* suffix, const char* direction, const std::vector<double>& a) {
    out.push_back(read_back(s.id + "." + suffix, knet_bytes(s, direction, a), read_knet));
  };
  add("EW", "E-W", motion.east_west);
  add("NS", "N-S", motion.north_south);
  add("UD", "U-D", motion.up_down);
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

std::string fault_text(const Scenario& s) {
  const FiniteFault& f = *s.fault;
  return fmt::format(
      "a fault of {:g} x {:g} km, dip {:.3g} degrees, stress drop {:g} MPa, in subfaults of {:g} km with "
      "random slip, broken from its middle at {:g} beta; the site {:g} km beside it and {:g} km along it",
      f.length * 1e-3, f.width * 1e-3, f.dip * 360.0 / two_pi, f.stress_drop * 1e-6, f.subfault_length * 1e-3,
      f.rupture_ratio, std::abs(s.site.east) * 1e-3, s.site.north * 1e-3);
}

std::string patches_text(const Scenario& s) {
  std::string text = "patches (Mw, stress drop MPa, distance km, onset s):";
  for (const PointSource& p : s.patches)
    text += fmt::format(" ({:g}, {:g}, {:g}, {:g})", p.magnitude, p.stress_drop * 1e-6, p.distance * 1e-3,
                        p.onset);
  return text;
}

std::string how_made(const Scenario& s) {
  return fmt::format(
      "{}: beta {:g} m/s, density {:g} kg/m3, Q {:g} f^{:g}, kappa {:g} s, generic rock (Vs30 760 m/s) "
      "amplification times "
      "{:g}; {}; vertical {:.3f} of the horizontal spectrum",
      s.fault ? "stochastic finite fault (Motazedian & Atkinson 2005; Boore 2009)"
              : "stochastic point sources (Boore 2003) summed in time",
      s.region.shear_velocity, s.region.density, s.region.q0, s.region.q_exponent, s.region.kappa,
      s.region.site_factor, s.fault ? fault_text(s) : patches_text(s), s.vertical_ratio);
}

Json entry(const Scenario& s, const std::vector<Component>& components) {
  Json files = Json::array();
  for (const Component& component : components) files.push_back(file_entry(component));
  return {{"id", s.id},        {"alias", s.alias},       {"title", s.title},
          {"synthetic", true}, {"made_by", how_made(s)}, {"command", "make_records records"},
          {"seed", s.seed},    {"interval", s.interval}, {"duration", s.duration},
          {"files", files}};
}

}  // namespace

std::vector<ShippedFile> shipped_files() {
  std::vector<ShippedFile> out;
  Json records = Json::array();
  const auto add = [&](const Scenario& scenario, const std::vector<Component>& components) {
    for (const Component& component : components) out.push_back({component.name, component.bytes});
    records.push_back(entry(scenario, components));
  };
  for (const Scenario& scenario : shipped_scenarios())
    add(scenario, scenario.alias == "tohoku" ? knet_files(scenario) : at2_files(scenario));
  const Json catalogue = {{"note",
                           "Synthetic motions made by this project; none of them is a recording. SI units; "
                           "PGV after removal of the mean."},
                          {"records", records}};
  out.push_back({"catalogue.json", catalogue.dump(2) + "\n"});
  return out;
}

}  // namespace dougong::seismic
