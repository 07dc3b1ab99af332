// What finding the contacts of the wall S1 would cost a step without the things that prune it, put in one by
// one: bounding circles, grid, skin, manifold cache, and looking only when something can have come near.
//
//     pruning_bench [ROUNDS [AMPLITUDE_G [STEPS]]]
//
// All are given the same poses: those of so many consecutive steps of the shaken wall, from 0.25 s on. The
// last is what the engine does; the others are written here with its public functions.
#include <cmath>
#include <cstdlib>

#include "tests/bench/alternate.h"
#include "tests/bench/settled_wall.h"

namespace dougong::bench {
namespace {

using engine::BodyPair;
using engine::Frame;
using Poses = std::vector<Frame>;

constexpr double settlement = 1e-3;     // m
constexpr double shaken_before = 0.25;  // s
constexpr double margin_ratio = 0.02;   // of ContactSet, over a brick's smaller width
constexpr double skin_ratio = 0.25;     // likewise

struct Film {
  engine::Model model;
  engine::State start;
  std::vector<Poses> poses;  // step by step
  double step = 0.0;         // s
  double width() const { return model.minimum_width[0]; }
  double margin() const { return margin_ratio * width(); }
};

Film filmed(double amplitude, std::size_t steps) {
  Wall wall = settle(s1_scene(settlement, amplitude));
  engine::DriveOptions options = scenes::run_for(1.0, 0.01);
  options.step_fraction = 0.9;
  const double step = engine::plan_steps(wall.model, wall.settled, options).step;
  options.output_interval = step, options.end_time = shaken_before + static_cast<double>(steps) * step;
  Film film{wall.model, wall.settled, {}, step};
  engine::drive(wall.model, wall.settled, options, [&](const engine::Sample& sample) {
    const double since = sample.state.time - shaken_before;
    if (std::abs(since) <= 0.5 * step) film.start = sample.state;
    if (since > 0.5 * step) film.poses.push_back(engine::frames_of(film.model, sample.state));
    return engine::Wish::go_on;
  });
  return film;
}

/// Per step of the film (us).
double timed(const Film& film, std::size_t steps, const std::function<void(const Poses&)>& look) {
  const std::clock_t start = std::clock();
  for (std::size_t i = 0; i < steps; ++i) look(film.poses[i]);
  return 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / static_cast<double>(steps);
}

engine::Index touched = 0;  // so that nothing of it is idle

void look_closely(const Film& film, const Poses& poses, BodyPair p) {
  touched += engine::find_manifold(film.model, poses, p.a, p.b, film.margin(), {}).count;
}

template <class Visit>
void each_pair(const Film& film, Visit visit) {
  const auto bodies = static_cast<engine::Index>(film.model.body_count);
  for (engine::Index a = 0; a < bodies; ++a)
    for (engine::Index b = a + 1; b <= bodies; ++b) visit(BodyPair{a, b});  // the ground comes last
}

bool circles_apart(const Film& film, const Poses& poses, BodyPair p) {
  if (film.model.is_terrain(p.b)) return poses[p.a].position().y > film.model.bounding_radius[p.a];
  const double reach = film.model.bounding_radius[p.a] + film.model.bounding_radius[p.b] + film.margin();
  const engine::Vec2 d = poses[p.a].position() - poses[p.b].position();
  return dot(d, d) > reach * reach;
}

double every_pair(const Film& film) {
  return timed(film, 1, [&](const Poses& poses) {
    each_pair(film, [&](BodyPair p) { look_closely(film, poses, p); });
  });
}

double with_circles(const Film& film) {
  return timed(film, 5, [&](const Poses& poses) {
    each_pair(film, [&](BodyPair p) {
      if (!circles_apart(film, poses, p)) look_closely(film, poses, p);
    });
  });
}

double with_grid(const Film& film) {
  return timed(film, std::min<std::size_t>(film.poses.size(), 50), [&](const Poses& poses) {
    for (const BodyPair p : engine::find_pairs(film.model, poses, film.margin()))
      look_closely(film, poses, p);
  });
}

// Whether any brick has gone a quarter of the skin against the ground since then.
bool moved(const Film& film, const Poses& then, const Poses& now, double skin) {
  const engine::Vec2 carried = now.back().position() - then.back().position();
  for (std::size_t i = 0; i < film.model.body_count; ++i) {
    const engine::Vec2 d = now[i].position() - then[i].position() - carried;
    const double turn = film.model.bounding_radius[i] * std::abs(now[i].angle - then[i].angle);
    if (std::abs(d.x) + std::abs(d.y) + turn > 0.25 * skin) return true;
  }
  return false;
}

double with_skin(const Film& film) {
  const double skin = skin_ratio * film.width();
  const Poses* seen = nullptr;
  std::vector<BodyPair> pairs;
  return timed(film, std::min<std::size_t>(film.poses.size(), 200), [&](const Poses& poses) {
    if (!seen || moved(film, *seen, poses, skin)) {
      pairs = engine::find_pairs(film.model, poses, skin);
      seen = &poses;
    }
    for (const BodyPair p : pairs) look_closely(film, poses, p);
  });
}

double with_manifold_cache(const Film& film) {
  engine::ContactSet contacts = film.start.contacts;
  return timed(film, film.poses.size(), [&](const Poses& poses) { contacts.update(film.model, poses); });
}

double as_the_engine_does(const Film& film) {
  engine::ContactSet contacts = film.start.contacts;
  std::size_t wait = 0;
  return timed(film, film.poses.size(), [&](const Poses& poses) {
    if (wait-- > 0) return;
    contacts.update(film.model, poses);
    wait = contacts.steps_until_update(film.model, engine::fastest_rim(film.model, poses), film.step) - 1;
  });
}

void compare(int rounds, double amplitude, std::size_t steps) {
  const Film film = filmed(amplitude, steps);
  std::vector<Contestant> searches{
      {"every pair, every step", [&] { return every_pair(film); }},
      {"+ bounding circles", [&] { return with_circles(film); }},
      {"+ grid and boxes", [&] { return with_grid(film); }},
      {"+ skin", [&] { return with_skin(film); }},
      {"+ manifold cache", [&] { return with_manifold_cache(film); }},
      {"+ waiting while nothing can have come near", [&] { return as_the_engine_does(film); }},
  };
  alternate(searches, rounds);
  std::printf("S1 at %.3g g, %zu steps of %.3g us from %.3g s on, least of %d rounds.\n\n", amplitude,
              film.poses.size(), 1e6 * film.step, shaken_before, rounds);
  print_table(searches, "finding contacts", Against::before);
}

}  // namespace
}  // namespace dougong::bench

int main(int count, char** arguments) {
  const int rounds = count > 1 ? std::atoi(arguments[1]) : 5;
  const double amplitude = count > 2 ? std::atof(arguments[2]) : 0.3;
  const int steps = count > 3 ? std::atoi(arguments[3]) : 400;
  dougong::bench::compare(rounds, amplitude, static_cast<std::size_t>(steps));
}
