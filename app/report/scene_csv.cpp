#include "app/report/csv.h"
#include "app/report/scene_report.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

struct Wanted {
  bool position, velocity, acceleration;
};

std::string head(const Wanted& wanted) {
  std::string text = "time (s),body";
  if (wanted.position) text += ",x (m),y (m),angle (rad)";
  if (wanted.velocity) text += ",velocity x (m/s),velocity y (m/s),spin (rad/s)";
  if (wanted.acceleration)
    text += ",acceleration x (m/s2),acceleration y (m/s2),angular acceleration (rad/s2)";
  return text + "\n";
}

std::string three(double a, double b, double c) {
  return "," + exact(a) + "," + exact(b) + "," + exact(c);
}

std::string row(const SceneResult& r, const Wanted& wanted, std::size_t step, std::size_t body) {
  const structures::Trajectory& t = r.run.trajectory;
  const std::size_t at = step * t.blocks + body;
  std::string text = exact(t.times[step]) + "," + csv_text(r.run.model.blocks[body].name);
  if (wanted.position) text += three(t.position(step, body).x, t.position(step, body).y, t.angle(step, body));
  if (wanted.velocity) text += three(r.velocities[at].x, r.velocities[at].y, r.spins[at]);
  if (wanted.acceleration)
    text += three(r.accelerations[at].x, r.accelerations[at].y, r.angular_accelerations[at]);
  return text + "\n";
}

}  // namespace

std::string bonds_csv(const SceneResult& result) {
  const auto time = [](double t) { return t < DrawnBond::never ? exact(t) : std::string(); };
  std::string text = "bond,cracked (s),crushed (s),broken (s)\n";
  for (const DrawnBond& bond : result.run.model.bonded)
    text += csv_text(bond.name) + "," + time(bond.cracked) + "," + time(bond.crushed) + "," +
            time(bond.broken) + "\n";
  return text;
}

std::string bodies_csv(const SceneResult& result) {
  const Wanted wanted{keeps(result, "position"), keeps(result, "velocity"), keeps(result, "acceleration")};
  std::string text = head(wanted);
  const std::vector<std::size_t> bodies = kept_bodies(result);
  for (std::size_t step = 0; step < result.run.trajectory.times.size(); ++step)
    for (const std::size_t body : bodies) text += row(result, wanted, step, body);
  return text;
}

}  // namespace dougong::app
