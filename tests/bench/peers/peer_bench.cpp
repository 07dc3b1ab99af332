// The wall S1 in other engines and in this one: what a simulated second costs at equal settlement.
//
//     peer_bench [CYCLES [AMPLITUDE_G [STEP_MS [NAME]]]]
//
// Every peer settles for 1 s at its fixed step, and is then shaken by whole cycles of a 2 Hz sine and left
// alone for half a second. This engine lays the same bricks of such a stiffness that they settle as far. Both
// are shaken side by side: at every output of ours the peer catches up, so that a machine that others use
// slows both and leaves the ratio alone. Processor time of one core.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string_view>

#include "engine/settle.h"
#include "tests/bench/peers/peer.h"
#include "tests/bench/sine_cycles.h"
#include "tests/scenes/running.h"

namespace dougong::peers {
namespace {

struct Settings {
  int cycles = 4;
  double amplitude = 0.3;  // g
  double step = 1e-3;      // s, of the peers
  std::string_view only;   // names that begin so
};
constexpr double frequency = 2.0;                        // Hz
constexpr double settling_time = 1.0, quiet_time = 0.5;  // s
constexpr double output_interval = 0.01;                 // s
constexpr double step_fraction = 0.9;                    // of our stability bound
constexpr const char* integrators[] = {"velocity-verlet", "symplectic-euler"};

double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

engine::Vec2 extent(const engine::Shape& shape) {
  engine::Vec2 half;
  for (const engine::Vec2 v : std::get<engine::ConvexPolygon>(shape).vertices())
    half = {std::max(half.x, v.x), std::max(half.y, v.y)};
  return 2.0 * half;
}

Wall wall_of(const engine::Scene& scene) {
  Wall wall;
  for (const engine::Body& body : scene.bodies) wall.bricks.push_back({body.position, extent(body.shape)});
  wall.ground = {scene.terrains[0].position, extent(scene.terrains[0].shape)};
  wall.density = scene.materials[0].density;
  wall.friction = scene.materials[0].friction_coefficient;
  wall.gravity = -scene.gravity.y;
  return wall;
}

/// What becomes of a wall.
struct Fate {
  double settlement = 0.0;            // m, mean of the top course
  double peak = 0.0, residual = 0.0;  // m, mean drift of the top course against the ground
  std::size_t fallen = 0;             // bricks lower by more than half their height than they settled
};

using Places = std::function<engine::Vec2(std::size_t brick)>;

class Watch {
 public:
  Watch(const Wall& wall, Places places) : wall_(wall), places_(std::move(places)) {
    const double top = wall.bricks.back().centre.y;
    while (first_ > 0 && wall.bricks[first_ - 1].centre.y == top) --first_;
  }

  const Fate& fate() const { return fate_; }

  void note_settled() {
    for (std::size_t i = 0; i < wall_.bricks.size(); ++i) settled_.push_back(places_(i));
    for (std::size_t i = first_; i < settled_.size(); ++i)
      fate_.settlement += (wall_.bricks[i].centre.y - settled_[i].y) / top_bricks();
  }

  void note(double ground) {
    double drift = 0.0;
    for (std::size_t i = first_; i < settled_.size(); ++i)
      drift += (places_(i).x - settled_[i].x - ground) / top_bricks();
    fate_.peak = std::max(fate_.peak, std::abs(drift)), fate_.residual = drift;
    fate_.fallen = 0;
    for (std::size_t i = 0; i < settled_.size(); ++i)
      fate_.fallen += settled_[i].y - places_(i).y > 0.5 * wall_.bricks[i].size.y ? 1 : 0;
  }

 private:
  double top_bricks() const { return static_cast<double>(wall_.bricks.size() - first_); }

  const Wall& wall_;
  Places places_;
  std::size_t first_ = wall_.bricks.size();  // of the top course
  std::vector<engine::Vec2> settled_;
  Fate fate_;
};

struct Costs {
  double settling = 0.0, shaken = 0.0;  // s of processor time per simulated s
};

/// A peer at its fixed step on the ground's motion: each step ends where the motion does.
class SteppedPeer {
 public:
  SteppedPeer(const PeerKind& kind, const Wall& wall, double step) : peer_(kind.build(wall)), step_(step) {}

  Places places() const {
    return [this](std::size_t brick) { return peer_->position(brick); };
  }
  double cpu() const { return cpu_; }

  void stand(double duration) {
    const double start = cpu_seconds();
    for (long i = std::lround(duration / step_); i > 0; --i) peer_->step(step_, 0.0);
    cpu_ += cpu_seconds() - start;
  }

  void follow(const engine::PrescribedMotion& motion, double until) {
    const double start = cpu_seconds();
    for (const long last = std::lround(until / step_); taken_ < last; ++taken_) {
      const double t = static_cast<double>(taken_) * step_;
      const double way = motion.at(t + step_).displacement.x - motion.at(t).displacement.x;
      peer_->step(step_, way / step_);
    }
    cpu_ += cpu_seconds() - start;
  }

