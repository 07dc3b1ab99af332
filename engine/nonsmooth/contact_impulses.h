// Impulses of rigid contacts over one step of Moreau and Jean's scheme: from contact points at the mid-step's
// places to bodies' velocities at its end.
//
// What each point asks for, with g its gap and s its slip since it stuck, at t + h/2:
//     the gap at the next mid-step      g + h u_N >= -overlap kept        b_N = (g + overlap kept)/h
//     its slip there, while it sticks   s + h u_T  = 0                    b_T = s/h
// so that what one step errs the next makes good, at the level of positions: nothing sinks or creeps.
//
// A point that comes faster than twice what gravity gives in a step is left alone until the mid-step nearest
// to its impact, and then rebounds by Newton's law, u_N+ >= -e u_N-. Such a step has three parts: half of the
// smooth forces, the impacts alone, the other half; the contacts that last bear what they must in each. What
// the impact left of gap or overlap, at most half a step's way, is kept until the point opens: closing it
// would make or take energy. So is an overlap that a scene starts with. Slower points use up their gap and
// rest at zero. Newton's law with friction can make energy in an impact off the centre (Kane, 1984); where it
// would, all impacts of that step are plastic.
//
// The points remember (PointHistory, PointPast): the place they stick at; `overlap`, the one that they keep;
// `dashpot` and `friction`, their mean forces over the last step, the next step's first guess.
// Moreau, in Moreau and Panagiotopoulos (eds.), Nonsmooth Mechanics and Applications (1988); Jean, Comput.
// Methods Appl. Mech. Engrg. 177 (1999) 235-257; Anitescu and Potra, Nonlinear Dynamics 14 (1997) 231-247,
// on gaps as bounds of velocities.
#pragma once

#include "engine/integrators/integrator.h"
#include "engine/nonsmooth/impulse_solver.h"
#include "engine/state.h"

namespace dougong::engine {

/// What the solver did since the start of a run.
struct ImpulseStatistics {
  std::size_t solves = 0, iterations = 0, most_iterations = 0;
  double worst_residual = 0.0;      // -, over the speed of the fastest body and of a step of gravity
  std::size_t plastic_instead = 0;  // steps in which restitution would have made energy
};

class ContactImpulses {
 public:
  explicit ContactImpulses(const Model& model);

  /// `frames` hold mid-step places and, of terrains, mean velocities from here to the next mid-step;
  /// `terrains_before` their velocities at the step's start. `before` are the bodies' velocities then; `v`
  /// those at its end without impulses, to which they are added. Returns the works over the step in place of
  /// powers (J).
  Powers apply(ContactPoints& points, std::span<const Frame> frames, double h,
               std::span<const Vec2> terrains_before, std::span<const double> before, std::span<double> v);
  /// Mean forces over the last step, from what the points remember.
  static void mean_forces(const ContactPoints& points, std::span<const Frame> frames,
                          std::span<PairLoad> loads);

  /// Empty, or why no impulses were found.
  const std::string& trouble() const { return trouble_; }
  const ImpulseStatistics& statistics() const { return statistics_; }
  /// Deepest overlap over the smaller body's width at the last step, and its point.
  double deepest_ratio() const { return deepest_ratio_; }
  std::size_t deepest_point() const { return deepest_point_; }

 private:
  struct Approach {
    double gap = 0.0;                   // m, above the overlap that is kept
    double overlap = 0.0;               // m
    double slip = 0.0, position = 0.0;  // m, of PointGeometry
    Vec2 before;                        // m/s, relative velocity at the step's start
    double restitution = 0.0;           // -
    Vec2 guess, total;                  // N s, over the step, along normal and tangent
    bool fast = false, impact = false;  // comes too fast to rest; and meets here
  };

  void read_velocities(std::span<const Frame> frames, std::span<const Vec2> terrains_before,
                       std::span<const double> before, std::span<const double> v);
  void collect(const ContactPoints& points, std::span<const Frame> frames, double h);
  static ImpulsePoint point_of(const ContactPoints& points, std::size_t i, const PointGeometry& g);
  Approach approach_of(const ContactPoints& points, const ImpulsePoint& point, const PointGeometry& g,
                       double h) const;
  double restitution_of(Index corner, Index edge) const;
  enum class Stage { before_impacts, impacts, after_impacts };
  void set_biases(double h, Stage stage, bool plastic);
  void guess(double part);
  void add_to_total();
  void give_half();
  void solve_whole(double h);
  void solve_with_impacts(double h);
  double speed_scale(double h) const;
  bool solve(double h);
  double work_gained() const;
  double input_of(const ImpulsePoint& point, Vec2 total) const;
  void commit_point(ContactPoints& points, const ImpulsePoint& point, const Approach& approach, Vec2 after,
                    double h) const;
  Powers commit(ContactPoints& points, std::span<const Frame> frames, double h);

  const Model& model_;
  std::vector<double> restitution_;  // by two material indices
  ImpulseProblem problem_;
  ImpulseSolver solver_;
  std::vector<PlaneVelocity> before_, given_;  // at the step's start, and what smooth forces add
  std::vector<Approach> approaches_;           // of the problem's points
  ImpulseStatistics statistics_;
  double deepest_ratio_ = 0.0;
  double last_step_ = 0.0;  // s
  std::size_t deepest_point_ = 0;
  std::string trouble_;
};

}  // namespace dougong::engine
