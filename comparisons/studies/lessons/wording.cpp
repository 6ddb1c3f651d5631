#include "comparisons/studies/lessons/wording.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace rockstack {
namespace {

std::string superscript(int number) {
  static constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = number < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(number)))
    text += digits.at(static_cast<std::size_t>(digit - '0'));
  return text;
}

}  // namespace

std::string fixed(double value, int digits) {
  const std::string text = fmt::format("{:.{}f}", std::abs(value), digits);
  const bool zero = text.find_first_not_of("0.") == std::string::npos;
  return (value < 0 && !zero ? "−" : "") + text;
}

std::string power(double value, int digits) {
  if (value == 0) return "0";
  const std::string text = fmt::format("{:.{}e}", std::abs(value), digits);
  const std::size_t mark = text.find('e');
  return (value < 0 ? "−" : "") + text.substr(0, mark) + " × 10" +
         superscript(std::stoi(text.substr(mark + 1)));
}

std::string percent(double share, int digits) {
  return fixed(100 * share, digits) + " %";
}

std::string cell(double value) {
  return fmt::format("{}", value);
}

std::string cell(double value, double scale) {
  constexpr double rounding = 1e-12;
  return cell(std::abs(value) < rounding * scale ? 0 : value);
}

}  // namespace rockstack
