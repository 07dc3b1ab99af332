#include "engine/frame.h"

#include "engine/kernels.h"
#include "engine/sine_cosine.h"

namespace dougong::engine {

void Frame::turn_to(double to) {
  const SineCosine<double> turn = sine_cosine(to);
  angle = to, s = turn.sine, c = turn.cosine;
}

void place_bodies(const Model& model, std::span<const double> q, std::span<const double> v,
                  std::span<Frame> frames, Crew& crew) {
  constexpr std::size_t share = 512;
  crew.share_range(model.body_count, share, [&](std::size_t first, std::size_t last) {
    best_kernels().place_bodies(q.data(), v.data(), model.body_count, first, last, frames.data());
  });
}

void place_terrains(const Model& model, double t, bool held_still, std::span<Frame> frames) {
  for (std::size_t j = 0; j < model.terrain_count; ++j) {
    MotionSample motion;
    if (model.motions[j]) motion = model.motions[j]->at(held_still ? 0.0 : t);
    if (held_still) motion.velocity = {};
    Frame& f = frames[model.body_count + j];
    const Vec2 p = model.terrain_position[j] + motion.displacement;
    f.x = p.x, f.y = p.y, f.vx = motion.velocity.x, f.vy = motion.velocity.y, f.spin = 0.0;
    // Terrains do not turn: a frame that was placed before has its sine and cosine.
    if (f.angle != model.terrain_angle[j]) f.turn_to(model.terrain_angle[j]);
  }
}

}  // namespace dougong::engine
