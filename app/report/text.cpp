#include "app/report/text.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

#include "engine/scene.h"

namespace dougong::app {
namespace {

constexpr std::string_view minus_sign = "−";
constexpr std::string_view not_available = "n/a";

bool prints_as_zero(const std::string& digits) {
  return digits.find_first_of("123456789") == std::string::npos;
}

std::string with_sign(double value, std::string digits, bool plus) {
  if (prints_as_zero(digits)) return digits;
  if (value < 0) return std::string(minus_sign) + digits;
  return plus ? "+" + digits : digits;
}

/// "3.2 × 10⁻⁷"
std::string power_of_ten(double size, int digits) {
  constexpr const char* raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  const std::string plain = fmt::format("{:.{}e}", size, digits - 1);
  const auto mark = plain.find('e');
  std::string out = plain.substr(0, mark) + " × 10" + (plain[mark + 1] == '-' ? "⁻" : "");
  const std::string exponent = std::to_string(std::abs(std::stoi(plain.substr(mark + 1))));
  for (const char digit : exponent) out += raised[digit - '0'];
  return out;
}

}  // namespace

std::string exact(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return std::string(not_available);
  return with_sign(value, fmt::format("{:.{}f}", std::abs(value), decimals), false);
}

std::string signed_fixed(double value, int decimals) {
  if (!std::isfinite(value)) return std::string(not_available);
  return with_sign(value, fmt::format("{:.{}f}", std::abs(value), decimals), true);
}

std::string significant(double value, int digits) {
  if (!std::isfinite(value)) return std::string(not_available);
  const double size = std::abs(value);
  if (size == 0.0) return "0";
  if (size < 1e-4 || size >= 1e6) return with_sign(value, power_of_ten(size, digits), false);
  const int magnitude = static_cast<int>(std::floor(std::log10(size)));
  const double last = std::pow(10.0, magnitude + 1 - digits);
  const bool rounds_up = std::round(size / last) * last >= std::pow(10.0, magnitude + 1);  // 0.9996: 1.00
  return fixed(value, std::max(0, digits - 1 - magnitude - (rounds_up ? 1 : 0)));
}

std::string drift_percent(double ratio) {
  const double percent = 100.0 * ratio;
  return signed_fixed(percent, std::abs(percent) < 0.1 ? 3 : 2) + " %";
}

std::string drift_fraction(double ratio) {
  if (!std::isfinite(ratio)) return std::string(not_available);
  if (std::abs(ratio) < 1e-5) return "0";
  return fmt::format("1/{:.{}f}", 1.0 / std::abs(ratio), std::abs(ratio) > 0.1 ? 1 : 0);
}

std::string acceleration_g(double acceleration) {
  return signed_fixed(acceleration / engine::standard_gravity, 3) + " g";
}

std::string seconds(double time) {
  return fixed(time, 2) + " s";
}

std::string displacement(double metres) {
  if (std::abs(metres) >= 1.0) return signed_fixed(metres, 2) + " m";
  return signed_fixed(1e3 * metres, std::abs(metres) < 0.01 ? 2 : 1) + " mm";
}

std::string length(double metres) {
  const double size = std::abs(metres);
  return size >= 1.0 ? fixed(size, 2) + " m" : fixed(1e3 * size, size < 0.01 ? 2 : 1) + " mm";
}

std::string mass_text(double kilograms) {
  return kilograms < 1000.0 ? significant(kilograms, 3) + " kg" : significant(kilograms / 1000.0, 3) + " t";
}

std::string escape_markup(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t') out += c;
    }
  }
  return out;
}

namespace {

bool is_digit(char c) {
  return '0' <= c && c <= '9';
}
bool is_word(char c) {
  return is_digit(c) || c == '_' || ('a' <= (c | 0x20) && (c | 0x20) <= 'z');
}

/// The typeset form of what stands at the front of `rest`, and how many characters that takes; none: 0.
std::pair<std::string_view, std::size_t> typeset_front(std::string_view rest, char before) {
  if (rest.size() > 1 && rest[0] == '-' && is_digit(rest[1]) && (before == ' ' || before == '('))
    return {"−", 1};
  for (const auto& [plain, raised] :
       {std::pair<std::string_view, std::string_view>{"/s2", "/s²"}, {"/m3", "/m³"}, {"/m2", "/m²"}})
    if (rest.starts_with(plain) && (rest.size() == plain.size() || !is_word(rest[plain.size()])))
      return {raised, plain.size()};
  return {"", 0};
}

}  // namespace

std::string typeset(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const auto [set, taken] = typeset_front(text.substr(i), i == 0 ? ' ' : text[i - 1]);
    if (taken == 0)
      out += text[i++];
    else
      out += set, i += taken;
  }
  return out;
}

std::string shortened(std::string_view text, std::size_t most) {
  std::size_t characters = 0, keep = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool starts_one = (static_cast<unsigned char>(text[i]) & 0xc0) != 0x80;
    if (starts_one && ++characters == most) keep = i;
  }
  return characters <= most ? std::string(text) : std::string(text.substr(0, keep)) + "…";
}

std::string plural(std::size_t count, std::string_view noun) {
  if (count == 1) return fmt::format("1 {}", noun);
  const bool after_consonant =
      noun.size() > 1 && noun.back() == 'y' &&
      std::string_view("aeiou").find(noun[noun.size() - 2]) == std::string_view::npos;
  if (after_consonant) return fmt::format("{} {}ies", count, noun.substr(0, noun.size() - 1));
  return fmt::format("{} {}s", count, noun);
}

}  // namespace dougong::app
