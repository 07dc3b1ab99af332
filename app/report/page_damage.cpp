// The section of the report on bonds: which cracked and broke, where, how and when.
#include <algorithm>
#include <map>

#include "app/report/page.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

constexpr std::size_t listed = 20;  // of the first cracks; damage.csv has all

double first_damage(const DrawnBond& bond) {
  return std::min(bond.cracked, bond.crushed);
}

std::vector<const DrawnBond*> in_order_of_cracking(const RunResult& run) {
  std::vector<const DrawnBond*> cracked;
  for (const DrawnBond& bond : run.model.bonded)
    if (first_damage(bond) < DrawnBond::never) cracked.push_back(&bond);
  std::ranges::stable_sort(cracked, {}, [](const DrawnBond* bond) { return first_damage(*bond); });
  return cracked;
}

struct Damage {
  std::size_t bonds = 0, tension = 0, shear = 0, yield = 0, crushed = 0, broken = 0;
};

std::map<std::string, Damage> damage_by_storey(const RunResult& run) {
  std::map<std::string, Damage> damage;
  for (const DrawnBond& bond : run.model.bonded) {
    Damage& d = damage[storey_of(run.model, bond)];
    ++d.bonds;
    d.tension += bond.mode == "tension", d.shear += bond.mode == "shear", d.yield += bond.mode == "yield";
    d.crushed += bond.crushed < DrawnBond::never;
    d.broken += bond.broken < DrawnBond::never;
  }
  return damage;
}

Html storeys_table(const RunResult& run) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& [storey, d] : damage_by_storey(run))
    rows.push_back({storey.empty() ? "none" : storey, std::to_string(d.bonds), std::to_string(d.tension),
                    std::to_string(d.shear), std::to_string(d.yield), std::to_string(d.crushed),
                    std::to_string(d.broken)});
  return table(
      "Bonds by storey: how they cracked first, how many were crushed, and how many torn through in the end",
      {{"Storey", "", false},
       {"Bonds", ""},
       {"Tension", ""},
       {"Shear", ""},
       {"Yield", ""},
       {"Crushed", ""},
       {"Broken", ""}},
      rows);
}

std::string time_of(double t) {
  return t < DrawnBond::never ? fixed(t, 2) : "";
}

Html first_cracks(const RunResult& run, const std::vector<const DrawnBond*>& cracked) {
  std::vector<std::vector<std::string>> rows;
  for (const DrawnBond* bond : cracked) {
    if (rows.size() == listed) break;
    rows.push_back({bond->name, storey_of(run.model, *bond), bond->mode, time_of(bond->cracked),
                    time_of(bond->crushed), time_of(bond->broken)});
  }
  return table("In order of time, at the output times" +
                   (cracked.size() > listed ? "; the first " + std::to_string(listed) : std::string()),
               {{"Bond", "", false},
                {"Storey", "", false},
                {"Mode", "", false},
                {"Cracked", "s"},
                {"Crushed", "s"},
                {"Broken", "s"}},
               rows);
}

}  // namespace

Html page_damage(const RunResult& run, const std::vector<Picture>& pictures) {
  if (run.model.bonded.empty()) return paragraph("Nothing is bonded in this building.");
  const auto cracked = in_order_of_cracking(run);
  if (cracked.empty())
    return paragraph("None of " + plural(run.model.bonded.size(), "bond") +
                     " cracked, yielded or was crushed.");
  return paragraph(std::to_string(cracked.size()) + " of " + plural(run.model.bonded.size(), "bond") +
                   " cracked, yielded or were crushed. All are in damage.csv.") +
         figure_named(pictures, "figures/damage.svg",
                      "When each bond left its elastic range; pale: it did not.",
                      {"figures/damage.svg", "figures/damage.png", "damage.csv"}) +
         storeys_table(run) + first_cracks(run, cracked);
}

}  // namespace dougong::app
