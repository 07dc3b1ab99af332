#include "app/study/scenario_keys.h"

#include <algorithm>
#include <numbers>

#include "structures/code_screen.h"

namespace dougong::app {
namespace {

using enum Dimension;

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double tiny = 1e-9;  // least of what must be above zero
constexpr double half_turn = std::numbers::pi;

template <auto Section, auto Member>
Slot slot(Scenario& scenario) {
  return &(scenario.*Section.*Member);
}

template <auto Member>
Slot perturbation(Scenario& scenario) {
  return &(scenario.ensemble.perturbation.*Member);
}

using S = Scenario;
using R = RecordChoice;
using C = Conditioning;
using V = SolveChoice;
using G = ScreeningChoice;
using E = EnsembleChoice;
using P = Perturbation;
using O = OutputChoice;
using L = structures::LossCriteria;
using J = structures::VerdictCriteria;

ScenarioKey text(const char* name, Slot (*slot)(S&), const char* meaning,
                 std::vector<std::string> choices = {}) {
  return {{.name = name, .meaning = meaning, .choices = std::move(choices)}, slot};
}

ScenarioKey flag(const char* name, Slot (*slot)(S&), const char* meaning) {
  return {{.name = name, .meaning = meaning, .choices = {}}, slot};
}

ScenarioKey number(const char* name, Slot (*slot)(S&), Dimension dimension, double least, double most,
                   const char* meaning) {
  return {{name, meaning, dimension, least, most, {}}, slot};
}

std::vector<std::string> structure_words() {
  std::vector<std::string> words{"automatic", "none"};
  for (const std::string_view type : structures::structural_types()) words.emplace_back(type);
  return words;
}

std::vector<ScenarioKey> make_table() {
  return {
      text("layout.name", slot<&S::layout, &LayoutChoice::name>,
           "the building; the layout's own parameters are keys of this section too (docs/layouts.md)"),

      text("layout.file", slot<&S::layout, &LayoutChoice::file>,
           "a building by hand, a scene file that lists its storeys (docs/scene.md); instead of layout.name"),
      text("on.name", slot<&S::on, &ItemChoice::name>,
           "a layout that stands on a floor of the building, its parameters are keys of this section; empty: "
           "none"),
      number("on.level", slot<&S::on, &ItemChoice::level>, count, 1, 1e4,
             "the floor, counted from the ground up"),
      number("on.place", slot<&S::on, &ItemChoice::place>, length, -1e5, 1e5,
             "where its middle stands, from the middle of the building"),

      text("beside.name", slot<&S::beside, &NeighbourChoice::name>,
           "a layout on the right of the building, its parameters are keys of this section; empty: none"),
      number("beside.gap", slot<&S::beside, &NeighbourChoice::gap>, length, 0, 1e4,
             "between the two, where they are nearest; they may pound"),

      text("record.file", slot<&S::record, &R::file>, "an accelerogram, by its path; or give record.name"),
      text("record.name", slot<&S::record, &R::name>, "a record of the catalogue; or give record.file"),
      text("record.component", slot<&S::record, &R::component>,
           "the component that drives the ground to the side; empty: that of the file"),
      text("record.station", slot<&S::record, &R::station>, "the station, of a file that holds several"),
      text("record.member", slot<&S::record, &R::member>,
           "the file to read in an archive (.zip, .tar.gz), by its name; empty: all of it"),
      text("record.response", slot<&S::record, &R::response>,
           "StationXML with the sensitivity of miniSEED counts; empty: NET.STA.xml beside the file, if any"),
      flag("record.vertical", slot<&S::record, &R::vertical>, "the vertical component drives the ground too"),
      text("record.format", slot<&S::record, &R::format>,
           "id of the file's format; empty: found from its content"),
      text("record.units", slot<&S::record, &R::units>,
           "unit of the values (g, gal, cm/s2, m/s2, mm/s2, counts), for a file that does not say"),
      number("record.interval", slot<&S::record, &R::interval>, time, tiny, 10,
             "time between samples, for a file that does not say"),
      text("record.count_scale", slot<&S::record, &R::count_scale>,
           "gal per count as K-NET writes it, 3920/6182761, for a file in counts that does not say"),
      number("record.pga", slot<&S::record, &R::pga>, acceleration, tiny, 1e3,
             "peak ground acceleration that the horizontal component is scaled to; none: as recorded"),
      number("record.scale", slot<&S::record, &R::scale>, ratio, -1e6, 1e6,
             "factor on the record, instead of record.pga"),
      text("record.design_spectrum", slot<&S::record, &R::design_spectrum>,
           "a spectrum of a standard to draw beside the motion's, in the words of docs/records.md, "
           "\"ec8: type=1, ground=C, ag=0.25 g\""),

      text("conditioning.offset", slot<&S::conditioning, &C::offset>,
           "constant taken off the samples: of the whole record, of its start, or none",
           {"mean", "pre-event", "keep"}),
      number("conditioning.pre_event", slot<&S::conditioning, &C::pre_event>, time, tiny, 1e4,
             "the start of the record whose mean pre-event takes off: before the first wave"),
      text("conditioning.baseline", slot<&S::conditioning, &C::baseline>, "what is fitted and taken off",
           {"none", "acceleration-line", "velocity-parabola", "acceleration-polynomial",
            "velocity-polynomial"}),
      number("conditioning.baseline_degree", slot<&S::conditioning, &C::baseline_degree>, count, 0, 6,
             "of the polynomials of acceleration or of velocity, the latter without a constant, from 1"),
      number("conditioning.taper", slot<&S::conditioning, &C::taper>, ratio, 0, 0.5,
             "length of the cosine taper at each end, as a part of the duration"),
      number("conditioning.pad", slot<&S::conditioning, &C::pad>, time, 0, 1e4,
             "zeros added at each end; none: what the filter needs"),
      flag("conditioning.filter", slot<&S::conditioning, &C::filter>, "Butterworth band-pass"),
      number("conditioning.high_pass", slot<&S::conditioning, &C::high_pass>, frequency, tiny, 1e3,
             "lower corner of the filter; none: no lower corner"),
      number("conditioning.low_pass", slot<&S::conditioning, &C::low_pass>, frequency, tiny, 1e3,
             "upper corner of the filter; none: 25 Hz, or no upper corner for a record that its publisher "
             "filtered or whose samples end below 28 Hz"),
      number("conditioning.filter_order", slot<&S::conditioning, &C::filter_order>, count, 1, 12,
             "order of the Butterworth filter"),
      text("conditioning.filter_phase", slot<&S::conditioning, &C::filter_phase>,
           "forward and backward, without shift of phase; or forward alone: nothing moves before the record",
           {"zero", "causal"}),
      number("conditioning.interval", slot<&S::conditioning, &C::interval>, time, 1e-6, 1,
             "time between samples after resampling; none: the record's own"),
      text("conditioning.resample", slot<&S::conditioning, &C::resample>, "how it is resampled",
           {"fft", "spline", "linear"}),
      text("conditioning.end", slot<&S::conditioning, &C::end>,
           "what becomes of displacement and velocity left at the end; at-rest: a smooth displacement is "
           "taken off",
           {"as-it-is", "at-rest"}),

      text("solve.integrator", slot<&S::solve, &V::integrator>,
           "how the motion is integrated; automatic: by solve.accuracy", integrator_choices()),
      text("solve.accuracy", slot<&S::solve, &V::accuracy>,
           "chooses integrator, step and tolerance by what the building contains",
           {"draft", "standard", "reference"}),
      number("solve.step_fraction", slot<&S::solve, &V::step_fraction>, ratio, 1e-4, 0.999,
             "time step as a part of the stability bound, instead of solve.accuracy's"),
      number("solve.step", slot<&S::solve, &V::step>, time, 1e-12, 1,
             "time step, instead of both; refused above the stability bound"),
      number("solve.tolerance", slot<&S::solve, &V::tolerance>, ratio, 1e-15, 1,
             "of an integrator that chooses its own step"),
      number("solve.threads", slot<&S::solve, &V::threads>, count, 1, 256,
             "threads that share every step, worth it above some thousand blocks; the results are the same"),
      number("solve.duration", slot<&S::solve, &V::duration>, time, tiny, 1e5,
             "simulated time; none: the motion and solve.free_vibration"),
      number("solve.free_vibration", slot<&S::solve, &V::free_vibration>, time, 0, 1e4,
             "time after the motion, in which the building comes to rest"),
      number("solve.after_collapse", slot<&S::solve, &V::after_collapse>, time, 0, 1e5,
             "time after every storey is lost, in which the debris falls; none: to the end"),
      flag("solve.settle", slot<&S::solve, &V::settle>, "settle under gravity before the motion"),

      number("loss.drop_of_width", slot<&S::loss, &L::drop_of_width>, ratio, 0, 1e3,
             "a block has fallen when it is down by more than this part of its least width"),
      number("loss.least_drop_of_storey", slot<&S::loss, &L::least_drop_of_storey>, ratio, 0, 1e3,
             "but not by less than this part of the storey height"),
      number("loss.most_drop_of_storey", slot<&S::loss, &L::most_drop_of_storey>, ratio, 0, 1e3,
             "nor is more than this part of the storey height needed"),
      number("loss.turn", slot<&S::loss, &L::turn>, angle, 0, 100 * half_turn,
             "a block is lost when it has turned by more than this"),
      number("loss.slide_of_length", slot<&S::loss, &L::slide_of_length>, ratio, 0, 1e3,
             "or moved past its storey's blocks by more than this part of its own length"),
      number("loss.level_mass", slot<&S::loss, &L::level_mass>, ratio, 0, 1,
             "a storey is lost with more than this part of its level's mass"),

      number("verdict.energy_error", slot<&S::verdict, &J::energy_error>, ratio, 0, endless,
             "numerically invalid above this energy error, over the energy turned over"),
      number("verdict.overlap", slot<&S::verdict, &J::overlap>, ratio, 0, endless,
             "numerically invalid above this overlap, over the smaller block's least width"),
      number("verdict.fallen_mass", slot<&S::verdict, &J::fallen_mass>, ratio, 0, 1,
             "collapsed when more than this part of the mass fell"),
      number("verdict.speed_at_end", slot<&S::verdict, &J::speed_at_end>, speed, 0, endless,
             "undecided when a block moves faster at the end"),
      number("verdict.lean", slot<&S::verdict, &J::lean>, ratio, 0, endless,
             "undecided when a block leans by more than this part of its own toppling angle"),
      number("verdict.drift_growth", slot<&S::verdict, &J::drift_growth>, ratio, 0, endless,
             "undecided when a drift grows by more than this in the last second"),

      text("screening.codes", slot<&S::screening, &G::codes>,
           "standards whose drift limits are looked at, by their ids (asce7, eurocode8, fema356, gb50011, "
           "hazus), with commas between; automatic: those with limits for the structural type; none"),
      text("screening.structure", slot<&S::screening, &G::structure>,
           "the structural type whose limits they are; automatic: that of the layout", structure_words()),

      number("ensemble.n", slot<&S::ensemble, &E::n>, count, 1, 10000,
             "runs in all: as described, and with small changes; 1: a single run"),
      flag("ensemble.half_step", slot<&S::ensemble, &E::half_step>,
           "once more with half the step, for the numerical error"),
      number("ensemble.position_change", perturbation<&P::position>, length, 0, 1,
             "changes sideways of where each block, or tied part, stands, up to this"),
      number("ensemble.friction_change", perturbation<&P::friction>, ratio, 0, 1,
             "changes of each friction coefficient, up to this part of it"),
      number("ensemble.strength_change", perturbation<&P::strength>, ratio, 0, 1,
             "changes of each bond's strengths, up to this part of them"),
      number("ensemble.damping_change", perturbation<&P::damping>, ratio, 0, 1,
             "changes of each damping, up to this part of it"),
      number("ensemble.amplitude_change", perturbation<&P::amplitude>, ratio, 0, 1,
             "changes of the motion, up to this part of it"),
      number("ensemble.seed", perturbation<&P::seed>, count, 0, 1e9, "of the random numbers"),

      number("output.rate", slot<&S::output, &O::rate>, frequency, 0.01, 1e6,
             "output times a second: of the histories, peaks and verdict"),
      number("output.state_rate", slot<&S::output, &O::state_rate>, frequency, 0.01, 1e6,
             "how many of them a second keep the states of all blocks, for pictures and films"),
      text("output.directory", slot<&S::output, &O::directory>, "where the results are written"),
      number("output.save_every", slot<&S::output, &O::save_every>, time, 0.0, endless,
             "of the clock: what there is of a run is saved this often, if that takes no more than a "
             "fiftieth of the time"),
  };
}

}  // namespace

std::span<const ScenarioKey> scenario_keys() {
  static const std::vector<ScenarioKey> table = make_table();
  return table;
}

const ScenarioKey* find_key(const std::string& name) {
  const auto it = std::ranges::find(scenario_keys(), name, &ScenarioKey::name);
  return it == scenario_keys().end() ? nullptr : &*it;
}

}  // namespace dougong::app
