#include "analytic/scene/messages/number_text.hpp"

#include <cmath>

namespace rockstack {
namespace {

struct Prefix {
  const char* letter;
  double factor;
  double least;  ///< from which on it is used
};

/// A tenth of a millimetre, and of a millisecond, is said so.
constexpr std::array<Prefix, 4> prefixes{
    {{"", 1, 1}, {"m", 1e-3, 0.999e-4}, {"µ", 1e-6, 0.999e-7}, {"n", 1e-9, 0}}};
constexpr double rounding = 1e-12;

double last_digit(double value, int digits) {
  return std::pow(10, std::floor(std::log10(std::abs(value))) + 1 - digits);
}

double rounded(double value, int digits) {
  const double unit = last_digit(value, digits);
  return std::round(value / unit) * unit;
}

/// A number that is two digits already, but for `share` of it, stays so.
template <class Round>
double two_digits(double value, double share, const Round& round) {
  if (!(value > 0) || !std::isfinite(value)) return value;
  const double unit = last_digit(value, 2);
  return unit * round(value / unit * (1 + share));
}

std::string plain_text(double value, int digits) {
  std::array<char, 64> buffer{};
  const bool whole = std::abs(value) >= std::pow(10, digits);
  const auto form = whole ? std::chars_format::fixed : std::chars_format::general;
  return {buffer.begin(), std::to_chars(buffer.begin(), buffer.end(), value, form, whole ? 0 : digits).ptr};
}

}  // namespace

double two_digits_up(double value) {
  return two_digits(value, -1e-9, [](double number) { return std::ceil(number); });
}

double two_digits_down(double value) {
  return two_digits(value, 1e-9, [](double number) { return std::floor(number); });
}

std::string quantity_text(double value, const std::string& unit, int digits) {
  if (std::abs(value) < rounding) return "0 " + unit;
  if (!std::isfinite(value)) return plain_text(value, digits) + " " + unit;
  const double shown = rounded(value, digits);
  const Prefix* prefix = prefixes.begin();
  while (std::abs(shown) < prefix->least) ++prefix;
  return plain_text(shown / prefix->factor, digits) + " " + prefix->letter + unit;
}

std::string with_power(const std::string& number) {
  static constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  const std::size_t mark = number.find('e');
  if (mark == std::string::npos) return number;
  const int exponent = std::stoi(number.substr(mark + 1));
  std::string text = number.substr(0, mark) + " × 10" + (exponent < 0 ? "⁻" : "");
  for (const char digit : std::to_string(std::abs(exponent)))
    text += digits.at(static_cast<std::size_t>(digit - '0'));
  return text;
}

std::string signed_quantity_text(double value, const std::string& unit, int digits) {
  return (value >= rounding ? "+" : "") + quantity_text(value, unit, digits);
}

}  // namespace rockstack
