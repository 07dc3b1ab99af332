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

/// A count as a header states it; 0 for one that is not positive.
std::size_t sample_count(double stated);

void throw_if_any(std::vector<InputProblem>&& problems);

/// Samples times factor; file, checksum and format into the provenance.
Record make_record(const FileText& text, std::string_view format, std::vector<double> values, double factor,
                   double interval);

/// Takes the whole-record mean off and says so, when the options ask for it (or by default, unless they
/// forbid it).
void remove_recorded_offset(Record& record, bool by_default, const ReadOptions& options);

}  // namespace dougong::seismic
