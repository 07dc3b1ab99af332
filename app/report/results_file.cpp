#include "app/report/results_file.h"

#include <type_traits>
#include <utility>

#include "app/report/hdf5.h"
#include "app/report/results_fields.h"
#include "app/report/results_writer.h"
#include "app/report/safe_file.h"

namespace dougong::app {
namespace {

using engine::Vec2;
using structures::VerdictKind;

constexpr const char* format_name = "dougong results";

constexpr VerdictKind verdict_kinds[] = {VerdictKind::survived, VerdictKind::collapsed,
                                         VerdictKind::numerically_invalid, VerdictKind::undecided};

VerdictKind verdict_named(const std::string& text) {
  for (const VerdictKind kind : verdict_kinds) {
    if (structures::to_string(kind) == text) return kind;
  }
  throw h5::Error("unknown verdict \"" + text + "\"");
}

structures::CollapseMode mode_named(const std::string& text) {
  for (const structures::CollapseMode mode : structures::collapse_modes)
    if (structures::to_string(mode) == text) return mode;
  throw h5::Error("unknown mode of collapse \"" + text + "\"");
}

/// Walks a RunResult and fills it.
class Reader {
 public:
  explicit Reader(hid_t here) : here_(here) {}

  template <class Inner>
  void group(const std::string& name, Inner inner) {
    const h5::Handle below = h5::open_group(here_, name);
    const hid_t above = std::exchange(here_, below);
    inner();
    here_ = above;
  }
  template <class T>
  void optional_field(const std::string& name, const char* unit, T& value) {
    if (h5::has(here_, name)) field(name, unit, value);
  }
  template <class Inner>
  void optional_group(const std::string& name, Inner inner) {
    if (h5::has(here_, name)) group(name, inner);
  }
  template <class Rows, class Inner>
  void table(const std::string& name, Rows& rows, Inner inner) {
    rows.clear();
    group(name, inner);
  }
  template <class Rows, class Inner>
  void rows(const std::string& name, Rows& rows, Inner inner) {
    rows.clear();
    group(name, [&] {
      while (h5::has(here_, std::to_string(rows.size()))) {
        group(std::to_string(rows.size()), [&] { inner(rows.emplace_back()); });
      }
    });
  }
  template <class Row, class T>
  void column(const std::string& name, const char* unit, std::vector<Row>& rows, T Row::*member) {
    std::vector<T> values = column_of<T>(name, unit, rows);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].*member = std::move(values[i]);
  }
  template <class Row, class Member, class T>
  void column(const std::string& name, const char* unit, std::vector<Row>& rows, Member Row::*member,
              T Member::*part) {
    const std::vector<T> values = column_of<T>(name, unit, rows);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].*member.*part = values[i];
  }
  /// One that older files lack: its rows keep what they hold.
  template <class Row, class T>
  void optional_column(const std::string& name, const char* unit, std::vector<Row>& rows, T Row::*member) {
    if (h5::has(here_, name)) column(name, unit, rows, member);
  }

  void field(const std::string& name, const char*, double& value) {
    value = one(h5::read_numbers(here_, name), name);
  }
  void field(const std::string& name, const char*, std::size_t& value) {
    value = static_cast<std::size_t>(one(h5::read_integers(here_, name), name));
  }
  void field(const std::string& name, const char*, bool& value) {
    value = one(h5::read_integers(here_, name), name) != 0;
  }
  void field(const std::string& name, const char*, std::string& text) {
    text = one(h5::read_texts(here_, name), name);
  }
  void field(const std::string& name, const char*, VerdictKind& kind) {
    kind = verdict_named(one(h5::read_texts(here_, name), name));
  }
  void field(const std::string& name, const char*, structures::CollapseMode& mode) {
    mode = mode_named(one(h5::read_texts(here_, name), name));
  }
  void field(const std::string& name, const char*, std::optional<double>& value) {
    value.reset();
    if (h5::has(here_, name)) value = one(h5::read_numbers(here_, name), name);
  }
  void field(const std::string& name, const char*, std::vector<double>& values) {
    values = h5::read_numbers(here_, name);
  }
  void field(const std::string& name, const char*, std::vector<Vec2>& values) {
    const std::vector<double> flat = h5::read_numbers(here_, name);
    values.resize(flat.size() / 2);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = {flat[2 * i], flat[2 * i + 1]};
  }
  void field(const std::string& name, const char*, std::vector<std::string>& texts) {
    texts = h5::read_texts(here_, name);
  }
  template <class Integer>
  requires std::is_integral_v<Integer>
  void field(const std::string& name, const char*, std::vector<Integer>& values) {
    values.clear();
    for (const std::int64_t wide : h5::read_integers(here_, name))
      values.push_back(static_cast<Integer>(wide));
  }
  void field(const std::string& name, const char* unit, std::vector<std::vector<Vec2>>& lists) {
    std::vector<Vec2> all;
    std::vector<std::size_t> counts;
    field(name, unit, all);
    field(name + "_count", "", counts);
    auto next = all.begin();
    for (const std::size_t count : counts) {
      if (count > static_cast<std::size_t>(all.end() - next))
        throw h5::Error("column " + name + " is cut short");
      const auto end = next + static_cast<std::ptrdiff_t>(count);
      lists.emplace_back(next, end);
      next = end;
    }
  }
  void matrix(const std::string& name, const char*, std::vector<double>& values,
              std::initializer_list<std::size_t>) {
    values = h5::read_numbers(here_, name);
  }

 private:
  /// As long as the table, which the first of its columns makes so.
  template <class T, class Row>
  std::vector<T> column_of(const std::string& name, const char* unit, std::vector<Row>& rows) {
    std::vector<T> values;
    field(name, unit, values);
    if (rows.empty()) rows.resize(values.size());
    if (rows.size() != values.size())
      throw h5::Error("column " + name + " has another length than its table");
    return values;
  }
  template <class T>
  static T one(std::vector<T> values, const std::string& name) {
    if (values.size() != 1) throw h5::Error("dataset " + name + " is not a single value");
    return std::move(values.front());
  }

  hid_t here_;
};

void check_format(hid_t file) {
  if (h5::read_text_attribute(file, "format") != format_name) throw h5::Error("not a dougong results file");
  const std::int64_t version = h5::read_integer_attribute(file, "format_version");
  if (version > results_format_version) {
    throw h5::Error("results format " + std::to_string(version) + " is newer than this program reads (" +
                    std::to_string(results_format_version) + ")");
  }
}

std::string results_image(const RunResult& run) {
  const h5::Handle file = h5::new_file_in_memory();
  h5::write_text_attribute(file, "format", format_name);
  h5::write_integer_attribute(file, "format_version", results_format_version);
  ResultsWriter writer(file);
  walk_run(writer, run);
  return h5::image(file);
}

}  // namespace

void write_results(const RunResult& run, const std::filesystem::path& path) {
  const h5::Quiet quiet;
  std::string bytes;
  try {
    bytes = results_image(run);
  } catch (const h5::Error& error) {
    throw FileError(path, "write", error.what());
  }
  write_file(path, bytes);
}

RunResult read_results(const std::filesystem::path& path) {
  const h5::Quiet quiet;
  if (!std::filesystem::exists(path)) throw FileError(path, "read", "no such file");
  try {
    const h5::Handle file = h5::open_file(path);
    check_format(file);
    RunResult run;
    Reader reader(file);
    walk_run(reader, run);
    return run;
  } catch (const h5::Error& error) {
    throw FileError(path, "read", error.what());
  }
}

}  // namespace dougong::app
