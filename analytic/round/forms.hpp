#pragma once

#include "analytic/round/axis.hpp"

namespace rockstack {

/// A state as numbers in a row, of jets or of numbers.
template <class T>
using Row = std::array<T, 7>;

// Either derivation as such rows: rates, from and to angles, and the sizes that numbers are held to.

struct ByAngles {
  static constexpr std::size_t size = 5;
  double east, north;  ///< p at ψ = 0

  template <class T>
  Row<T> rates(const Cylinder& body, const Row<T>& x, const Felt<T>& felt) const {
    const auto rate = rockstack::rates<T>(body, {x[0], x[1], x[2], x[3], x[4]}, felt, east, north);
    return {rate.tilt, rate.tilt_rate, rate.omega1, rate.omega3, rate.azimuth};
  }
  Row<double> row(const Rolling<double>& state) const {
    return {state.tilt, state.tilt_rate, state.omega1, state.omega3, state.azimuth};
  }
  Rolling<double> rolling(const Row<double>& x) const { return {x[0], x[1], x[2], x[3], x[4]}; }
  /// Sizes that numbers are held to: near θ = 0 the tilt keeps its digits.
  Row<double> scales(const Row<double>& x, double rate) const {
    const double turning = std::abs(x[1]) + std::abs(x[2]) + std::abs(x[3]) + rate * x[0];
    return {x[0], turning, turning, turning, 1};
  }
};

struct ByAxis {
  static constexpr std::size_t size = 7;
  double east, north;

  template <class T>
  Row<T> rates(const Cylinder& body, const Row<T>& x, const Felt<T>& felt) const {
    const auto rate = rockstack::rates<T>(body, {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, x[6]}, felt);
    return {rate.axis.x, rate.axis.y, rate.axis.z, rate.omega.x, rate.omega.y, rate.omega.z, rate.azimuth};
  }
  Row<double> row(const Rolling<double>& state) const {
    const auto [sine, cosine] = sine_cosine(state.tilt);
    const auto [turn_sine, turn_cosine] = sine_cosine(state.azimuth);
    const double x = east * turn_cosine - north * turn_sine, y = north * turn_cosine + east * turn_sine;
    const double along = state.omega1 * cosine + state.omega3 * sine;
    return {sine * x,
            sine * y,
            cosine,
            along * x - state.tilt_rate * y,
            along * y + state.tilt_rate * x,
            state.omega3 * cosine - state.omega1 * sine,
            state.azimuth};
  }
  Rolling<double> rolling(const Row<double>& x) const {
    const double sine = std::hypot(x[0], x[1]), east_now = x[0] / sine, north_now = x[1] / sine;
    const double along = x[3] * east_now + x[4] * north_now;
    return {std::atan2(sine, x[2]), x[4] * east_now - x[3] * north_now, along * x[2] - x[5] * sine,
            along * sine + x[5] * x[2], x[6]};
  }
  Row<double> scales(const Row<double>& x, double rate) const {
    const double sine = std::hypot(x[0], x[1]);
    const double turning = std::abs(x[3]) + std::abs(x[4]) + std::abs(x[5]) + rate * sine;
    return {sine, sine, 1, turning, turning, turning, 1};
  }
};

}  // namespace rockstack
