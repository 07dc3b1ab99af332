// A layout: a parametric generator from named parameters to a Building.
//
// Every layout is one row of layouts(): its name, what it is, how it is counted into storeys, its
// parameters (with dimension, default, range and meaning) and the function that places the blocks.
// Values arrive in SI; the dimension says how they are printed and read at the border. A parameter with
// choices takes one of their words; its value is the place of that word among them. A parameter that is text,
// as the pattern of a wall, has the text as its value, and the layout judges it.
//
// Every layout also has the parameters of the fittings (fittings.h): isolation and dampers, which are built
// into whatever the generator made.
//
// Adding a layout: one file that defines it, one line in layouts.cpp, one section in docs/layouts.md.
#pragma once

#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
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
  std::string meaning;                    // one line
  std::vector<std::string> choices = {};  // words; empty: a number or text
  std::string text = {};                  // the default of one that is text; empty: it is none
  bool is_text() const { return !text.empty(); }
};

/// A number (SI, the place of a word) or text.
struct ParameterValue {
  double number = 0.0;
  std::string text = {};

  ParameterValue() = default;
  template <class Number>
  requires std::is_arithmetic_v<Number> ParameterValue(Number value) : number(static_cast<double>(value)) {}
  ParameterValue(std::string value) : text(std::move(value)) {}
  ParameterValue(const char* value) : text(value) {}
  friend bool operator==(const ParameterValue&, const ParameterValue&) = default;
};
ParameterValue standard_of(const Parameter& parameter);

/// A parameter that takes one of these words, the first unless told otherwise.
Parameter choice(std::string name, std::vector<std::string> words, std::string meaning);
/// A parameter that is text, with its default.
Parameter text(std::string name, std::string standard, std::string meaning);
/// "length", "one of running, stack, English", "text".
std::string kind_of(const Parameter& parameter);
/// The text, the word, or the number with its unit. For a choice the value must be the place of a word.
std::string print_value(const Parameter& parameter, const ParameterValue& value);

using ParameterMap = std::map<std::string, ParameterValue>;

/// A complete set of values: one for every parameter of the layout, each within its range.
class ParameterValues {
 public:
  ParameterValues(ParameterMap values, std::map<std::string, std::string> words)
      : values_(std::move(values)), words_(std::move(words)) {}
  double operator()(const std::string& name) const { return values_.at(name).number; }
  std::size_t count(const std::string& name) const {
    return static_cast<std::size_t>(values_.at(name).number);
  }
  /// Of a choice, or a text.
  const std::string& word(const std::string& name) const { return words_.at(name); }
  bool is(const std::string& name, std::string_view word) const { return words_.at(name) == word; }
  const ParameterMap& all() const { return values_; }

 private:
  ParameterMap values_;
  std::map<std::string, std::string> words_;
};

struct Layout {
  std::string name;
  std::string summary;   // what the building is, one line
  std::string counting;  // how its storeys are counted, one or two sentences
  std::vector<Parameter> parameters;
  Building (*generate)(const ParameterValues&) = nullptr;
  std::string structural_type = {};  // for the limits of standards (code_screen.h); empty: none are for it

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
/// Null for a name that is none of theirs, as of a building by hand.
const Layout* known_layout(const std::string& name);
/// Throws LayoutError for an unknown name.
const Layout& find_layout(const std::string& name);
/// The given values completed by the defaults; where a material is chosen, by what it says. Throws
/// LayoutError for an unknown parameter, a value that is not finite or out of range, or a count that is not
/// whole.
ParameterValues complete_parameters(const Layout& layout, const ParameterMap& given);
/// Throws what complete_parameters throws, and LayoutError for values that do not fit each other.
Building build_layout(const std::string& name, const ParameterMap& parameters = {});
/// A parameter's value from its word. Throws LayoutError for a word that is none of its choices.
double value_of_word(const Parameter& parameter, const std::string& word);

}  // namespace dougong::structures
