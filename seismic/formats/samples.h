// What every reader does with its numbers: collect them, check their count, put them into a record.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "seismic/formats/file_text.h"
#include "seismic/input_error.h"
#include "seismic/read_record.h"
#include "seismic/record.h"

namespace dougong::seismic {

/// All numbers on lines [first, last); a field that is no finite number becomes a problem. Blank lines are
/// passed over.
std::vector<double> collect_numbers(const FileText& text, std::size_t first, std::size_t last,
                                    std::vector<InputProblem>& problems);

/// Fewer values than the header states is a problem, more are dropped with a warning.
void check_count(const FileText& text, std::size_t stated, std::size_t line, std::vector<double>& values,
                 std::vector<InputProblem>& problems, std::vector<std::string>& warnings);

/// A record needs two samples, a positive finite step, and a step that agrees with the caller's, if any.
void check_series(const FileText& text, std::size_t samples, double interval, std::size_t line,
                  const ReadOptions& options, std::vector<InputProblem>& problems);

/// A file that states its units needs none from the caller; others than its own are a problem.
void check_stated_units(const FileText& text, std::string_view stated, const ReadOptions& options,
                        std::vector<InputProblem>& problems);

/// m/s2 per unit that the file states; a word that is no unit of acceleration is a problem (and 1).
double stated_factor(const FileText& text, std::string_view stated, std::size_t line,
                     const ReadOptions& options, std::vector<InputProblem>& problems);

/// m/s2 per unit of a file that does not say: from the caller's units, and for counts their scale. Without
/// them a problem names the option; `hint` is what the file says all the same.
double declared_factor(const FileText& text, const std::string& hint, const ReadOptions& options,
                       std::vector<InputProblem>& problems);

/// A count as a header states it; 0 for one that is not positive.
std::size_t sample_count(double stated);

void throw_if_any(std::vector<InputProblem>&& problems);

/// Samples times factor; file, checksum, format, units and scale into the provenance.
Record make_record(const FileText& text, std::string_view format, std::vector<double> values, double factor,
                   double interval, std::string units);

/// What a reader knows of one channel once it has its numbers.
struct ChannelSamples {
  std::string_view format;
  std::string component, units;
  std::vector<double> values;  // in the file's units
  double factor = 1.0;         // m/s2 per unit
  double interval = 0.0;       // s
  std::size_t line = 0;        // from 1, that states interval and count
};

/// Its record, checked (check_series) and named. Throws InputError with all the problems so far.
Record make_channel(const FileText& text, ChannelSamples samples, const ReadOptions& options,
                    std::vector<InputProblem>&& problems);

/// The component's name with what follows from it: axis and azimuth.
void name_component(Record& record, std::string component);

/// Takes the whole-record mean off and says so, when the options ask for it (or by default, unless they
/// forbid it).
void remove_recorded_offset(Record& record, bool by_default, const ReadOptions& options);

/// Warns when the samples (less their mean, if asked) do not reach the peak that the header states, by more
/// than `printed`, the unit of its last digit (all m/s2), and 1e-4 of it.
void check_stated_peak(Record& record, double stated, double printed, bool without_mean = false);

}  // namespace dougong::seismic
