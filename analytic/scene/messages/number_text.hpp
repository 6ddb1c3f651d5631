#pragma once

#include <array>
#include <charconv>
#include <string>

namespace rockstack {

/// The shortest decimal text that reads back to the same double, "inf", "-inf" and "nan" too.
inline std::string number_text(double value) {
  std::array<char, 32> buffer{};
  return {buffer.begin(), std::to_chars(buffer.begin(), buffer.end(), value).ptr};
}

/// With so many significant digits.
inline std::string number_text(double value, int digits) {
  std::array<char, 32> buffer{};
  constexpr auto form = std::chars_format::general;
  return {buffer.begin(), std::to_chars(buffer.begin(), buffer.end(), value, form, digits).ptr};
}

/// The nearest number with two significant digits that is not less, or not more, but for rounding. Of what is
/// positive and finite; else the value itself.
double two_digits_up(double value);
double two_digits_down(double value);

/// A quantity in the unit that suits its size, with so many significant digits: of "m" 3.67 is "3.67 m",
/// 0.086 is "86 mm", 1e-4 is "0.1 mm"; "0 m" where it is less than 10⁻¹², which is rounding.
std::string quantity_text(double value, const std::string& unit, int digits = 3);

/// Text of a number as people write it, its exponent as a power of ten: of "3.1e-05" "3.1 × 10⁻⁵".
std::string with_power(const std::string& number);

/// Text of a quantity with its sign in front, "+" too: "+0.4 ms".
std::string signed_quantity_text(double value, const std::string& unit, int digits = 3);

}  // namespace rockstack
