// What a tradeoff measures errors by: the most trustworthy run that can be had, how far it can be trusted,
// and how far runs that begin almost alike part.
//
// Candidates are what the dial takes for "reference", RK4 and velocity Verlet, finer than anything in the
// ladder. Each is run twice, the second time twice as coarse (a tolerance ten times as large). The one whose
// two runs agree best is the reference, and their distance is what it resolves: smaller errors are not
// errors. For a method of order p the reference itself errs by 1/(2^p - 1) of it (Richardson), so this is the
// safe side.
#pragma once

#include "app/study/tradeoff/distance.h"
#include "app/study/tradeoff/ladder.h"
#include "app/study/tradeoff/trial.h"

namespace dougong::app {

struct Reference {
  Trial run, coarser;       // a run that did not complete: there is none, and it says why
  double difference = 0.0;  // m, D between the two
};

/// Candidates in the order they are tried: what is finest of each, within the ladder's choice.
std::vector<Way> reference_candidates(const LadderChoice& completed, double stiffness,
                                      const PreparedScene& scene);
/// The best of them. `limits` hold for each run.
Reference make_reference(const std::vector<Way>& candidates, const PreparedScene& scene, const Yardstick& by,
                         const TrialLimits& limits);

/// How sensitive the motion is: members start with other velocities, each component (ρ times the spin) off by
/// `perturbation` times `speed` times a number from -1 to 1. Positions stay, so that nothing is pressed
/// together that was not.
struct Ensemble {
  double perturbation = 1e-6;       // -
  std::vector<double> differences;  // m, D of each member from the unperturbed run
  std::size_t failed = 0;
  double spread() const;  // m, rms of them
};
Ensemble make_ensemble(std::size_t members, const Trial& unperturbed, double speed,
                       const PreparedScene& scene, const Yardstick& by, const TrialLimits& limits);

}  // namespace dougong::app
