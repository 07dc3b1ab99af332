#include "seismic/time_text.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "seismic/numerics/parse_number.h"

namespace dougong::seismic {
namespace {

using std::chrono::milliseconds;

std::string text_of(std::chrono::sys_days date, int hour, int minute, double second, std::string_view zone) {
  if (hour < 0 || hour > 24 || minute < 0 || minute > 59 || !(std::abs(second) < 86400.0)) return {};
  const auto time = date + std::chrono::hours(hour) + std::chrono::minutes(minute) +
                    milliseconds(std::llround(second * 1000.0));
  const auto day = std::chrono::floor<std::chrono::days>(time);
  const std::chrono::year_month_day on(day);
  const std::chrono::hh_mm_ss at(std::chrono::duration_cast<milliseconds>(time - day));
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}{}", static_cast<int>(on.year()),
                     static_cast<unsigned>(on.month()), static_cast<unsigned>(on.day()), at.hours().count(),
                     at.minutes().count(), at.seconds().count(), at.subseconds().count(), zone);
}

// Runs of digits, a point and digits behind one taken along from the sixth on (the seconds).
std::vector<std::string_view> numbers_in(std::string_view text) {
  constexpr std::size_t most = 6;
  std::vector<std::string_view> runs;
  const auto is_digit = [&](std::size_t i) {
    return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i]));
  };
  for (std::size_t i = 0; i < text.size() && runs.size() < most;) {
    std::size_t end = i;
    while (is_digit(end)) ++end;
    if (end == i) {
      ++i;
      continue;
    }
    const bool seconds = runs.size() + 1 >= most || (end - i == 6 && runs.size() == 1);
    if (seconds && end < text.size() && text[end] == '.')
      for (++end; is_digit(end);) ++end;
    runs.push_back(text.substr(i, end - i));
    i = end;
  }
  return runs;
}

int integer(std::string_view digits) {
  return static_cast<int>(leading_number(digits.substr(0, 6)).value_or(-1.0));
}

// "20230206", "011732.5" -> six parts.
std::vector<std::string_view> spread(const std::vector<std::string_view>& runs) {
  if (runs.size() != 2 || runs[0].size() != 8 || runs[1].size() < 6) return runs;
  return {runs[0].substr(0, 4), runs[0].substr(4, 2), runs[0].substr(6, 2),
          runs[1].substr(0, 2), runs[1].substr(2, 2), runs[1].substr(4)};
}

int full_year(std::string_view digits) {
  const int year = integer(digits);
  return digits.size() > 2 ? year : year < 30 ? 2000 + year : 1900 + year;
}

}  // namespace

std::string iso_time(int year, int month, int day, int hour, int minute, double second,
                     std::string_view zone) {
  if (year < 1850 || year > 9999 || month < 1 || day < 1) return {};
  const std::chrono::year_month_day date{std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  return date.ok() ? text_of(date, hour, minute, second, zone) : std::string{};
}

std::string iso_time_of_day(int year, int day_of_year, int hour, int minute, double second,
                            std::string_view zone) {
  if (year < 1850 || year > 9999 || day_of_year < 1 || day_of_year > 366) return {};
  const std::chrono::sys_days first = std::chrono::year(year) / std::chrono::January / 1;
  return text_of(first + std::chrono::days(day_of_year - 1), hour, minute, second, zone);
}

std::string iso_time_in(std::string_view text, DateOrder order, std::string_view zone, double later) {
  const std::vector<std::string_view> parts = spread(numbers_in(text.substr(0, 200)));
  if (parts.size() < 5) return {};
  constexpr std::array<std::array<std::size_t, 3>, 3> places = {{{0, 1, 2}, {2, 0, 1}, {2, 1, 0}}};
  const auto& [year, month, day] = places[static_cast<std::size_t>(order)];
  const double second = parts.size() > 5 ? leading_number(parts[5]).value_or(0.0) : 0.0;
  return iso_time(full_year(parts[year]), integer(parts[month]), integer(parts[day]), integer(parts[3]),
                  integer(parts[4]), second + later, zone);
}

std::string shifted_time(const std::string& iso, double later) {
  constexpr std::size_t zone_at = 23;  // behind "2018-01-24T19:51:28.000"
  double east = 0.0;
  if (iso.size() >= zone_at + 6 && (iso[zone_at] == '+' || iso[zone_at] == '-')) {
    const double hours = leading_number(iso.substr(zone_at + 1, 2)).value_or(0.0);
    const double minutes = leading_number(iso.substr(zone_at + 4, 2)).value_or(0.0);
    east = (iso[zone_at] == '-' ? -60.0 : 60.0) * (60.0 * hours + minutes);
  }
  return iso_time_in(iso.substr(0, zone_at), DateOrder::year_month_day, "", later - east);
}

}  // namespace dougong::seismic
