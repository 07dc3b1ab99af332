#include "seismic/conditioning/condition.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "seismic/conditioning/baseline.h"
#include "seismic/conditioning/butterworth.h"
#include "seismic/conditioning/taper.h"
#include "seismic/measures/peaks.h"

namespace dougong::seismic {
namespace {

constexpr const char* where = "ground motion options";
constexpr double usual_low_pass = 25.0;   // Hz
constexpr double highest_corner = 0.9;    // of the Nyquist frequency, for the usual low pass
constexpr double residual_limit = 0.01;   // of the peak velocity and displacement, before a warning
constexpr double most_pad_samples = 1e7;  // at each end: what memory should bear
constexpr double least_samples = 10.0;    // of a record in the period of a building
constexpr double usable_above = 1.25;     // of a high-pass corner: PEER's lowest usable frequency

struct Trace {
  std::string component;
  std::vector<double> a;
};

// The components under way, with what was done to them.
struct Job {
  std::vector<Trace> traces;  // the horizontal one first
  double interval = 0.0;
  double lead = 0.0;
  double scale = 1.0;
  Band band;  // as filtered
  const char* unit = " m/s2";
  std::vector<std::string> said, warnings;
};

std::size_t samples_in(double time, double interval) {
  return static_cast<std::size_t>(std::max(0LL, std::llround(time / interval)));
}

// "EW 0.012 m/s2, UD 0.003 m/s2": one number for every component.
template <typename Number>
std::string each(const Job& job, const char* unit, Number number) {
  std::string text;
  for (const Trace& trace : job.traces) {
    text += fmt::format("{}{} {:.4g}{}", text.empty() ? "" : ", ", trace.component, number(trace), unit);
  }
  return text;
}

void require(std::vector<InputProblem>& problems, bool holds, std::string expected, std::string found) {
  if (!holds) problems.push_back({where, 0, std::move(expected), std::move(found)});
}

// s. Without a lower corner the answer of the filter is short: that of 1 Hz.
double needed_pad(int order, std::optional<double> high_pass) {
  return 1.5 * order / (2.0 * high_pass.value_or(1.0));
}

void check_pads(const ConditioningOptions& o, double interval, std::vector<InputProblem>& problems) {
  const double pad = o.pad.value_or(o.filter ? needed_pad(o.order, o.high_pass) : 0.0);
  require(problems, pad / interval <= most_pad_samples,
          fmt::format("pads of at most {:g} samples", most_pad_samples),
          fmt::format("{:.4g} s of zeros at each end{}", pad,
                      o.pad ? "" : " for this high-pass corner, unless a pad is given"));
}

void check_corners(const ConditioningOptions& o, double nyquist, std::vector<InputProblem>& problems) {
  require(problems, o.order >= 1 && o.order <= 12, "a filter order from 1 to 12", std::to_string(o.order));
  if (o.high_pass) {
    require(problems, *o.high_pass > 0.0 && *o.high_pass < nyquist,
            fmt::format("a high-pass corner between 0 and the Nyquist frequency, {:g} Hz", nyquist),
            fmt::format("{:g} Hz", *o.high_pass));
  }
  if (o.low_pass) {
    require(problems, *o.low_pass > o.high_pass.value_or(0.0) && *o.low_pass < nyquist,
            fmt::format("a low-pass corner between the high-pass corner and the Nyquist frequency, {:g} Hz",
                        nyquist),
            fmt::format("{:g} Hz", *o.low_pass));
  }
}

void check_scale(const RecordSet& records, const ConditioningOptions& o,
                 std::vector<InputProblem>& problems) {
  const Record& record = records.horizontal();
  if (record.dimensionless && !o.target_pga) {
    problems.push_back(
        {record.provenance.file, 0,
         "a target PGA (option pga): the record is a dimensionless shape, its peak of 1 is not 1 g",
         o.scale_factor ? "a scale factor" : "none"});
  }
  require(problems, !(o.target_pga && o.scale_factor), "a target PGA or a scale factor", "both");
  if (o.target_pga)
    require(problems, *o.target_pga > 0.0, "a positive target PGA", fmt::format("{:g}", *o.target_pga));
  if (o.scale_factor) {
    require(problems, *o.scale_factor > 0.0, "a positive scale factor", fmt::format("{:g}", *o.scale_factor));
  }
}

struct BaselineChoice {
  bool of_velocity;
  int degree;
};

std::optional<BaselineChoice> chosen_baseline(const ConditioningOptions& options) {
  switch (options.baseline) {
    case BaselineCorrection::none:
      return std::nullopt;
    case BaselineCorrection::acceleration_line:
      return BaselineChoice{false, 1};
    case BaselineCorrection::velocity_parabola:
      return BaselineChoice{true, 2};
    case BaselineCorrection::acceleration_polynomial:
      return BaselineChoice{false, options.baseline_degree};
    case BaselineCorrection::velocity_polynomial:
      return BaselineChoice{true, options.baseline_degree};
  }
  return std::nullopt;
}

void check(const RecordSet& records, const ConditioningOptions& o) {
  std::vector<InputProblem> problems;
  const Record& record = records.horizontal();
  if (record.axis == Axis::vertical) {
    problems.push_back(
        {record.provenance.file, 0, "a horizontal component", record.component + ", a vertical one"});
  }
  check_scale(records, o, problems);
  if (o.filter) check_corners(o, 0.5 / record.interval, problems);
  check_pads(o, record.interval, problems);
  if (const auto baseline = chosen_baseline(o)) {
    const int least = baseline->of_velocity ? 1 : 0;
    require(problems, baseline->degree >= least && baseline->degree <= highest_baseline_degree,
            fmt::format("a degree of the baseline from {} to {}", least, highest_baseline_degree),
            std::to_string(baseline->degree));
  }
  require(problems, o.taper_fraction >= 0.0 && o.taper_fraction <= 0.5, "a taper of 0 to 0.5 of the record",
          fmt::format("{:g}", o.taper_fraction));
  require(problems, o.kept_pad >= 0.0 && o.pad.value_or(0.0) >= 0.0, "pads that are not negative",
          "a negative one");
  const double from = o.from.value_or(0.0), to = o.to.value_or(record.duration());
  require(problems, from >= 0.0 && to - from >= record.interval,
          fmt::format("a part of the record, which lasts {:g} s", record.duration()),
          fmt::format("{:g} s to {:g} s", from, to));
  if (o.interval)
    require(problems, *o.interval >= 1e-5, "a time step of at least 1e-5 s",
            fmt::format("{:g} s", *o.interval));
  if (!problems.empty()) throw InputError(std::move(problems));
}

Job start(const RecordSet& records, const ConditioningOptions& options) {
  Job job;
  const auto add = [&job](const Record& record) {
    job.traces.push_back({record.component, record.acceleration});
    job.said.insert(job.said.end(), record.processing.begin(), record.processing.end());
    for (const std::string& warning : record.warnings)
      job.warnings.push_back(record.component + ": " + warning);
  };
  const Record& horizontal = records.horizontal();
  add(horizontal);
  const Record* vertical = records.vertical();
  if (options.vertical && vertical && vertical != &horizontal) add(*vertical);
  job.warnings.insert(job.warnings.end(), records.warnings.begin(), records.warnings.end());
  job.interval = horizontal.interval;
  if (horizontal.dimensionless) job.unit = "";
  return job;
}

void cut(Job& job, const ConditioningOptions& options) {
  if (!options.from && !options.to) return;
  const std::size_t first = samples_in(options.from.value_or(0.0), job.interval);
  const std::size_t last = options.to ? samples_in(*options.to, job.interval) : job.traces[0].a.size();
  for (Trace& trace : job.traces) {
    const std::size_t end = std::min(last + 1, trace.a.size());
    trace.a = {trace.a.begin() + static_cast<std::ptrdiff_t>(first),
               trace.a.begin() + static_cast<std::ptrdiff_t>(end)};
  }
  job.said.push_back(fmt::format("cut: from {:.4g} s to {:.4g} s of the record",
                                 static_cast<double>(first) * job.interval,
                                 static_cast<double>(first + job.traces[0].a.size() - 1) * job.interval));
}

void remove_offset(Job& job, const ConditioningOptions& options) {
  if (options.offset == OffsetRemoval::none) return job.said.push_back("offset: none removed");
  const bool whole = options.offset == OffsetRemoval::whole_record_mean;
  std::vector<double> offsets;
  for (Trace& trace : job.traces) {
    const std::size_t count =
        whole ? trace.a.size()
              : std::clamp<std::size_t>(samples_in(options.pre_event, job.interval), 1, trace.a.size());
    offsets.push_back(mean(std::span(trace.a).first(count)));
    for (double& a : trace.a) a -= offsets.back();
  }
  const double largest = peak(job.traces[0].a, job.interval).value;
  const bool nothing = std::all_of(offsets.begin(), offsets.end(),
                                   [&](double offset) { return std::abs(offset) <= 1e-12 * largest; });
  if (nothing) return job.said.push_back("offset: none left to remove");
  std::size_t i = 0;
  const std::string numbers = each(job, job.unit, [&](const Trace&) { return offsets[i++]; });
  job.said.push_back(
      whole ? "offset: whole-record mean removed (" + numbers + ")"
            : fmt::format("offset: mean of the first {:g} s removed ({})", options.pre_event, numbers));
}

// "0.0492 + (-0.00197) t + (1e-5) t^2"
std::string polynomial_text(const Baseline& baseline) {
  std::string text;
  for (std::size_t i = 0; i < baseline.size(); ++i) {
    text += i == 0 ? fmt::format("{:.6g}", baseline[i]) : fmt::format(" + ({:.6g}) t", baseline[i]);
    if (i > 1) text += fmt::format("^{}", i);
  }
  return text.empty() ? "nothing, the record is too short" : text;
}

void correct_baseline(Job& job, const ConditioningOptions& options) {
  const auto choice = chosen_baseline(options);
  if (!choice) return;
  for (Trace& trace : job.traces) {
    const Baseline removed = choice->of_velocity
                                 ? remove_velocity_polynomial(trace.a, job.interval, choice->degree)
                                 : remove_acceleration_polynomial(trace.a, job.interval, choice->degree);
    job.said.push_back(fmt::format("baseline: {} of degree {} taken off {}: {}",
                                   choice->of_velocity
                                       ? "derivative of the least-squares polynomial of velocity"
                                       : "least-squares polynomial",
                                   choice->degree, trace.component, polynomial_text(removed)));
  }
}

void bring_to_rest(Job& job, const ConditioningOptions& options) {
  if (options.end == EndRule::as_it_is) return;
  for (Trace& trace : job.traces) {
    const RestCorrection c = end_at_rest(trace.a, job.interval);
    job.said.push_back(fmt::format(
        "rest: {} ended at {:.4g} m and {:.4g} m/s; a quintic displacement taken off brings it back "
        "(changes the acceleration by at most {:.3g}{})",
        trace.component, c.displacement, c.velocity, c.greatest_change, job.unit));
  }
}

void taper(Job& job, const ConditioningOptions& options) {
  const double duration = job.interval * static_cast<double>(job.traces[0].a.size() - 1);
  const double length = std::min(options.taper_fraction * duration, options.longest_taper);
  const std::size_t count = samples_in(length, job.interval);
  if (count == 0) return job.said.push_back("taper: none");
  for (Trace& trace : job.traces) cosine_taper(trace.a, count);
  job.said.push_back(
      fmt::format("taper: half cosine over {:.4g} s at each end", static_cast<double>(count) * job.interval));
}

// The corners to use; why the upper one is left out, if it is.
Band chosen_band(const Job& job, const ConditioningOptions& options, bool processed, std::string& remark) {
  Band band{options.high_pass, options.low_pass, options.order};
  const double highest = highest_corner * 0.5 / job.interval;
  if (options.low_pass) return band;
  if (processed) {
    remark = "; no upper corner: the publisher filtered the record";
  } else if (usual_low_pass > highest) {
    remark = fmt::format("; no upper corner: {:g} Hz is above {:g} of the Nyquist frequency", usual_low_pass,
                         highest_corner);
  } else {
    band.low_pass = usual_low_pass;
  }
  return band;
}

std::string band_text(const Band& band) {
  if (band.high_pass && band.low_pass)
    return fmt::format("band pass {:g}-{:g} Hz", *band.high_pass, *band.low_pass);
  if (band.high_pass) return fmt::format("high pass {:g} Hz", *band.high_pass);
  return fmt::format("low pass {:g} Hz", *band.low_pass);
}

// Fades the displacement of the whole padded history in over the first `fade` samples behind `first` and out
// over the last ones before `last`, by its acceleration; returns the part between, and the greatest
// acceleration that the fading added.
std::vector<double> faded_part(const std::vector<double>& padded_a, double interval, std::size_t first,
                               std::size_t last, std::size_t fade, double& added) {
  const GroundHistory h = integrate(padded_a, interval);
  const double length = interval * static_cast<double>(fade);
  std::vector<double> out;
  for (std::size_t k = first; k <= last; ++k) {
    const bool rising = k - first <= last - k;
    const double x = static_cast<double>(std::min(k - first, last - k)) / static_cast<double>(fade);
    const SmoothStep w = smooth_step(x);
    const double slope = (rising ? 1.0 : -1.0) * w.slope / length,
                 curvature = w.curvature / (length * length);
    const double a =
        w.value * h.acceleration[k] + 2.0 * slope * h.velocity[k] + curvature * h.displacement[k];
    added = std::max(added, std::abs(a - h.acceleration[k]));
    out.push_back(a);
  }
  return out;
}

void filter(Job& job, const ConditioningOptions& options, bool processed) {
  std::string remark;
  const Band band = chosen_band(job, options, processed, remark);
  if (!options.filter || (!band.high_pass && !band.low_pass)) return job.said.push_back("filter: none");
  job.band = band;
  const std::size_t pad =
      samples_in(options.pad.value_or(needed_pad(options.order, band.high_pass)), job.interval);
  const std::size_t kept = std::min(pad, samples_in(options.kept_pad, job.interval));
  const auto sections = butterworth(band, job.interval);
  double added = 0.0;
  for (Trace& trace : job.traces) {
    const std::size_t samples = trace.a.size();
    std::vector<double> a = padded(trace.a, pad, pad);
    options.phase == FilterPhase::zero ? filter_both_ways(sections, a) : filter_forward(sections, a);
    const std::size_t first = pad - kept, last = pad + samples - 1 + kept;
    trace.a = kept > 0 ? faded_part(a, job.interval, first, last, kept, added)
                       : std::vector<double>(a.begin() + static_cast<std::ptrdiff_t>(first),
                                             a.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  }
  job.lead = static_cast<double>(kept) * job.interval;
  job.said.push_back(fmt::format(
      "filter: Butterworth {}, order {}, {} over {:g} s of zeros at each end{}", band_text(band),
      options.order, options.phase == FilterPhase::zero ? "forward and backward" : "forward (causal)",
      static_cast<double>(pad) * job.interval, remark));
  job.said.push_back(
      fmt::format("pads: cut back to {:g} s at each end, the displacement faded over them (changes the "
                  "acceleration there by at most {:.3g}{})",
                  job.lead, added, job.unit));
}

const char* name_of(ResampleMethod method) {
  if (method == ResampleMethod::fft) return "trigonometric (FFT)";
  return method == ResampleMethod::spline ? "cubic spline" : "linear";
}

void change_interval(Job& job, const ConditioningOptions& options) {
  if (!options.interval || *options.interval == job.interval) return;
  for (Trace& trace : job.traces)
    trace.a = resample(trace.a, job.interval, *options.interval, options.resample_method);
  job.said.push_back(fmt::format("resampled: from {:g} s to {:g} s, {}", job.interval, *options.interval,
                                 name_of(options.resample_method)));
  job.interval = *options.interval;
}

void scale(Job& job, const ConditioningOptions& options) {
  const double found = peak(job.traces[0].a, job.interval).value;
  if (!options.target_pga && !options.scale_factor) {
    return job.said.push_back(fmt::format("scale: as recorded (PGA {:.6g} m/s2)", found));
  }
  if (options.target_pga && found == 0.0) {
    throw InputError(where, 0, "a record that moves, to scale it to a PGA", "a record of zeros");
  }
  job.scale = options.target_pga ? *options.target_pga / found : *options.scale_factor;
  for (Trace& trace : job.traces) {
    for (double& a : trace.a) a *= job.scale;
  }
  job.said.push_back(fmt::format("scale: all components times {:.6g}, so that {} peaks at {:.6g} m/s2",
                                 job.scale, job.traces[0].component, found * job.scale));
}

void judge_residuals(const Job& job, ConditionedMotion& out) {
  const GroundHistory h = integrate(out.horizontal, out.interval);
  out.residual_velocity = h.velocity.back();
  out.residual_displacement = h.displacement.back();
  const double greatest = peak(h.displacement, out.interval).value;
  out.processing.push_back(fmt::format(
      "integrated: from rest, linear acceleration between samples; PGV {:.4g} m/s, PGD {:.4g} m; at the end "
      "{:.2g} m/s and {:.2g} m are left",
      peak(h.velocity, out.interval).value, greatest, out.residual_velocity, out.residual_displacement));
  const bool moves = std::abs(out.residual_velocity) > residual_limit * peak(h.velocity, out.interval).value;
  if (!moves && std::abs(out.residual_displacement) <= residual_limit * greatest) return;
  out.warnings.push_back(
      fmt::format("{} does not return: {:.3g} m of displacement and {:.3g} m/s are left at its end; a "
                  "high-pass filter with kept pads, or conditioning.end = at-rest, brings it back",
                  job.traces[0].component, out.residual_displacement, out.residual_velocity));
}

std::string title_of(const Record& record) {
  std::string title;
  for (const std::string& part : {record.provenance.event, record.provenance.station, record.component}) {
    if (!part.empty()) title += (title.empty() ? "" : " / ") + part;
  }
  return title;
}

}  // namespace

ConditionedMotion condition(const RecordSet& records, const ConditioningOptions& options) {
  check(records, options);
  const Record& record = records.horizontal();
  Job job = start(records, options);
  ConditionedMotion out;
  const auto stage = [&](const char* step) {
    if (!options.keep_stages) return;
    const std::vector<double>& a = job.traces[0].a;
    if (out.stages.empty() || out.stages.back().acceleration != a)
      out.stages.push_back({step, job.interval, job.lead, a});
  };
  stage("read");
  cut(job, options);
  stage("cut");
  remove_offset(job, options);
  stage("offset");
  correct_baseline(job, options);
  stage("baseline");
  taper(job, options);
  stage("taper");
  filter(job, options, record.provenance.processed);
  stage("filter");
  change_interval(job, options);
  stage("resample");
  bring_to_rest(job, options);
  stage("rest");
  scale(job, options);
  stage("scale");
  out.title = title_of(record);
  out.interval = job.interval;
  out.lead = job.lead;
  out.scale_factor = job.scale;
  out.record_interval = record.interval;
  out.high_pass = job.band.high_pass;
  out.low_pass = job.band.low_pass;
  out.horizontal = std::move(job.traces[0].a);
  if (job.traces.size() > 1) out.vertical = std::move(job.traces[1].a);
  out.processing = std::move(job.said);
  out.warnings = std::move(job.warnings);
  judge_residuals(job, out);
  return out;
}

std::vector<std::string> building_warnings(const ConditionedMotion& motion, double period) {
  std::vector<std::string> warnings;
  if (!(period > 0.0)) return warnings;
  const double frequency = 1.0 / period;
  if (period < least_samples * motion.record_interval * (1.0 - 1e-9))
    warnings.push_back(
        fmt::format("the record's step of {:g} s is too coarse for a building of {:.4g} s: {:.2g} samples in "
                    "its period, {:g} "
                    "are needed",
                    motion.record_interval, period, period / motion.record_interval, least_samples));
  if (motion.high_pass && usable_above * *motion.high_pass > frequency)
    warnings.push_back(
        fmt::format("the high-pass corner of {:g} Hz takes away motion at the building's frequency, {:.4g} "
                    "Hz (usable above "
                    "{:g} of the corner)",
                    *motion.high_pass, frequency, usable_above));
  if (motion.low_pass && *motion.low_pass < frequency)
    warnings.push_back(
        fmt::format("the low-pass corner of {:g} Hz is below the building's frequency, {:.4g} Hz",
                    *motion.low_pass, frequency));
  return warnings;
}

GroundMotion ConditionedMotion::ground_motion(const EndOptions& end) const {
  std::optional<std::span<const double>> up;
  if (vertical) up = *vertical;
  return GroundMotion(horizontal, up, interval, end);
}

}  // namespace dougong::seismic
