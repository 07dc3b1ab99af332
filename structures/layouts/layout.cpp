#include "structures/layouts/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "structures/nearest_name.h"

namespace dougong::structures {
namespace {

std::string sentence(const std::string& subject, const std::string& expected, const std::string& found,
                     const std::string& nearest) {
  std::string text = fmt::format("{}: expected {}, found {}", subject, expected, found);
  if (!nearest.empty()) text += fmt::format("; did you mean \"{}\"?", nearest);
  return text;
}

template <class Items>
LayoutError unknown(const std::string& subject, const std::string& kind, const std::string& found,
                    const Items& known) {
  std::vector<std::string> names;
  for (const auto& item : known) names.push_back(item.name);
  return {subject, fmt::format("{} ({})", kind, fmt::join(names, ", ")), "\"" + found + "\"",
          nearest_name(found, names)};
}

void check_value(const Parameter& parameter, double value) {
  const auto print = [&](double v) { return print_value(v, parameter.dimension); };
  const bool within = parameter.least <= value && value <= parameter.most;  // false for NaN
  const bool whole = parameter.dimension != Dimension::count || value == std::floor(value);
  if (within && whole) return;
  const char* kind = parameter.dimension == Dimension::count ? "a whole number" : "a value";
  throw LayoutError(parameter.name,
                    fmt::format("{} from {} to {}", kind, print(parameter.least), print(parameter.most)),
                    print(value));
}

}  // namespace

LayoutError::LayoutError(std::string subject_, std::string expected_, std::string found_,
                         std::string nearest_)
    : std::invalid_argument(sentence(subject_, expected_, found_, nearest_)),
      subject(std::move(subject_)),
      expected(std::move(expected_)),
      found(std::move(found_)),
      nearest(std::move(nearest_)) {}

const Parameter* Layout::parameter(const std::string& wanted) const {
  const auto it = std::ranges::find(parameters, wanted, &Parameter::name);
  return it == parameters.end() ? nullptr : &*it;
}

const Layout& find_layout(const std::string& name) {
  const auto it = std::ranges::find(layouts(), name, &Layout::name);
  if (it == layouts().end()) throw unknown("layout", "a known layout", name, layouts());
  return *it;
}

ParameterValues complete_parameters(const Layout& layout, const ParameterMap& given) {
  ParameterMap values;
  for (const Parameter& parameter : layout.parameters) values[parameter.name] = parameter.standard;
  for (const auto& [name, value] : given) {
    const Parameter* parameter = layout.parameter(name);
    if (!parameter) throw unknown("layout " + layout.name, "one of its parameters", name, layout.parameters);
    check_value(*parameter, value);
    values[name] = value;
  }
  return ParameterValues(std::move(values));
}

Building build_layout(const std::string& name, const ParameterMap& parameters) {
  const Layout& layout = find_layout(name);
  const ParameterValues values = complete_parameters(layout, parameters);
  Building building = layout.generate(values);
  building.layout = layout.name;
  for (const Parameter& parameter : layout.parameters)
    building.parameters[parameter.name] = print_value(values(parameter.name), parameter.dimension);
  return building;
}

}  // namespace dougong::structures
