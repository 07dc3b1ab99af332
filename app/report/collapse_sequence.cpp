#include "app/report/collapse_sequence.h"

#include <algorithm>

#include "app/report/csv.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

std::string block_name(const RunResult& run, std::size_t block) {
  return block < run.model.blocks.size() ? run.model.blocks[block].name : "block " + std::to_string(block);
}

std::string storey_of_block(const RunResult& run, std::size_t block) {
  const int storey = block < run.model.blocks.size() ? run.model.blocks[block].storey : -1;
  return storey < 0 ? "" : run.model.storeys.at(static_cast<std::size_t>(storey)).name;
}

std::string reason_of(const RunResult& run, std::size_t block) {
  const auto& losses = run.response.losses;
  const auto found = std::ranges::find(losses, block, &structures::BlockLoss::block);
  return found == losses.end() ? "" : found->reason;
}

void add_bonds(const RunResult& run, std::vector<CollapseEvent>& events) {
  for (const DrawnBond& bond : run.model.bonded) {
    const std::string storey = storey_of(run.model, bond);
    if (bond.cracked < DrawnBond::never)
      events.push_back({bond.cracked, "bond cracked", bond.name, storey, bond.mode});
    if (bond.crushed < DrawnBond::never)
      events.push_back({bond.crushed, "bond crushed", bond.name, storey, ""});
    if (bond.broken < DrawnBond::never) events.push_back({bond.broken, "bond broke", bond.name, storey, ""});
  }
}

std::string row(const std::vector<std::string>& cells) {
  std::string text;
  for (const std::string& cell : cells) text += (text.empty() ? "" : ",") + csv_text(cell);
  return text + "\n";
}

}  // namespace

std::vector<CollapseEvent> collapse_sequence(const RunResult& run) {
  std::vector<CollapseEvent> events;
  add_bonds(run, events);
  for (const structures::Fall& fall : run.collapse.falls)
    events.push_back({fall.support_lost, "support lost", block_name(run, fall.block),
                      storey_of_block(run, fall.block), reason_of(run, fall.block)});
  for (const structures::StoreyResponse& storey : run.response.storeys)
    if (storey.lost_at)
      events.push_back({*storey.lost_at, "storey lost", storey.name, storey.name, storey.lost_because});
  std::ranges::stable_sort(events, {}, &CollapseEvent::time);
  return events;
}

std::string collapse_sequence_csv(const RunResult& run) {
  std::string text = "time (s),event,where,storey,how\n";
  for (const CollapseEvent& e : collapse_sequence(run))
    text += row({exact(e.time), e.what, e.where, e.storey, e.how});
  return text;
}

std::string falls_csv(const RunResult& run) {
  std::string text = "block,storey,how,support lost (s),hardest hit (s),speed (m/s),energy (J)\n";
  for (const structures::Fall& f : run.collapse.falls)
    text += row({block_name(run, f.block), storey_of_block(run, f.block), reason_of(run, f.block),
                 exact(f.support_lost), exact(f.hit), exact(f.speed), exact(f.energy)});
  return text;
}

std::string mass_lost_csv(const RunResult& run) {
  std::vector<std::string> cells{"time (s)"};
  for (const auto& storey : run.response.storeys) {
    cells.push_back(storey.name + " mass lost (kg)");
    cells.push_back(storey.name + " mass lost (1)");
  }
  std::string text = row(cells);
  for (std::size_t k = 0; k < run.response.times.size(); ++k) {
    cells = {exact(run.response.times[k])};
    for (const auto& storey : run.response.storeys) {
      cells.push_back(exact(storey.mass_lost[k] * storey.original_mass));
      cells.push_back(exact(storey.mass_lost[k]));
    }
    text += row(cells);
  }
  return text;
}

}  // namespace dougong::app
