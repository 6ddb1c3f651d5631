#pragma once

#include <cmath>
#include <cstdint>

namespace rockstack {

/// A whole number as inputs hold it: itself, or the next double further from zero, so that no limit lets pass
/// what no double is.
inline double double_of_whole(std::int64_t value) {
  const auto number = static_cast<double>(value);
  const auto exact = static_cast<long double>(value);
  const bool nearer = std::abs(static_cast<long double>(number)) < std::abs(exact);
  return nearer ? std::nextafter(number, std::copysign(HUGE_VAL, number)) : number;
}

}  // namespace rockstack
