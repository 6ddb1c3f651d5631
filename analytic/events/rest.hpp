#pragma once

#include "analytic/mechanics/dynamics.hpp"
#include "analytic/steps/ground_pieces.hpp"

namespace rockstack {

/// A stack with all interfaces closed. It stands for as long as the ground's acceleration (ẍg, ÿg) leaves the
/// pull at its masses inside every interface:
///
///     |ẍg| < λ (g + ÿg),   λ = min over k of (mₖ wₖ − |Σ_{j≥k} Sₓⱼ|) / Σ_{j≥k} Sᵧⱼ
///
/// with mₖ the mass above interface k, and the S of the linkage upright. For one block λ is b/h. Every
/// interface bears N = mₖ (g + ÿg) and T = mₖ ẍg.
template <class Real, int N>
struct RestingStack {
  PerBlock<Real, N> mass;  ///< kg, of all above an interface
  Real critical_tilt;      ///< λ, less what rounding may make of it; negative where it falls by itself

  explicit RestingStack(const Model<Real, N>& model) {
    const Linkage<Real, N> linkage = make_linkage(model.stack, closed_pattern(model.stack.size()));
    mass = linkage.mass;
    critical_tilt = std::numeric_limits<Real>::infinity();
    Real moment = 0;
    Real aside = 0;
    for (std::size_t k = linkage.size(); k-- > 0;) {
      moment += linkage.moment_y[k];
      aside += linkage.moment_x[k];
      critical_tilt = std::min<Real>(critical_tilt, (mass[k] * linkage.width[k] - abs(aside)) / moment);
    }
    critical_tilt *= 1 - 1024 * std::numeric_limits<Real>::epsilon();
  }
};

/// What a stack that stands still bears over a stretch of time, at most: the least effective gravity g + ÿg
/// in m/s², and the largest |ẍg| / (g + ÿg).
template <class Real>
struct SupportDemand {
  Real least_gravity;
  Real tilt;
};

/// The demand through the rest of a ground piece; its tilt is infinite where there is a pulse in it, or
/// where the ground falls away. Straight lines have their extremes at their ends, and so has their ratio.
template <class Real>
SupportDemand<Real> support_demand(const Real& gravity, const GroundPiece<Real>& piece, const Real& offset) {
  SupportDemand<Real> result{std::numeric_limits<Real>::infinity(), std::numeric_limits<Real>::infinity()};
  if (!piece.straight()) return result;
  const auto gravity_at = [&](const Real& time) { return gravity + piece.vertical.line_at(time); };
  const auto push_at = [&](const Real& time) { return abs(piece.horizontal.line_at(time)); };
  const Real first = gravity_at(offset);
  const Real last = gravity_at(piece.length);
  result.least_gravity = std::min(first, last);
  if (result.least_gravity > 0)
    result.tilt = std::max<Real>(push_at(offset) / first, push_at(piece.length) / last);
  return result;
}

}  // namespace rockstack
