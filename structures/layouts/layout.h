// A layout: a parametric generator from named parameters to a Building.
//
// Every layout is one row of layouts(): its name, what it is, how it is counted into storeys, its
// parameters (with dimension, default, range and meaning) and the function that places the blocks.
// Values arrive in SI; the dimension says how they are printed and read at the border.
//
// Adding a layout: one file that defines it, one line in layouts.cpp, one section in docs/layouts.md.
#pragma once

#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "structures/building.h"
#include "structures/units.h"

namespace dougong::structures {

struct Parameter {
  std::string name;
  Dimension dimension = Dimension::ratio;
  double standard = 0.0;  // the default, SI
  double least = 0.0;     // SI, allowed range, both ends included
  double most = 0.0;
  std::string meaning;  // one line
};

using ParameterMap = std::map<std::string, double>;  // SI

/// A complete set of values: one for every parameter of the layout, each within its range.
class ParameterValues {
 public:
  explicit ParameterValues(ParameterMap values) : values_(std::move(values)) {}
  double operator()(const std::string& name) const { return values_.at(name); }
  std::size_t count(const std::string& name) const { return static_cast<std::size_t>(values_.at(name)); }
  const ParameterMap& all() const { return values_; }

 private:
  ParameterMap values_;
};

struct Layout {
  std::string name;
  std::string summary;   // what the building is, one line
  std::string counting;  // how its storeys are counted, one or two sentences
  std::vector<Parameter> parameters;
  Building (*generate)(const ParameterValues&) = nullptr;

  /// Null when the layout has no parameter of that name.
  const Parameter* parameter(const std::string& name) const;
};

/// What a layout was asked for and cannot give.
class LayoutError : public std::invalid_argument {
 public:
  LayoutError(std::string subject, std::string expected, std::string found, std::string nearest = {});

  std::string subject;  // the parameter, or "layout"
  std::string expected;
  std::string found;
  std::string nearest;  // the known name that was probably meant; may be empty
};

std::span<const Layout> layouts();
/// Throws LayoutError for an unknown name.
const Layout& find_layout(const std::string& name);
/// The given values completed by the defaults. Throws LayoutError for an unknown parameter, a value
/// that is not finite or out of range, or a count that is not whole.
ParameterValues complete_parameters(const Layout& layout, const ParameterMap& given);
/// Throws what complete_parameters throws, and LayoutError for values that do not fit each other.
Building build_layout(const std::string& name, const ParameterMap& parameters = {});

}  // namespace dougong::structures
