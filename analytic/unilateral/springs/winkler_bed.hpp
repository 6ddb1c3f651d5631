#pragma once

#include <cstdint>

#include "analytic/polynomials/polynomial.hpp"

namespace rockstack {

/// An end of a bed, where two quantities have a sign.
struct BedEnd {
  bool deep = false;     ///< the face is below the bed's surface: the depth δ > 0
  bool presses = false;  ///< κδ + γδ̇ > 0
  bool at_face = false;  ///< the depth is zero by the event that has just been, however it rounds
};

/// Where a Winkler bed presses. Each part of it pushes with p = κδ + γδ̇ a length, where δ > 0 and p > 0;
/// depth and p go linearly along the face. So it presses on one stretch between two ends or zeros of either.
struct BedState {
  std::array<BedEnd, 2> ends;  ///< left and right, of the narrower face
  /// With p and δ of the left and the right end, p_l δ_r > p_r δ_l: which of two zeros lies where.
  bool crossed = false;
  bool at_crossing = false;  ///< it changes by the event that has just been
};

/// Where a stretch ends.
enum class BedBound : std::uint8_t { end, depth, pressure };

/// The stretch that presses, from an end of the face, or from near it, on.
struct PressedLength {
  bool presses = false;
  int from = 1;  ///< the end that it is counted from: 0 left, 1 right
  BedBound near = BedBound::end, far = BedBound::end;
};

/// An end that does not press: which zero the stretch ends at. `crossed` tells where both lie inside.
inline BedBound bound_of(const BedState& bed, std::size_t end) {
  const BedEnd& here = bed.ends[end];
  if (here.deep && here.presses) return BedBound::end;
  if (here.deep != here.presses) return here.deep ? BedBound::pressure : BedBound::depth;
  return bed.crossed == (end == 0) ? BedBound::depth : BedBound::pressure;
}

inline PressedLength stretch_of(const BedState& bed) {
  const auto& [left, right] = bed.ends;
  PressedLength stretch;
  if (!(left.deep || right.deep) || !(left.presses || right.presses)) return stretch;
  const bool apart = left.deep != left.presses && right.deep != right.presses && left.deep != right.deep;
  stretch.presses = !apart || bed.crossed == right.deep;
  const bool from_left = bound_of(bed, 0) == BedBound::end && bound_of(bed, 1) != BedBound::end;
  stretch.from = from_left ? 0 : 1;
  stretch.near = bound_of(bed, from_left ? 0 : 1);
  stretch.far = bound_of(bed, from_left ? 1 : 0);
  return stretch;
}

/// What a bed does as series, order by order, from depth and pressure of its ends: the force of all of it at
/// its middle, and a couple of two opposite forces at its ends. Along the face u goes from 0 at the end that
/// the stretch is counted from to 2 at the other; with pressures P = 2bp,
///
///     N = ½ ∫ P du,   couple = ± ¼ ∫ P (1 − u) du,   both over the stretch.
template <class Real>
struct GrowingBed {
  PressedLength stretch;
  std::array<Polynomial<Real>, 2> depth;     ///< m
  std::array<Polynomial<Real>, 2> pressure;  ///< 2bp, N
  Polynomial<Real> normal;                   ///< N
  Polynomial<Real> couple;                   ///< up at the right end, down at the left one, N

  void extend(std::size_t n) {
    const std::size_t here = stretch.from, there = 1 - here;
    put(normal, n, 0);
    put(couple, n, 0);
    if (!stretch.presses) return;
    put(depth_slope_, n, (depth[here][n] - depth[there][n]) / 2);
    put(pressure_slope_, n, (pressure[here][n] - pressure[there][n]) / 2);
    extend_bound(near_, stretch.near, 0, here, n);
    extend_bound(far_, stretch.far, 2, here, n);
    put(width_, n, far_.place[n] - near_.place[n]);
    put(middle_, n, (far_.place[n] + near_.place[n]) / 2);
    put(mean_, n, (far_.pressure[n] + near_.pressure[n]) / 2);
    put(rise_, n, far_.pressure[n] - near_.pressure[n]);
    put(force_, n, convolution(width_, mean_, n));
    put(square_, n, convolution(width_, width_, n));
    put(normal, n, force_[n] / 2);
    const Real turning = force_[n] - convolution(force_, middle_, n) - convolution(square_, rise_, n) / 12;
    put(couple, n, (stretch.from == 1 ? turning : Real(-turning)) / 4);
  }

  /// See BedState::crossed.
  bool crosses() const { return pressure[0][0] * depth[1][0] > pressure[1][0] * depth[0][0]; }

 private:
  struct Bound {
    Polynomial<Real> place, pressure;
  };

  void extend_bound(Bound& bound, BedBound kind, int end, std::size_t here, std::size_t n) const {
    if (kind == BedBound::end) {
      put(bound.place, n, n == 0 ? end : 0);
      put(bound.pressure, n, pressure[end == 0 ? here : 1 - here][n]);
    } else if (kind == BedBound::pressure) {
      extend_quotient(pressure[here], pressure_slope_, bound.place, n);
      put(bound.pressure, n, 0);
    } else {
      extend_quotient(depth[here], depth_slope_, bound.place, n);
      put(bound.pressure, n, pressure[here][n] - convolution(bound.place, pressure_slope_, n));
    }
  }

  static void extend_quotient(const Polynomial<Real>& over, const Polynomial<Real>& under,
                              Polynomial<Real>& quotient, std::size_t n) {
    put(quotient, n, 0);
    quotient[n] = (over[n] - convolution(quotient, under, n)) / under[0];
  }

  Polynomial<Real> depth_slope_, pressure_slope_;  ///< what they lose over u = 1
  Bound near_, far_;
  Polynomial<Real> width_, middle_, mean_, rise_, force_, square_;
};

/// ½ ∫ ξⁿ dξ, n = 0, 1 and 2, over the deep part of a bed, ξ = −1 … 1 along the face; over all where none is.
template <class Real>
std::array<Real, 3> moments_in_contact(const Real& left, const Real& right) {
  if (!(left > 0) && !(right > 0)) return {1, 0, Real(1) / 3};
  const auto zero = [&] { return Real((left + right) / (left - right)); };
  const Real low = left > 0 ? Real(-1) : zero(), high = right > 0 ? Real(1) : zero();
  return {(high - low) / 2, (high * high - low * low) / 4, (high * high * high - low * low * low) / 6};
}

/// ∫ ½κδ² along a bed, J, from the depths of its ends and its stiffness 2bκ.
template <class Real>
Real elastic_energy_of_bed(const Real& stiffness, const std::array<Real, 2>& depth) {
  const auto& [left, right] = depth;
  if (!(left > 0) && !(right > 0)) return 0;
  if (left > 0 && right > 0) return stiffness * (left * left + left * right + right * right) / 6;
  const Real deep = std::max(left, right);
  return stiffness * deep * deep * deep / (6 * (deep - std::min(left, right)));
}

}  // namespace rockstack
