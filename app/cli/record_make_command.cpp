#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "app/cli/commands.h"
#include "app/cli/motion_file.h"
#include "app/cli/record_output.h"
#include "app/cli/record_tools.h"
#include "app/study/target_choice.h"
#include "app/study/word_keys.h"
#include "seismic/synthesis/compatible_motion.h"
#include "seismic/synthesis/finite_fault.h"
#include "seismic/synthesis/pulses.h"
#include "seismic/synthesis/scenario.h"

namespace dougong::app {
namespace {

using nlohmann::ordered_json;
using enum Dimension;

constexpr double longest = 3600.0;  // s
constexpr double km = 1000.0;

struct Made {
  std::vector<double> acceleration;  // m/s2
  std::vector<std::string> said;     // what was made, with numbers
};

// --- what every kind has ------------------------------------------------------------------------------

double interval_of(WordKeys& keys) {
  const double interval = keys.positive("interval", time, 0.01);
  if (!(interval >= 1e-5 && interval <= 1.0)) keys.fail("interval: expected 10 us to 1 s");
  return interval;
}

std::uint64_t seed_of(WordKeys& keys) {
  return static_cast<std::uint64_t>(keys.number("seed", 1));
}

double duration_of(WordKeys& keys, double otherwise) {
  const double duration = keys.positive("duration", time, otherwise);
  if (duration > longest) keys.fail(fmt::format("duration: expected at most {:g} s", longest));
  return duration;
}

double frequency_of(WordKeys& keys, const char* key, double interval) {
  const double f = keys.positive(key, frequency);
  if (!(f >= 1e-3 && f < 0.5 / interval))
    keys.fail(fmt::format("{}: expected 1 mHz to below the Nyquist frequency, {:g} Hz", key, 0.5 / interval));
  return f;
}

seismic::Silence silence_of(WordKeys& keys) {
  const seismic::Silence s{keys.quantity("lead", time, 0.0), keys.quantity("rest", time, 0.0)};
  if (!(s.lead >= 0.0 && s.lead <= longest && s.rest >= 0.0 && s.rest <= longest))
    keys.fail(fmt::format("lead, rest: expected 0 s to {:g} s", longest));
  return s;
}

double cycles_of(WordKeys& keys) {
  const double cycles = keys.positive("cycles", ratio, 1.0);
  if (cycles > 1e4) keys.fail("cycles: expected at most 1e4");
  return cycles;
}

seismic::Region region_of(WordKeys& keys) {
  seismic::Region r;
  r.density = keys.positive("density", density, r.density);
  r.shear_velocity = keys.positive("shear-velocity", speed, r.shear_velocity);
  r.q0 = keys.positive("q0", ratio, r.q0);
  r.q_exponent = keys.quantity("q-exponent", ratio, r.q_exponent);
  r.kappa = keys.quantity("kappa", time, r.kappa);
  r.site_factor = keys.positive("site-factor", ratio, r.site_factor);
  r.low_cut = keys.positive("low-cut", frequency, r.low_cut);
  if (!(r.kappa >= 0.0 && r.kappa <= 1.0)) keys.fail("kappa: expected 0 s to 1 s");
  return r;
}

double magnitude_of(WordKeys& keys) {
  const double magnitude = keys.quantity("magnitude", ratio);
  if (!(magnitude >= 3.0 && magnitude <= 9.5)) keys.fail("magnitude: expected 3 to 9.5");
  return magnitude;
}

double part_of(WordKeys& keys, const char* key, double otherwise) {
  const double part = keys.quantity(key, ratio, otherwise);
  if (!(part >= 0.0 && part <= 1.0)) keys.fail(std::string(key) + ": expected 0 to 1");
  return part;
}

// --- the kinds ------------------------------------------------------------------------------------------

Made make_sine(WordKeys& keys, double h) {
  const double peak = keys.quantity("peak", acceleration), f = frequency_of(keys, "frequency", h);
  const double cycles = cycles_of(keys);
  return {seismic::sine_pulse(peak, f, cycles, h, silence_of(keys)),
          {fmt::format("sine pulse, {:g} m/s2, {:g} Hz, {:g} cycles", peak, f, cycles)}};
}

Made make_cosine(WordKeys& keys, double h) {
  const double peak = keys.quantity("peak", acceleration), f = frequency_of(keys, "frequency", h);
  const double cycles = cycles_of(keys);
  return {seismic::cosine_pulse(peak, f, cycles, h, silence_of(keys)),
          {fmt::format("cosine pulse, {:g} m/s2, {:g} Hz, {:g} cycles", peak, f, cycles)}};
}

Made make_ricker(WordKeys& keys, double h) {
  const double peak = keys.quantity("peak", acceleration), f = frequency_of(keys, "frequency", h);
  return {seismic::ricker_pulse(peak, f, h, silence_of(keys)),
          {fmt::format("Ricker pulse, {:g} m/s2, {:g} Hz", peak, f)}};
}

Made make_near_fault(WordKeys& keys, double h) {
  seismic::NearFaultPulse p;
  p.velocity = keys.quantity("velocity", speed);
  p.frequency = frequency_of(keys, "frequency", h);
  p.gamma = keys.quantity("gamma", ratio, 2.0);
  p.phase = keys.quantity("phase", angle, 0.0);
  if (!(p.gamma > 1.0 && p.gamma <= 100.0)) keys.fail("gamma: expected above 1 and at most 100");
  return {seismic::near_fault_pulse(p, h, silence_of(keys)),
          {fmt::format(
              "Mavroeidis-Papageorgiou pulse, {:g} m/s, {:g} Hz, gamma {:g}, phase {:g} rad; leaves {:.4g} m",
              p.velocity, p.frequency, p.gamma, p.phase, seismic::residual_displacement(p))}};
}

Made make_harmonic(WordKeys& keys, double h) {
  const double peak = keys.quantity("peak", acceleration), f = frequency_of(keys, "frequency", h);
  const double duration = duration_of(keys, 20.0), ramp = keys.quantity("ramp", time, 0.0);
  if (!(ramp >= 0.0 && ramp <= 0.5 * duration)) keys.fail("ramp: expected 0 to half of the duration");
  return {seismic::harmonic(peak, f, duration, ramp, h),
          {fmt::format("harmonic, {:g} m/s2, {:g} Hz, {:g} s, ramps of {:g} s", peak, f, duration, ramp)}};
}

Made make_sweep(WordKeys& keys, double h) {
  const double peak = keys.quantity("peak", acceleration);
  const double from = frequency_of(keys, "from", h), to = frequency_of(keys, "to", h);
  const double duration = duration_of(keys, 60.0), ramp = keys.quantity("ramp", time, 0.0);
  if (!(ramp >= 0.0 && ramp <= 0.5 * duration)) keys.fail("ramp: expected 0 to half of the duration");
  const std::string rate = keys.word("rate", "log");
  if (rate != "log" && rate != "linear") keys.fail("rate: expected log or linear, found \"" + rate + "\"");
  const auto how = rate == "log" ? seismic::SweepRate::logarithmic : seismic::SweepRate::linear;
  return {seismic::sweep(peak, from, to, how, duration, ramp, h),
          {fmt::format("{} sweep, {:g} m/s2, {:g} to {:g} Hz in {:g} s", rate, peak, from, to, duration)}};
}

Made make_noise(WordKeys& keys, double h) {
  const double deviation = keys.positive("deviation", acceleration), duration = duration_of(keys, 30.0);
  const double ramp = keys.quantity("ramp", time, 0.0);
  if (!(ramp >= 0.0 && ramp <= 0.5 * duration)) keys.fail("ramp: expected 0 to half of the duration");
  const std::uint64_t seed = seed_of(keys);
  return {
      seismic::white_noise(deviation, duration, ramp, h, seed),
      {fmt::format("white noise, standard deviation {:g} m/s2, {:g} s, seed {}", deviation, duration, seed)}};
}

Made make_compatible(WordKeys& keys, double h) {
  // The keys of the target have commas too: between its own the target has semicolons here.
  std::string words = keys.word("target");
  for (char& c : words) c = c == ';' ? ',' : c;
  const seismic::DesignSpectrum target = target_spectrum(words);
  seismic::CompatibleOptions o;
  o.interval = h;
  o.seed = seed_of(keys);
  o.duration = duration_of(keys, o.duration);
  o.shortest_period = keys.positive("from", time, std::max(o.shortest_period, target.shortest_period));
  o.longest_period = keys.positive("to", time, std::min(o.longest_period, target.longest_period));
  o.rounds = keys.number("rounds", o.rounds);
  if (!(o.shortest_period >= 4.0 * h && o.longest_period > o.shortest_period &&
        o.longest_period <= 0.5 * o.duration))
    keys.fail("from, to: expected a band from four steps or more to half of the duration");
  if (o.rounds < 1 || o.rounds > 1000) keys.fail("rounds: expected 1 to 1000");
  seismic::CompatibleMotion m = seismic::compatible_motion(target, o);
  return {
      std::move(m.acceleration),
      {"artificial motion for " + target.name,
       fmt::format("band {:g} s to {:g} s, seed {}; misfit {:.4f}, PSa {:.3f} to {:.3f} of the target",
                   o.shortest_period, o.longest_period, o.seed, m.misfit, m.least_ratio, m.greatest_ratio)}};
}

Made make_point(WordKeys& keys, double h) {
  seismic::PointSource s;
  s.magnitude = magnitude_of(keys);
  s.stress_drop = keys.positive("stress-drop", pressure, s.stress_drop);
  s.distance = keys.positive("distance", length);
  s.onset = 1.0;
  const seismic::Region region = region_of(keys);
  const std::uint64_t seed = seed_of(keys);
  const int component = keys.number("component", 1);
  const double duration = std::min(longest, s.onset + 5.0 * seismic::motion_duration(s, region));
  const auto count = static_cast<std::size_t>(std::ceil(duration / h)) + 1;
  return {
      seismic::simulate(s, region, h, count, seed, static_cast<std::uint64_t>(component)),
      {fmt::format("stochastic point source (Boore 2003), Mw {:g}, {:g} MPa, {:g} km, corner {:.4g} Hz",
                   s.magnitude, 1e-6 * s.stress_drop, s.distance / km, seismic::corner_frequency(s, region)),
       fmt::format("excitation {:.4g} s, seed {}, component {}", seismic::motion_duration(s, region), seed,
                   component)}};
}

seismic::FiniteFault fault_of(WordKeys& keys) {
  seismic::FiniteFault f;
  f.magnitude = magnitude_of(keys);
  f.stress_drop = keys.positive("stress-drop", pressure, f.stress_drop);
  const seismic::FaultSize size = seismic::fault_size(f.magnitude, seismic::FaultStyle::all, f.stress_drop);
  f.length = keys.positive("length", length, size.length);
  f.width = keys.positive("width", length, size.width);
  f.strike = keys.quantity("strike", angle, 0.0);
  f.dip = keys.quantity("dip", angle, 0.5 * std::numbers::pi);
  f.top_depth = keys.quantity("top", length, 0.0);
  const double side = std::max(1000.0, std::sqrt(f.length * f.width / 100.0));  // some hundred subfaults
  f.subfault_length = keys.positive("subfault-length", length, side);
  f.subfault_width = keys.positive("subfault-width", length, side);
  f.hypocentre_along = part_of(keys, "hypocentre-along", 0.5);
  f.hypocentre_down = part_of(keys, "hypocentre-down", 0.5);
  f.rupture_ratio = keys.positive("rupture-ratio", ratio, f.rupture_ratio);
  f.pulsing_share = part_of(keys, "pulsing", f.pulsing_share);
  const std::string slip = keys.word("slip", "uniform");
  if (slip != "uniform" && slip != "random")
    keys.fail("slip: expected uniform or random, found \"" + slip + "\"");
  f.slip = slip == "random" ? seismic::SlipModel::random : seismic::SlipModel::uniform;
  if (!(f.dip > 0.0 && f.dip <= std::numbers::pi)) keys.fail("dip: expected above 0 deg and at most 180 deg");
  if (!(f.top_depth >= 0.0)) keys.fail("top: expected 0 m or more");
  if (f.rupture_ratio > 2.0) keys.fail("rupture-ratio: expected at most 2");
  const double parts = f.length / f.subfault_length * f.width / f.subfault_width;
  if (!(parts <= 1e4))
    keys.fail(
        fmt::format("subfault-length, subfault-width: expected at most 1e4 subfaults, found {:.3g}", parts));
  return f;
}

Made make_fault(WordKeys& keys, double h) {
  const seismic::FiniteFault fault = fault_of(keys);
  const seismic::Region region = region_of(keys);
  const seismic::SitePlace site{keys.quantity("site-east", length), keys.quantity("site-north", length)};
  const std::uint64_t seed = seed_of(keys);
  const int component = keys.number("component", 1);
  const auto parts = seismic::subfaults(fault, region, site, seed);
  if (seismic::closest_distance(parts) < 500.0)
    keys.fail("site-east, site-north: expected a site 500 m or more from every subfault");
  return {seismic::simulate(fault, region, site, h, 1.0, seed, static_cast<std::uint64_t>(component)),
          {fmt::format("stochastic finite fault (Motazedian & Atkinson 2005; Boore 2009), Mw {:g}, {:g} MPa, "
                       "{:g} x {:g} km, "
                       "{} subfaults",
                       fault.magnitude, 1e-6 * fault.stress_drop, fault.length / km, fault.width / km,
                       parts.size()),
           fmt::format("nearest subfault {:.4g} km, seed {}, component {}",
                       seismic::closest_distance(parts) / km, seed, component)}};
}

// Another realisation of a shipped earthquake.
Made make_styled(WordKeys& keys, double h) {
  const std::string name = keys.word("name");
  std::string known;
  for (seismic::Scenario scenario : seismic::shipped_scenarios()) {
    known += (known.empty() ? "" : ", ") + scenario.alias;
    if (name != scenario.alias) continue;
    scenario.seed = seed_of(keys);
    scenario.interval = h;
    scenario.site = {keys.quantity("site-east", length, scenario.site.east),
                     keys.quantity("site-north", length, scenario.site.north)};
    if (seismic::closest_distance(scenario) < 500.0)
      keys.fail("site-east, site-north: expected a site 500 m or more from every subfault");
    const std::string component = keys.word("component", "EW");
    seismic::ThreeComponents motion = seismic::simulate(scenario);
    std::vector<std::string> said = {
        fmt::format("{}, seed {}, {}", scenario.title, scenario.seed, component)};
    if (component == "EW") return {std::move(motion.east_west), said};
    if (component == "NS") return {std::move(motion.north_south), said};
    if (component == "UD") return {std::move(motion.up_down), said};
    keys.fail("component: expected EW, NS or UD, found \"" + component + "\"");
  }
  keys.fail("name: expected one of " + known + ", found \"" + name + "\"");
}

struct Kind {
  const char* name;
  Made (*make)(WordKeys&, double interval);
  const char* summary;
  const char* keys;  // beside `interval`
};

constexpr const char* crust_keys =
    "density, shear-velocity, q0, q-exponent, kappa, site-factor, low-cut, seed, component";

const Kind kinds[] = {
    {"sine", make_sine, "cycles of a sine", "peak, frequency, cycles, lead, rest"},
    {"cosine", make_cosine, "cycles of a cosine", "peak, frequency, cycles, lead, rest"},
    {"ricker", make_ricker, "the second derivative of a bell", "peak, frequency, lead, rest"},
    {"near-fault", make_near_fault, "the velocity pulse of Mavroeidis and Papageorgiou",
     "velocity, frequency, gamma, phase, lead, rest"},
    {"harmonic", make_harmonic, "a sine with ramps", "peak, frequency, duration, ramp"},
    {"sweep", make_sweep, "a sine of rising or falling frequency", "peak, from, to, rate, duration, ramp"},
    {"noise", make_noise, "Gaussian white noise", "deviation, duration, ramp, seed"},
    {"compatible", make_compatible, "noise shaped until its spectrum follows a target",
     "target (as --target of record scale, with ; for ,), from, to, duration, rounds, seed"},
    {"styled", make_styled, "another realisation of a shipped earthquake, or at another place",
     "name, component, seed, site-east, site-north"},
    {"point-source", make_point, "stochastic point source",
     "magnitude, stress-drop, distance, and of the crust"},
    {"finite-fault", make_fault, "stochastic finite fault",
     "magnitude, stress-drop, length, width, strike, dip, top, site-east, site-north, subfault-length, "
     "subfault-width, hypocentre-along, hypocentre-down, rupture-ratio, pulsing, slip, and of the crust"},
};

int list_kinds() {
  for (const Kind& kind : kinds)
    fmt::print("{:<14}{}\n{:<14}keys: {}\n", kind.name, kind.summary, "", kind.keys);
  fmt::print("\nEvery kind has the key interval (0.01 s); those with a crust have {}.\n", crust_keys);
  fmt::print(
      "Distances along and down the fault are parts of it; the site is given from the fault's upper corner, "
      "from "
      "which the strike runs.\n");
  return exit_survived;
}

const Kind& kind_named(const std::string& name) {
  std::string known;
  for (const Kind& kind : kinds) {
    if (name == kind.name) return kind;
    known += (known.empty() ? "" : ", ") + std::string(kind.name);
  }
  refuse("record make " + name, "expected one of " + known);
}

WordKeys keys_of(const MakeOptions& o) {
  std::map<std::string, std::string> values;
  const std::string where = "record make " + o.kind;
  for (const std::string& text : o.set) {
    const Override one = parse_override(text);
    if (!values.emplace(one.key, one.value).second) refuse(where, "the key " + one.key + " is given twice");
  }
  return {where, std::move(values)};
}

}  // namespace

int record_make_command(const MakeOptions& o) {
  if (o.kind.empty()) return list_kinds();
  const Kind& kind = kind_named(o.kind);
  if (o.out.empty()) refuse("record make " + o.kind, "expected a file to write: --out motion.at2");
  check_motion_file(o.out, o.force);
  WordKeys keys = keys_of(o);
  const double interval = interval_of(keys);
  const Made made = kind.make(keys, interval);
  keys.finish();
  write_motion(
      o.out,
      {"SYNTHETIC motion made by dougong, not a recording: " + fmt::format("{}", fmt::join(made.said, "; ")),
       fmt::format("dougong {}", kind.name), "no station", "H1"},
      interval, made.acceleration, o.force);
  const seismic::GroundHistory h = seismic::integrate(made.acceleration, interval);
  const double pga = seismic::peak(h.acceleration, interval).value,
               pgv = seismic::peak(h.velocity, interval).value;
  if (o.json) {
    print_json({{"file", o.out},
                {"kind", kind.name},
                {"made", made.said},
                {"dt_s", interval},
                {"npts", made.acceleration.size()},
                {"pga_m_s2", pga},
                {"pgv_m_s", pgv},
                {"last_velocity_m_s", h.velocity.back()},
                {"last_displacement_m", h.displacement.back()}});
    return exit_survived;
  }
  for (const std::string& line : made.said) fmt::print("{}\n", line);
  fmt::print(
      "{} samples every {:g} s, PGA {:.5g} m/s2, PGV {:.5g} m/s; ends at {:.3g} m/s and {:.3g} m\n{}\n",
      made.acceleration.size(), interval, pga, pgv, h.velocity.back(), h.displacement.back(), o.out);
  return exit_survived;
}

}  // namespace dougong::app
