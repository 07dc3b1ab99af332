#include "app/study/target_choice.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "app/study/quantity.h"
#include "app/study/word_keys.h"
#include "seismic/design/asce7.h"
#include "seismic/design/eurocode8.h"
#include "seismic/design/gb50011.h"
#include "seismic/design/japan.h"
#include "seismic/design/spectrum_table.h"
#include "seismic/formats/file_text.h"
#include "seismic/input_error.h"
#include "seismic/numerics/parse_number.h"
#include "seismic/units.h"

namespace dougong::app {
namespace {

using seismic::DesignSpectrum;

using Keys = WordKeys;

double damping_key(Keys& keys) {
  const double value = keys.quantity("damping", Dimension::ratio, 0.05);
  if (!(value >= 0.0 && value < 1.0)) keys.fail("damping: expected a ratio from 0 to 1");
  return value;
}

DesignSpectrum gb(Keys& keys) {
  if (keys.has("alpha-max"))
    return design_spectrum(seismic::Gb50011{keys.positive("alpha-max", Dimension::ratio),
                                            keys.positive("tg", Dimension::time), damping_key(keys)});
  seismic::GbSite site;
  site.intensity = keys.word("intensity", site.intensity);
  site.level = keys.word("level", site.level);
  site.site_class = keys.word("site", site.site_class);
  site.group = keys.number("group", site.group);
  site.damping_ratio = damping_key(keys);
  return design_spectrum(seismic::gb50011(site));
}

DesignSpectrum ec8(Keys& keys) {
  const int type = keys.number("type", 1);
  const std::string ground = keys.word("ground");
  return design_spectrum(
      seismic::eurocode8(type, ground, keys.positive("ag", Dimension::acceleration), damping_key(keys)));
}

DesignSpectrum ec8_vertical(Keys& keys) {
  const int type = keys.number("type", 1);
  return design_spectrum(
      seismic::eurocode8_vertical(type, keys.positive("ag", Dimension::acceleration), damping_key(keys)));
}

DesignSpectrum asce7(Keys& keys) {
  constexpr double g = seismic::standard_gravity;
  const auto in_g = [&](const char* key) { return keys.positive(key, Dimension::acceleration) / g; };
  if (keys.has("sds")) {
    const double sds = in_g("sds"), sd1 = in_g("sd1");
    return design_spectrum(seismic::Asce7{sds, sd1, keys.positive("tl", Dimension::time)});
  }
  const double ss = in_g("ss"), s1 = in_g("s1");
  const std::string site = keys.word("site");
  return design_spectrum(seismic::asce7_16(ss, s1, site, keys.positive("tl", Dimension::time)));
}

DesignSpectrum japan(Keys& keys) {
  const int level = keys.number("level", 2), ground = keys.number("ground", 0);
  return design_spectrum(
      seismic::JapaneseBuilding{level, ground, keys.quantity("zone", Dimension::ratio, 1.0)});
}

DesignSpectrum jra(Keys& keys) {
  const int type = keys.number("type", 1);
  return design_spectrum(seismic::JapaneseBridge{type, keys.number("ground", 1)});
}

DesignSpectrum table(Keys& keys) {
  const std::string file = keys.word("file"), unit = keys.word("unit");
  const auto factor = seismic::acceleration_unit(unit);
  if (!factor) keys.fail("unit: expected g, gal, cm/s2, m/s2 or mm/s2, found \"" + unit + "\"");
  const std::string how = keys.word("interpolation", "linear");
  if (how != "linear" && how != "log")
    keys.fail("interpolation: expected linear or log, found \"" + how + "\"");
  seismic::SpectrumTable rows{file, {}, {}};
  std::istringstream text(seismic::read_bytes(file));
  std::size_t number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    const seismic::NumberLine values = seismic::parse_numbers(line);
    if (values.values.empty() && (line.starts_with('#') || rows.periods.empty() || trimmed(line).empty()))
      continue;
    if (!values.numeric || values.values.size() != 2)
      throw seismic::InputError(file, number, "a period (s) and an acceleration",
                                "\"" + line.substr(0, 60) + "\"");
    rows.periods.push_back(values.values[0]);
    rows.accelerations.push_back(values.values[1] * *factor);
  }
  return design_spectrum(std::move(rows),
                         how == "log" ? seismic::Interpolation::logarithmic : seismic::Interpolation::linear,
                         damping_key(keys));
}

struct Kind {
  const char* name;
  DesignSpectrum (*make)(Keys&);
  const char* example;
};
constexpr Kind kinds[] = {
    {"gb50011", gb, "gb50011: intensity=8, level=rare, site=II, group=2"},
    {"ec8", ec8, "ec8: type=1, ground=C, ag=0.25 g"},
    {"ec8-vertical", ec8_vertical, "ec8-vertical: type=1, ag=0.25 g"},
    {"asce7", asce7, "asce7: sds=1.0 g, sd1=0.6 g, tl=8 s"},
    {"japan", japan, "japan: level=2, ground=2, zone=0.9"},
    {"jra", jra, "jra: type=2, ground=1"},
    {"table", table, "table: file=target.csv, unit=g, interpolation=log"},
};

}  // namespace

DesignSpectrum target_spectrum(const std::string& text, const std::string& where) {
  const auto colon = text.find(':');
  const std::string kind_word = trimmed(text.substr(0, colon));
  const std::string place = where + " " + text;
  Keys keys(place, key_values(colon == std::string::npos ? "" : text.substr(colon + 1), place));
  for (const Kind& kind : kinds) {
    if (kind_word != kind.name) continue;
    DesignSpectrum spectrum = kind.make(keys);
    keys.finish();
    return spectrum;
  }
  std::string known;
  for (const Kind& kind : kinds) known += (known.empty() ? "" : ", ") + std::string(kind.name);
  keys.fail("expected one of " + known + ", found \"" + kind_word + "\"");
}

std::string target_help() {
  std::string help = "Targets:\n";
  for (const Kind& kind : kinds) help += fmt::format("  --target \"{}\"\n", kind.example);
  return help;
}

}  // namespace dougong::app