 private:
  std::unique_ptr<Peer> peer_;
  double step_;       // s
  long taken_ = 0;    // steps since the motion began
  double cpu_ = 0.0;  // s
};

/// A wall of ours and a peer's, shaken side by side.
struct Duel {
  Fate peer, own;
  Costs peer_costs, own_costs;
  engine::RunOutcome run;
};

double settle(SteppedPeer& peer, Watch& watch) {
  peer.stand(settling_time);
  watch.note_settled();
  return peer.cpu() / settling_time;
}

double settle(scenes::Running& own, Watch& watch) {
  const double start = cpu_seconds();
  const engine::SettleReport report = engine::settle(own.model, own.state);
  watch.note_settled();
  return (cpu_seconds() - start) / report.duration;
}

engine::DriveOptions options_for(const Settings& settings, const char* integrator) {
  engine::DriveOptions options =
      scenes::run_for(settings.cycles / frequency + quiet_time, output_interval, integrator);
  options.step_fraction = step_fraction;
  return options;
}

/// Runs ours; the peer catches up at every output, and both are looked at.
void shake(Duel& duel, scenes::Running& own, SteppedPeer& peer, const engine::PrescribedMotion& motion,
           const engine::DriveOptions& options, const std::function<void(double ground)>& note) {
  const double start = cpu_seconds(), peer_start = peer.cpu();
  duel.run = own.run(options, [&](const engine::Sample& sample) {
    peer.follow(motion, sample.state.time);
    note(motion.at(sample.state.time).displacement.x);
    return engine::Wish::go_on;
  });
  const double both = cpu_seconds() - start, of_peer = peer.cpu() - peer_start;
  duel.peer_costs.shaken = of_peer / duel.run.end_time;
  duel.own_costs.shaken = (both - of_peer) / duel.run.end_time;
}

Duel fight(const PeerKind& kind, const char* integrator, const Settings& settings) {
  scenes::RunningBond brickwork;
  const auto motion = scenes::sine_cycles(settings.amplitude * 9.81, frequency, settings.cycles);
  const Wall wall = wall_of(scenes::running_bond(brickwork));
  Duel duel;
  SteppedPeer peer(kind, wall, settings.step);
  Watch peer_watch(wall, peer.places());
  duel.peer_costs.settling = settle(peer, peer_watch);

  brickwork.young_modulus *= scenes::settlement(brickwork) / peer_watch.fate().settlement;
  scenes::Running own(scenes::running_bond(brickwork, motion));
  Watch own_watch(wall, [&own](std::size_t brick) { return own.position(brick); });
  duel.own_costs.settling = settle(own, own_watch);

  shake(duel, own, peer, *motion, options_for(settings, integrator),
        [&](double ground) { peer_watch.note(ground), own_watch.note(ground); });
  duel.peer = peer_watch.fate(), duel.own = own_watch.fate();
  return duel;
}

void print_row(const char* name, double step, const Fate& fate, const Costs& costs, const char* rest) {
  std::printf("| %s | %.4g | %.2f | %.2f | %.2f | %zu | %.2f | %.2f | %s |\n", name, 1e6 * step,
              1e3 * fate.settlement, 1e3 * fate.peak, 1e3 * fate.residual, fate.fallen, costs.settling,
              costs.shaken, rest);
  std::fflush(stdout);
}

void compare(const PeerKind& kind, const Settings& settings) {
  for (const char* integrator : integrators) {
    const Duel duel = fight(kind, integrator, settings);
    char ratio[32];
    std::snprintf(ratio, sizeof ratio, "%.2f", duel.peer_costs.shaken / duel.own_costs.shaken);
    print_row(kind.name, settings.step, duel.peer, duel.peer_costs, "");
    print_row(integrator, duel.run.step, duel.own, duel.own_costs, ratio);
    if (duel.run.outcome != engine::Outcome::completed)
      std::printf("%s: %s\n", to_string(duel.run.outcome).c_str(), duel.run.detail.c_str());
  }
}

int run(const Settings& settings) {
  std::printf("S1 under %d cycles of %.3g g at %.3g Hz and %.3g s of rest.\n\n", settings.cycles,
              settings.amplitude, frequency, quiet_time);
  for (const PeerKind& kind : peers()) std::printf("%s: %s\n", kind.name, kind.settings);
  std::printf(
      "\n| engine | step (us) | settles by (mm) | peak drift (mm) | residual drift (mm) | fallen bricks | "
      "s/s "
      "settling | s/s shaken | times ours |\n|---|---|---|---|---|---|---|---|---|\n");
  for (const PeerKind& kind : peers())
    if (std::string_view(kind.name).starts_with(settings.only)) compare(kind, settings);
  return 0;
}

}  // namespace
}  // namespace dougong::peers

int main(int count, char** arguments) {
  dougong::peers::Settings settings;
  if (count > 1) settings.cycles = std::atoi(arguments[1]);
  if (count > 2) settings.amplitude = std::atof(arguments[2]);
  if (count > 3) settings.step = 1e-3 * std::atof(arguments[3]);
  if (count > 4) settings.only = arguments[4];
  return dougong::peers::run(settings);
}
