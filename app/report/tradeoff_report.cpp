#include "app/report/tradeoff_report.h"

#include <cmath>

#include "app/report/csv.h"
#include "app/report/safe_file.h"
#include "app/report/text.h"
#include "app/study/scene_file.h"

namespace dougong::app {
namespace {

constexpr const char* head =
    "kind,integrator,stiffness,step fraction (1),step asked (s),tolerance (1),status,reason,error (1),"
    "numerical error (1),model error (1),cpu (s),cpu per simulated second (1),simulated (s),"
    "smallest step (s),steps,evaluations,recommended\n";

std::string cell(double value) {
  return "," + (std::isfinite(value) ? exact(value) : std::string());
}
std::string cell(const std::optional<double>& value) {
  return value ? cell(*value) : std::string(",");
}

struct Errors {
  double total, numerical, model;
};

std::string row(const std::string& kind, const Trial& t, const Errors& errors, bool recommended) {
  const std::string stiffness = t.way.stiffness == rigid ? "rigid" : exact(t.way.stiffness);
  return kind + "," + t.way.solve.integrator + "," + stiffness + cell(t.way.solve.step_fraction) +
         cell(t.way.solve.step) + cell(t.way.solve.tolerance) + "," + std::string(to_string(t.status)) + "," +
         csv_text(t.reason) + cell(errors.total) + cell(errors.numerical) + cell(errors.model) + cell(t.cpu) +
         cell(t.cpu_per_second()) + cell(t.simulated) + cell(t.step) + "," + std::to_string(t.steps) + "," +
         std::to_string(t.evaluations) + "," + (recommended ? "1" : "0") + "\n";
}

double model_error(const Tradeoff& tradeoff, double stiffness) {
  for (const TradeoffModel& model : tradeoff.models)
    if (model.stiffness == stiffness) return model.error;
  return std::numeric_limits<double>::quiet_NaN();
}

std::string member_row(const Trial& unperturbed, double error) {
  Trial member;
  member.way = unperturbed.way;
  member.status = TrialStatus::completed;
  member.simulated = unperturbed.simulated;
  return row("member", member, {error, error, 0.0}, false);
}

}  // namespace

std::string tradeoff_csv(const Tradeoff& tradeoff) {
  std::string text = head;
  const auto best = tradeoff.recommended();
  for (std::size_t i = 0; i < tradeoff.trials.size(); ++i) {
    const JudgedTrial& t = tradeoff.trials[i];
    text += row(i == tradeoff.own ? "as described" : "run", t,
                {t.error, t.numerical, model_error(tradeoff, t.way.stiffness)}, best == i);
  }
  for (const TradeoffModel& model : tradeoff.models)
    text += row("reference", model.reference, {model.error, model.resolution, model.error}, false);
  for (const double difference : tradeoff.ensemble.differences)
    text += member_row(tradeoff.models.front().reference, difference / tradeoff.motion);
  return text;
}

std::vector<std::string> write_tradeoff(const Tradeoff& tradeoff, const SceneDescription& description,
                                        const std::filesystem::path& directory) {
  write_file(directory / "tradeoff.csv", tradeoff_csv(tradeoff));
  write_file(directory / "scene.toml", to_toml(description));
  const DrawnFigure figure = draw(tradeoff_figure(tradeoff));
  write_file(directory / "tradeoff.svg", figure.svg);
  write_file(directory / "tradeoff.png", figure.png);
  return {"tradeoff.csv", "tradeoff.png", "tradeoff.svg", "scene.toml"};
}

}  // namespace dougong::app
