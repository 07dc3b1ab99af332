// Where the channels of a volume (volumes.h) begin and end, and their numbers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "seismic/formats/even_steps.h"
#include "seismic/formats/file_text.h"
#include "seismic/input_error.h"

namespace dougong::seismic {

/// Lines of one channel, as indices.
struct VolumeChannel {
  std::size_t start = 0;   // first line of its header
  std::size_t stated = 0;  // line that states its number of points
  std::size_t data = 0;    // first line of data
  std::size_t points = 0;
  double interval = 0.0;  // s; volume 1: not stated, 0
  std::string units;      // as found
};

/// The acceleration of every channel of volume 2.
std::vector<VolumeChannel> corrected_channels(const FileText& text);
/// Index of a header behind the mark "/&" that ends the last channel; nothing when none begins there.
std::optional<std::size_t> unfinished_header(const FileText& text, const VolumeChannel& last);
/// True when the last titled block of volume 2, whatever its quantity, has fewer lines than it states.
bool ends_within_a_block(const FileText& text);

/// Every channel of volume 1, of so many fields a point (2: time and value). A header without 50 reals below
/// "NO. OF POINTS" is a problem.
std::vector<VolumeChannel> uncorrected_channels(const FileText& text, std::size_t fields,
                                                std::vector<InputProblem>& problems);

/// Values in the format that the channel's title states, else 8F10.
std::vector<double> corrected_values(const FileText& text, const VolumeChannel& channel,
                                     std::vector<InputProblem>& problems);

/// Pairs of time and value in fields of the width of their first line, at equal steps.
EvenSeries uncorrected_pairs(const FileText& text, const VolumeChannel& channel,
                             std::optional<double> interval, std::vector<InputProblem>& problems);
/// Values alone in such fields.
std::vector<double> uncorrected_values(const FileText& text, const VolumeChannel& channel,
                                       std::vector<InputProblem>& problems);

}  // namespace dougong::seismic
