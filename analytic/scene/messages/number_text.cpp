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

double rounded(double value, int digits) {
  const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) + 1 - digits);
  return std::round(value / unit) * unit;
}

std::string plain_text(double value, int digits) {
  std::array<char, 64> buffer{};
  const bool whole = std::abs(value) >= std::pow(10, digits);
  const auto form = whole ? std::chars_format::fixed : std::chars_format::general;
  return {buffer.begin(), std::to_chars(buffer.begin(), buffer.end(), value, form, whole ? 0 : digits).ptr};
}

}  // namespace

std::string quantity_text(double value, const std::string& unit, int digits) {
  if (std::abs(value) < rounding) return "0 " + unit;
  if (!std::isfinite(value)) return plain_text(value, digits) + " " + unit;
  const double shown = rounded(value, digits);
  const Prefix* prefix = prefixes.begin();
  while (std::abs(shown) < prefix->least) ++prefix;
  return plain_text(shown / prefix->factor, digits) + " " + prefix->letter + unit;
}

std::string signed_quantity_text(double value, const std::string& unit, int digits) {
  return (value >= rounding ? "+" : "") + quantity_text(value, unit, digits);
}

}  // namespace rockstack
