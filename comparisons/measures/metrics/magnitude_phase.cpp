#include "comparisons/measures/metrics/magnitude_phase.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rockstack {

MagnitudePhase magnitude_phase(const History& exact, const History& other) {
  const std::size_t count = std::min(exact.angles.size(), other.angles.size());
  double exact_square = 0, other_square = 0;
  for (std::size_t i = 0; i < count; ++i) {
    exact_square += exact.angles[i] * exact.angles[i];
    other_square += other.angles[i] * other.angles[i];
  }
  const double exact_length = std::sqrt(exact_square), other_length = std::sqrt(other_square);
  // The angle by the half sum and half difference of unit vectors: the arc cosine loses small angles.
  double sum = 0, apart = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double one = exact.angles[i] / exact_length, two = other.angles[i] / other_length;
    sum += (one + two) * (one + two);
    apart += (one - two) * (one - two);
  }
  return {other_length / exact_length - 1,
          2 * std::atan2(std::sqrt(apart), std::sqrt(sum)) / std::numbers::pi};
}

}  // namespace rockstack
