#include "seismic/formats/miniseed.h"

#include <fmt/format.h>
#include <libmseed.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "seismic/formats/samples.h"
#include "seismic/formats/station_xml.h"
#include "seismic/orientation.h"
#include "seismic/units.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t shortest_header = 48;  // bytes of the fixed section
constexpr int written_record = 4096;         // bytes
constexpr double most_samples_a_byte = 2.0;  // Steim 2 packs seven into four bytes

struct RecordFree {
  void operator()(MSRecord* record) const { msr_free(&record); }
};
struct ListFree {
  void operator()(MSTraceList* list) const { mstl_free(&list, 0); }
};
using TraceList = std::unique_ptr<MSTraceList, ListFree>;

// The library prints what it meets; errors are thrown here instead.
void be_quiet() {
  const auto drop = [](char*) {};
  ms_loginit(drop, nullptr, drop, nullptr);
}

std::string iso_of(hptime_t time) {
  std::array<char, 40> text{};
  if (!ms_hptime2isotimestr(time, text.data(), 1)) return {};
  std::string iso = text.data();
  return iso.substr(0, iso.size() > 23 ? 23 : iso.size()) + "Z";
}

[[noreturn]] void refuse(const FileText& text, std::size_t at, const std::string& reason) {
  throw InputError(text.name, 0, fmt::format("a sound miniSEED record at byte {}", at), reason);
}

// One record at `at`: its header first, so that no sample count beyond what its bytes can hold is unpacked.
std::size_t add_record(const FileText& text, std::size_t at, MSTraceList& list) {
  std::string copy(text.bytes, at, MAXRECLEN);
  MSRecord* parsed = nullptr;
  const int size = static_cast<int>(copy.size());
  const int status = msr_parse(copy.data(), size, &parsed, 0, 0, 0);
  const std::unique_ptr<MSRecord, RecordFree> header(parsed);
  if (status != MS_NOERROR || !header || header->reclen < MINRECLEN || header->reclen > size)
    refuse(text, at, status > 0 ? "a cut one" : ms_errorstr(status));
  if (static_cast<double>(header->samplecnt) > most_samples_a_byte * header->reclen)
    refuse(text, at, fmt::format("{} samples in {} bytes", header->samplecnt, header->reclen));
  const int length = header->reclen;
  MSRecord* unpacked = nullptr;
  const int result = msr_unpack(copy.data(), length, &unpacked, 1, 0);
  const std::unique_ptr<MSRecord, RecordFree> record(unpacked);
  if (result != MS_NOERROR || !record) refuse(text, at, ms_errorstr(result));
  if (record->samplecnt > 0 && !mstl_addmsr(&list, record.get(), 0, 1, -1.0, -1.0))
    refuse(text, at, "one that does not fit");
  return static_cast<std::size_t>(length);
}

TraceList read_traces(const FileText& text) {
  be_quiet();
  TraceList list(mstl_init(nullptr));
  for (std::size_t at = 0; at + shortest_header <= text.bytes.size();) at += add_record(text, at, *list);
  return list;
}

template <typename Sample>
std::vector<double> converted(const MSTraceSeg& segment) {
  const auto* first = static_cast<const Sample*>(segment.datasamples);
  return {first, first + segment.numsamples};
}

std::vector<double> samples_of(const FileText& text, const MSTraceSeg& segment) {
  switch (segment.sampletype) {
    case 'i':
      return converted<std::int32_t>(segment);
    case 'f':
      return converted<float>(segment);
    case 'd':
      return converted<double>(segment);
    default:
      throw InputError(text.name, 0, "samples that are numbers", "text");
  }
}

struct Trace {
  SeedChannel name;
  const MSTraceSeg* segment = nullptr;
};

// One stretch of samples; a gap or an overlap would shift all that follows.
Trace trace_of(const FileText& text, const MSTraceID& id) {
  const MSTraceSeg* first = id.first;
  if (!first || first->samplecnt < 1) throw InputError(text.name, 0, "samples", "none");
  if (first->next)
    throw InputError(text.name, 0, fmt::format("one stretch of samples of {}", id.srcname),
                     fmt::format("a gap or overlap after {}", iso_of(first->endtime)));
  return {{id.network, id.station, id.location, id.channel, iso_of(first->starttime)}, first};
}

std::optional<std::filesystem::path> response_file(const FileText& text, const SeedChannel& name,
                                                   const ReadOptions& options) {
  if (options.response) return options.response;
  const auto beside =
      std::filesystem::path(text.name).parent_path() / (name.network + "." + name.station + ".xml");
  std::error_code failed;
  return std::filesystem::is_regular_file(beside, failed) ? std::optional(beside) : std::nullopt;
}

