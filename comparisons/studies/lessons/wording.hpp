#pragma once

#include <string>

namespace rockstack {

/// A number with that many digits after the point, and a true minus sign: "−0.4816".
std::string fixed(double value, int digits);

/// A number as digits times a power of ten, "3.1 × 10⁻⁵"; 0 as "0".
std::string power(double value, int digits);

/// A share as per cent, "29.5 %".
std::string percent(double share, int digits);

/// A cell of a table: a number with all its digits.
std::string cell(double value);

/// The same, 0 where the number is rounding beside `scale`.
std::string cell(double value, double scale);

}  // namespace rockstack
