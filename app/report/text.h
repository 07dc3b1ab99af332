// Numbers and words as they are printed: the one border where SI turns into g, %, mm and kN.
//
// Nothing here looks at the locale. exact() reads back to the same double; the others round to what a
// reader can use. Signs are kept: "+" and a true minus sign "−".
#pragma once

#include <string>
#include <string_view>

namespace dougong::app {

/// Shortest decimal that reads back to the same double ("nan", "inf", "-inf" otherwise).
std::string exact(double value);
/// Fixed decimals with a true minus sign, never "−0.00"; "n/a" when not finite.
std::string fixed(double value, int decimals);
/// As fixed, with "+" in front of positive values.
std::string signed_fixed(double value, int decimals);
/// Rounded to so many significant digits; powers of ten ("3.2 × 10⁻⁷") outside 1e-4 .. 1e6.
std::string significant(double value, int digits);

std::string drift_percent(double ratio);          // "+0.42 %"
std::string drift_fraction(double ratio);         // "1/238", "0" when below 1/100000
std::string acceleration_g(double acceleration);  // m/s2 -> "+0.412 g"
std::string seconds(double time);                 // "6.31 s"
/// A size without a sign: "12.3 mm", "1.32 m".
std::string length(double metres);
/// Metres, printed in mm below 1 m: "+12.3 mm", "−1.32 m".
std::string displacement(double metres);
std::string mass_text(double kilograms);  // "850 kg", "12.4 t"

/// As it is set on a page: "-3.1 m/s2" becomes "−3.1 m/s²".
std::string typeset(std::string_view text);
/// Text made safe for HTML and SVG, in content and in quoted attributes.
std::string escape_markup(std::string_view text);
/// At most so many characters, the last of them an ellipsis when something was cut.
std::string shortened(std::string_view text, std::size_t most);
/// A count with its noun.
std::string plural(std::size_t count, std::string_view noun);  // "1 block", "3 blocks"

}  // namespace dougong::app