// Counts with a response, or whatever the caller declares.
struct Scale {
  double factor = 1.0;
  std::string units, rule;
  std::optional<ChannelResponse> response;
};

Scale scale_of(const FileText& text, const SeedChannel& name, const ReadOptions& options,
               std::vector<InputProblem>& problems) {
  const bool counts = !options.units || is_counts(*options.units);
  const auto file = counts && !options.count_scale ? response_file(text, name, options) : std::nullopt;
  if (file) {
    const ChannelResponse response = read_response(*file, name);
    return {1.0 / response.sensitivity, "counts",
            fmt::format("1 / {:.10g} m/s2 a count, the overall sensitivity in {}, the response taken as flat",
                        response.sensitivity, file->filename().string()),
            response};
  }
  if (!options.units && options.count_scale) return {*options.count_scale, "counts", {}, std::nullopt};
  const std::string hint =
      "miniSEED holds none; counts need a response, StationXML (option response), or option scale";
  const double factor = declared_factor(text, hint, options, problems);
  return {factor, options.units.value_or("") + " (given by the user)", {}, std::nullopt};
}

Record read_trace(const FileText& text, const Trace& trace, const ReadOptions& options) {
  std::vector<InputProblem> problems;
  Scale scale = scale_of(text, trace.name, options, problems);
  const double rate = trace.segment->samprate;
  const bool counts = scale.units.starts_with("count");
  Record record = make_channel(text,
                               {"miniSEED", trace.name.channel, scale.units, samples_of(text, *trace.segment),
                                scale.factor, rate > 0.0 ? 1.0 / rate : 0.0, 0},
                               options, std::move(problems));
  Provenance& from = record.provenance;
  from.event = from.start_time = trace.name.start_time;
  from.station = trace.name.network + "." + trace.name.station;
  from.sensor = trace.name.location;
  if (!scale.rule.empty()) from.scale = scale.rule;
  if (scale.response) from.station_place = scale.response->place;
  if (scale.response && scale.response->azimuth && record.axis == Axis::horizontal)
    record.azimuth = std::fmod(*scale.response->azimuth, 360.0);
  remove_recorded_offset(record, counts, options);
  return record;
}

// --- writing ---------------------------------------------------------------------------------------

template <std::size_t size>
void copy_code(const std::string& code, char (&field)[size], std::size_t most) {
  const std::size_t length = std::min({code.size(), most, size - 1});
  std::memcpy(field, code.data(), length);
  field[length] = '\0';
}

void keep_record(char* record, int length, void* out) {
  static_cast<std::string*>(out)->append(record, static_cast<std::size_t>(length));
}

hptime_t time_of(const std::string& iso) {
  std::string text = iso.substr(0, 23);
  const hptime_t time = text.empty() ? 0 : ms_timestr2hptime(text.data());
  return time == HPTERROR ? 0 : time;
}

void append_channel(const MiniseedChannel& channel, std::string& out) {
  const std::unique_ptr<MSRecord, RecordFree> record(msr_init(nullptr));
  copy_code(channel.network, record->network, 2);
  copy_code(channel.station, record->station, 5);
  copy_code(channel.location, record->location, 2);
  copy_code(channel.channel, record->channel, 3);
  record->starttime = time_of(channel.start_time);
  record->samprate = 1.0 / channel.interval;
  record->reclen = written_record;
  record->encoding = DE_FLOAT64;
  record->byteorder = 1;
  record->dataquality = 'D';
  record->numsamples = static_cast<std::int64_t>(channel.samples.size());
  record->sampletype = 'd';
  std::vector<double> samples = channel.samples;
  record->datasamples = samples.data();
  std::int64_t packed = 0;
  msr_pack(record.get(), keep_record, &out, &packed, 1, 0);
  record->datasamples = nullptr;  // not the record's to free
}

}  // namespace

bool is_miniseed(const FileText& text) {
  if (text.bytes.size() < shortest_header) return false;
  const char* header = text.bytes.data();
  return MS_ISVALIDHEADER(header);
}

std::vector<Record> read_miniseed(const FileText& text, const ReadOptions& options) {
  const TraceList list = read_traces(text);
  std::vector<Record> records;
  for (const MSTraceID* id = list->traces; id; id = id->next)
    records.push_back(read_trace(text, trace_of(text, *id), options));
  if (records.empty()) throw InputError(text.name, 0, "a miniSEED record with samples", "none");
  return records;
}

std::string write_miniseed(std::span<const MiniseedChannel> channels) {
  be_quiet();
  std::string bytes;
  for (const MiniseedChannel& channel : channels) append_channel(channel, bytes);
  return bytes;
}

}  // namespace dougong::seismic
