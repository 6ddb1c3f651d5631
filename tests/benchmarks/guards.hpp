#pragma once

#include <array>
#include <bitset>
#include <cmath>
#include <optional>

#include "tests/benchmarks/lean_chain.hpp"

namespace rockstack::benchmarks {

/// What ends a pattern: numbers that are positive as long as their events have not come. Open interfaces
/// close, blocks topple, closed interfaces open to the right or to the left.
template <int N>
class Guards {
 public:
  /// @param toppling the toppling angles of blocks, rad
  Guards(const Stretch<N>& stretch, const std::array<double, N>& toppling)
      : stretch_(stretch), toppling_(toppling) {}

  using Numbers = std::bitset<4UL * N>;

  /// The number of a guard that is negative at an offset at which the values are those, one of an angle where
  /// there is any; `known` are left out.
  std::optional<std::size_t> negative(const Values<N>& values, double offset, Numbers known = {}) const {
    for (std::size_t guard = 0; guard < 2UL * N; ++guard)
      if (!known.test(guard) && angle(guard, values) < 0) return guard;
    bool closed = false;
    for (std::size_t k = 0; k < N; ++k) closed = closed || side(k) == 0;
    if (!closed) return std::nullopt;
    const auto response = stretch_.respond(values, offset);
    for (std::size_t k = 0; k < N; ++k) {
      if (side(k) != 0) continue;
      if (!known.test(k + 2UL * N) && response.right[k] < 0) return k + 2UL * N;
      if (!known.test(k + 3UL * N) && response.left[k] < 0) return k + 3UL * N;
    }
    return std::nullopt;
  }

  /// When the first of all events comes after `low`, the last offset that is known to be before it, where
  /// `guard` is negative at `high`; `at` gives the values at an offset.
  template <class At>
  double first(double low, double high, std::size_t guard, const At& at) const {
    Numbers known;
    for (std::optional<std::size_t> next = guard; next; next = negative(at(high), high, known)) {
      high = root(low, high, *next, at);
      known.set(*next);
    }
    return high;
  }

 private:
  int side(std::size_t k) const { return sign(stretch_.chain->pattern()[static_cast<int>(k)]); }

  double angle(std::size_t guard, const Values<N>& values) const {
    if (guard < N) return side(guard) == 0 ? 1 : side(guard) * values[guard];
    double leaning = 0;
    for (std::size_t k = 0; k <= guard - N; ++k) leaning += values[k];
    return toppling_[guard - N] - std::abs(leaning);
  }

  double value(std::size_t guard, const Values<N>& values, double offset) const {
    if (guard < 2UL * N) return angle(guard, values);
    const auto response = stretch_.respond(values, offset);
    return guard < 3UL * N ? response.right[guard - 2UL * N] : response.left[guard - 3UL * N];
  }

  /// Where one guard first turns negative: regula falsi (Illinois), to rounding.
  template <class At>
  double root(double low, double high, std::size_t guard, const At& at) const {
    double above = value(guard, at(low), low);
    double below = value(guard, at(high), high);
    if (!(above > 0)) above = -below;  // starts at zero: halve first
    double best = high;
    double smallest = -below;
    int side = 0;
    for (int iteration = 0; iteration < 100; ++iteration) {
      const double middle = (low * below - high * above) / (below - above);
      if (!(middle > low && middle < high)) break;
      const double there = value(guard, at(middle), middle);
      if (std::abs(there) <= smallest) {
        best = middle;
        smallest = std::abs(there);
      }
      (there >= 0 ? low : high) = middle;
      (there >= 0 ? above : below) = there;
      const int now = there >= 0 ? 1 : -1;
      if (now == side) (now == 1 ? below : above) /= 2;
      side = now;
      if (there == 0) break;
    }
    return best;
  }

  Stretch<N> stretch_;
  const std::array<double, N>& toppling_;
};

}  // namespace rockstack::benchmarks
