#pragma once

#include "analytic/batch/kernel.hpp"

// The parts of a step's kernel that tell whether interfaces carry what the motion demands of them.

namespace rockstack {

template <class Real, int N>
void StepKernel<Real, N>::follow_margins(const Chain& series) {
  for (std::size_t k = 0; k < blocks; ++k) {
    const Mask watched = load(rows_.watched[k]) > Real(0);
    if (!any(watched)) continue;
    auto& [right, left] = margins_[k];
    right.terms = left.terms = orders_;
    for (std::size_t n = 0; n < orders_; ++n) {
      const Real push = pushed_ == k ? pushes_[n] : series.push(k, n);
      const auto margin = series.margin(k, n, push);
      right[n] = own(n, margin.right);
      left[n] = own(n, margin.left);
    }
    const Mask stays = stays_clear(right) & stays_clear(left);
    plain_ = plain_ & (stays | ~watched);
    lands_ = lands_ & (stays | ~watched);
    store(select(watched, select(stays, Real(1), Real(0)), load(rows_.stays[k])), rows_.stays[k]);
  }
}

template <class Real, int N>
auto StepKernel<Real, N>::stays_clear(const Polynomial<Real>& margin) const -> Mask {
  NoCrossingBound<Real> clearance(margin[0]);
  for (std::size_t n = 1; n < margin.terms; ++n) clearance.add(margin[n]);
  return clearance.holds();
}

/// The sizes of coefficients from order 1 on.
template <class Real, int N>
template <class Coefficient>
Real StepKernel<Real, N>::reach(const Coefficient& coefficient) const {
  Real sum = 0;
  for (std::size_t n = 1; n < orders_; ++n) sum += abs(coefficient(n));
  return sum;
}

/// Whether an interface demands no more in any lane, as reaches tell without products of series: of forces
/// x and y, and for a `face` of the cosine and the sine that turn them. What rounding makes of them is far
/// below the slack. Of lanes with ties all is told.
template <class Real, int N>
bool StepKernel<Real, N>::clearly_borne(const Chain& series, std::size_t k,
                                        const typename Chain::PlaneSeries* face, const Real& scale) const {
  const auto [y, x] = series.force(k, -1, 0);
  const Real reach_x = reach([&](std::size_t n) { return series.force(k, -1, n).tangential; });
  const Real reach_y = reach([&](std::size_t n) { return series.force(k, -1, n).normal; });
  Real normal = y, tangential = x, reach_normal = reach_y, reach_tangential = reach_x;
  if (face != nullptr) {
    const auto [cosine, sine] = (*face)[0];
    const Real turn_x = reach([&](std::size_t n) { return (*face)[n].x; });
    const Real turn_y = reach([&](std::size_t n) { return (*face)[n].y; });
    const Real most_x = abs(x) + reach_x, most_y = abs(y) + reach_y;
    normal = sine * x + cosine * y;
    tangential = cosine * x - sine * y;
    reach_normal = abs(sine) * reach_x + turn_y * most_x + abs(cosine) * reach_y + turn_x * most_y;
    reach_tangential = abs(cosine) * reach_x + turn_x * most_x + abs(sine) * reach_y + turn_y * most_y;
  }
  const Real friction = load(rows_.friction[k]);
  const Real most = abs(tangential) + reach_tangential;
  const Real slack = Real(1e-12) * (abs(normal) + reach_normal + most);
  const Real least = normal - reach_normal - slack;
  const Mask holds = (least * scale >= load(rows_.least_normal[k])) & (most + slack <= friction * least);
  return !any((load(rows_.busy) > Real(0)) & ~(holds & (load(rows_.clear) > Real(0))));
}

template <class Real, int N>
void StepKernel<Real, N>::follow_forces(const Chain& series) {
  const Real scale = 1 / (start_.length * start_.length);
  for (std::size_t k = 0; k < blocks; ++k) {
    typename Chain::PlaneSeries faces;
    const bool upright = k == 0 || rows_.linear;
    const Mask upper = load(rows_.face[k]) > Real(0);
    const bool lower = !any(upper);
    if ((upright || lower) && clearly_borne(series, k, upright ? nullptr : &series.direction(k - 1), scale)) {
      store(Real(1), rows_.borne[k]);
      continue;
    }
    if (!upright && !lower) {
      for (std::size_t n = 0; n < orders_; ++n) {
        const auto& own = series.direction(k)[n];
        const auto& below = series.direction(k - 1)[n];
        faces[n] = {select(upper, own.x, below.x), select(upper, own.y, below.y)};
      }
    }
    pushed_ = lower && k > 0 ? k : blocks;
    const auto& direction = lower && k > 0 ? series.direction(k - 1) : faces;
    ForceBounds<Real> bounds(load(rows_.friction[k]));
    auto& [normals, tangentials] = forces_[k];
    normals.terms = tangentials.terms = orders_;
    for (std::size_t n = 0; n < orders_; ++n) {
      const auto force = upright ? series.force(k, -1, n) : series.force(k, direction, n);
      pushes_[n] = force.normal;
      const Real normal = own(n, force.normal * scale);
      const Real tangential = own(n, force.tangential * scale);
      normals[n] = normal;
      tangentials[n] = tangential;
      bounds.add(normal, tangential);
    }
    const Mask borne = bounds.hold(load(rows_.least_normal[k]), load(rows_.rounding));
    plain_ = plain_ & borne;
    silent_ = silent_ & borne;
    store_truth(borne, rows_.borne[k]);
  }
}

}  // namespace rockstack
