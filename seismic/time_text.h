// Dates and times of headers, in the many ways they are written, as ISO 8601 text.
#pragma once

#include <string>
#include <string_view>

namespace dougong::seismic {

enum class DateOrder { year_month_day, month_day_year, day_month_year };

/// "2018-01-24T19:51:28.000+09:00". Empty when there is no such day or time. `second` may lie outside 0 to
/// 60: it is carried over. `zone` is appended as it is: "Z", "+09:00", or nothing when the file does not say.
std::string iso_time(int year, int month, int day, int hour, int minute, double second,
                     std::string_view zone = "");

/// Day of the year from 1.
std::string iso_time_of_day(int year, int day_of_year, int hour, int minute, double second,
                            std::string_view zone = "");

/// From the numbers in a text: "2018/01/24 19:51:43", "20230206_011732.5", "8/24/14, 10:20:33.0 UTC". Years
/// of two digits are of the 20th century from 30 on. Empty when it holds no date and time. `later` (s) is
/// added.
std::string iso_time_in(std::string_view text, DateOrder order, std::string_view zone = "",
                        double later = 0.0);

/// An ISO time with its zone in UTC, `later` s on, without a zone; a time that names none is taken as UTC.
/// Empty for a text that is no time.
std::string shifted_time(const std::string& iso, double later);

}  // namespace dougong::seismic
