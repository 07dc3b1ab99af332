// The numbers of a static analysis: CSV and JSON.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/report/csv.h"
#include "app/report/statics_report.h"
#include "app/report/text.h"
#include "app/study/version.h"

namespace dougong::app {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

std::string name_of(const StaticResult& r, std::size_t body) {
  const std::size_t blocks = r.model.blocks.size();
  return body < blocks ? r.model.blocks[body].name : r.model.terrains[body - blocks].name;
}

Json mechanism_part(const StaticResult& r, const SideResult& s) {
  Json moving = Json::array(), joints = Json::array();
  for (const std::size_t block : s.mechanism.moving) moving.push_back(name_of(r, block));
  for (const structures::MovingJoint& joint : s.mechanism.joints)
    joints.push_back({{"action", to_string(joint.action)},
                      {"between", {name_of(r, joint.a), name_of(r, joint.b)}},
                      {"place", {{"x", joint.place.x}, {"y", joint.place.y}, {"unit", "m"}}}});
  return {{"moving_blocks", moving}, {"joints", joints}};
}

Json curve_part(const StaticResult& r, const SideResult& s) {
  const structures::CapacityPoint& peak = s.curve.points[s.curve.peak()];
  Json out{{"peak_multiplier", number(peak.multiplier)},
           {"peak_base_shear", {{"value", number(peak.multiplier * r.weight)}, {"unit", "N"}}},
           {"roof_drift_at_peak", number(peak.roof / r.height)},
           {"roof_drift_at_end", number(s.curve.points.back().roof / r.height)},
           {"end", to_string(s.curve.end)},
           {"points", s.curve.points.size()},
           {"cracked_bonds", s.curve.points.back().cracked}};
  if (!s.curve.events.empty()) {
    const structures::BondEvent& first = s.curve.events.front();
    out["first_crack"] = {{"bond", r.building.scene.bonds[first.bond].name},
                          {"how", first.how},
                          {"multiplier", number(s.curve.points[first.point].multiplier)}};
  }
  return out;
}

Json side_part(const StaticResult& r, const SideResult& s) {
  Json out{{"towards", to_string(s.side)},    {"stands", number(s.found.stands)},
           {"falls", number(s.found.falls)},  {"upper_end", to_string(s.found.end)},
           {"trials", s.found.trials.size()}, {"mechanism", mechanism_part(r, s)}};
  if (!r.choice.pattern) {
    out["tilt_stands"] = {{"value", tilt_degrees(s.found.stands)}, {"unit", "deg"}};
    out["tilt_falls"] = {
        {"value", std::isfinite(s.found.falls) ? number(tilt_degrees(s.found.falls)) : Json()},
        {"unit", "deg"}};
  }
  if (!s.curve.points.empty()) out["curve"] = curve_part(r, s);
  return out;
}

}  // namespace

double tilt_degrees(double multiplier) {
  return std::atan(multiplier) * 180.0 / std::numbers::pi;
}

std::string trials_csv(const StaticResult& r) {
  std::string out =
      "towards,trial,multiplier (1),tilt (deg),result,simulated (s),watched (s),unbalanced over weight "
      "(1),greatest "
      "movement (m),"
      "moved most,kinetic energy (J),broken bond points,detail\n";
  for (const SideResult& s : r.sides)
    for (std::size_t i = 0; i < s.found.trials.size(); ++i) {
      const structures::Trial& t = s.found.trials[i];
      out += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", to_string(s.side), i + 1,
                         exact(t.multiplier), r.choice.pattern ? "" : exact(tilt_degrees(t.multiplier)),
                         to_string(t.result), exact(t.duration), exact(t.watched), exact(t.unbalanced_ratio),
                         exact(t.greatest_movement), csv_text(t.moved_most), exact(t.kinetic_energy),
                         t.broken_points, csv_text(t.detail));
    }
  return out;
}

std::string capacity_csv(const StaticResult& r) {
  std::string out =
      "towards,point,multiplier (1),base shear (N),displacement of the loads (m),roof displacement (m),roof "
      "drift (1),cracked bonds,unbalanced over weight (1)\n";
  for (const SideResult& s : r.sides)
    for (std::size_t i = 0; i < s.curve.points.size(); ++i) {
      const structures::CapacityPoint& p = s.curve.points[i];
      out += fmt::format("{},{},{},{},{},{},{},{},{}\n", to_string(s.side), i, exact(p.multiplier),
                         exact(p.multiplier * r.weight), exact(p.displacement), exact(p.roof),
                         exact(p.roof / r.height), p.cracked, exact(p.unbalanced_ratio));
    }
  return out;
}

std::string bond_events_csv(const StaticResult& r) {
  std::string out = "towards,order,bond,how,point,multiplier (1),roof displacement (m)\n";
  for (const SideResult& s : r.sides)
    for (std::size_t i = 0; i < s.curve.events.size(); ++i) {
      const structures::BondEvent& e = s.curve.events[i];
      const structures::CapacityPoint& p = s.curve.points[e.point];
      out += fmt::format("{},{},{},{},{},{},{}\n", to_string(s.side), i + 1,
                         csv_text(r.building.scene.bonds[e.bond].name), e.how, e.point, exact(p.multiplier),
                         exact(p.roof));
    }
  return out;
}

std::string mechanism_csv(const StaticResult& r) {
  std::string out = "towards,block,moves,translation x (m),translation y (m),turn (rad)\n";
  for (const SideResult& s : r.sides)
    for (std::size_t i = 0; i < s.found.mechanism.size(); ++i) {
      const structures::BlockMotion& m = s.found.mechanism[i];
      const bool moves = std::ranges::find(s.mechanism.moving, i) != s.mechanism.moving.end();
      out += fmt::format("{},{},{},{},{},{}\n", to_string(s.side), csv_text(r.model.blocks[i].name),
                         moves ? 1 : 0, exact(m.translation.x), exact(m.translation.y), exact(m.turn));
    }
  return out;
}

std::string statics_json(const StaticResult& r, const std::string& command) {
  Json sides = Json::array();
  for (const SideResult& s : r.sides) sides.push_back(side_part(r, s));
  Json out{{"analysis", kind_of(r.choice)}, {"layout", r.model.layout}, {"interrupted", r.interrupted}};
  if (r.choice.pattern) out["pattern"] = to_string(*r.choice.pattern);
  out["weight"] = {{"value", r.weight}, {"unit", "N"}};
  out["height"] = {{"value", r.height}, {"unit", "m"}};
  out["precision"] = r.choice.precision;
  out["sides"] = std::move(sides);
  out["command"] = command;
  out["version"] =
      fmt::format("dougong {} ({}, {})", program_version(), program_git_hash(), program_compiler());
  return out.dump(2) + "\n";
}

}  // namespace dougong::app
