#include <algorithm>

#include "app/report/csv.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

std::string row_of(const std::string& name, const EnsembleMember& member) {
  std::string row = name + "," + (member.done ? structures::to_string(member.verdict) : "not run to its end");
  for (const double value : member.values) row += "," + exact(value);
  return row + "\n";
}

std::string name_of(std::size_t member) {
  return member == 0 ? "as described" : "run " + std::to_string(member);
}

std::string cell(const EnsembleMember& member, std::size_t k) {
  return "," + (k < member.roof_drift.size() ? exact(member.roof_drift[k]) : std::string());
}

}  // namespace

std::string ensemble_csv(const EnsembleSheet& e) {
  std::string out = "run,verdict";
  for (std::size_t i = 0; i < e.metrics.size(); ++i)
    out += "," + csv_text(e.metrics[i] + " (" + e.units[i] + ")");
  out += "\n";
  for (std::size_t i = 0; i < e.members.size(); ++i) out += row_of(name_of(i), e.members[i]);
  return e.half_step.done ? out + row_of("half the step", e.half_step) : out;
}

std::string ensemble_roof_drift_csv(const EnsembleSheet& e) {
  std::string out = "time (s)";
  const EnsembleMember* longest = &e.half_step;
  for (std::size_t i = 0; i < e.members.size(); ++i) {
    out += "," + name_of(i) + " (1)";
    if (e.members[i].roof_times.size() > longest->roof_times.size()) longest = &e.members[i];
  }
  out += ",half the step (1)\n";
  for (std::size_t k = 0; k < longest->roof_times.size(); ++k) {
    out += exact(longest->roof_times[k]);
    for (const EnsembleMember& member : e.members) out += cell(member, k);
    out += cell(e.half_step, k) + "\n";
  }
  return out;
}

}  // namespace dougong::app
