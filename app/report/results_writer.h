// Walks plain data and writes it as groups and datasets of an HDF5 file (see results_fields.h).
#pragma once

#include <type_traits>
#include <utility>

#include "app/report/hdf5.h"
#include "engine/vec2.h"
#include "structures/collapse_mode.h"
#include "structures/verdict.h"

namespace dougong::app {

static_assert(sizeof(engine::Vec2) == 2 * sizeof(double), "a Vec2 is written as two doubles");

/// Walks a const RunResult and writes.
class ResultsWriter {
 public:
  explicit ResultsWriter(hid_t here) : here_(here) {}

  template <class Inner>
  void group(const std::string& name, Inner inner) {
    const h5::Handle below = h5::make_group(here_, name);
    const hid_t above = std::exchange(here_, below);
    inner();
    here_ = above;
  }
  template <class T>
  void optional_field(const std::string& name, const char* unit, const T& value) {
    field(name, unit, value);
  }
  template <class Inner>
  void optional_group(const std::string& name, Inner inner) {
    group(name, inner);
  }
  template <class Rows, class Inner>
  void table(const std::string& name, const Rows&, Inner inner) {
    group(name, inner);
  }
  template <class Rows, class Inner>
  void rows(const std::string& name, const Rows& rows, Inner inner) {
    group(name, [&] {
      for (std::size_t i = 0; i < rows.size(); ++i) group(std::to_string(i), [&] { inner(rows[i]); });
    });
  }
  template <class Row, class T>
  void column(const std::string& name, const char* unit, const std::vector<Row>& rows, T Row::*member) {
    std::vector<T> values;
    for (const Row& row : rows) values.push_back(row.*member);
    field(name, unit, values);
  }
  /// A part of a member.
  template <class Row, class Member, class T>
  void column(const std::string& name, const char* unit, const std::vector<Row>& rows, Member Row::*member,
              T Member::*part) {
    std::vector<T> values;
    for (const Row& row : rows) values.push_back(row.*member.*part);
    field(name, unit, values);
  }
  template <class Row, class T>
  void optional_column(const std::string& name, const char* unit, const std::vector<Row>& rows,
                       T Row::*member) {
    column(name, unit, rows, member);
  }

  void field(const std::string& name, const char* unit, double value) {
    h5::write_numbers(here_, name, unit, {}, &value);
  }
  void field(const std::string& name, const char*, std::size_t value) {
    integer(name, static_cast<std::int64_t>(value));
  }
  void field(const std::string& name, const char*, bool value) { integer(name, value ? 1 : 0); }
  void field(const std::string& name, const char*, const std::string& text) {
    h5::write_texts(here_, name, {}, {text});
  }
  void field(const std::string& name, const char*, structures::VerdictKind kind) {
    field(name, "", structures::to_string(kind));
  }
  void field(const std::string& name, const char*, structures::CollapseMode mode) {
    field(name, "", structures::to_string(mode));
  }
  void field(const std::string& name, const char* unit, const std::optional<double>& value) {
    if (value) field(name, unit, *value);
  }
  void field(const std::string& name, const char* unit, const std::vector<double>& values) {
    h5::write_numbers(here_, name, unit, {values.size()}, values.data());
  }
  void field(const std::string& name, const char* unit, const std::vector<engine::Vec2>& values) {
    h5::write_numbers(here_, name, unit, {values.size(), 2}, values.empty() ? nullptr : &values[0].x);
  }
  void field(const std::string& name, const char*, const std::vector<std::string>& texts) {
    h5::write_texts(here_, name, {texts.size()}, texts);
  }
  template <class Integer>
  requires std::is_integral_v<Integer>
  void field(const std::string& name, const char*, const std::vector<Integer>& values) {
    const std::vector<std::int64_t> wide(values.begin(), values.end());
    h5::write_integers(here_, name, {wide.size()}, wide.data());
  }
  /// Lists of unequal length: all points in one dataset, and how many belong to each.
  void field(const std::string& name, const char* unit, const std::vector<std::vector<engine::Vec2>>& lists) {
    std::vector<engine::Vec2> all;
    std::vector<std::size_t> counts;
    for (const auto& list : lists) {
      counts.push_back(list.size());
      all.insert(all.end(), list.begin(), list.end());
    }
    field(name, unit, all);
    field(name + "_count", "", counts);
  }
  /// Shaped when the sizes agree, flat otherwise.
  void matrix(const std::string& name, const char* unit, const std::vector<double>& values,
              const h5::Shape& shape) {
    hsize_t product = 1;
    for (const hsize_t extent : shape) product *= extent;
    h5::write_numbers(here_, name, unit, product == values.size() ? shape : h5::Shape{values.size()},
                      values.data());
  }

 private:
  void integer(const std::string& name, std::int64_t value) { h5::write_integers(here_, name, {}, &value); }

  hid_t here_;
};

}  // namespace dougong::app
