#pragma once

#include "analytic/batch/kernel.hpp"

// The parts of a step's kernel that tell where angles lead, and how far blocks have leant and interfaces
// opened.

namespace rockstack {

template <class Real, int N>
void StepKernel<Real, N>::follow_angles(const Chain& series) {
  Coefficients absolute;
  for (std::size_t k = 0; k < blocks; ++k) {
    angles_[k].terms = orders_ + 2;
    const auto keep = [&](std::size_t i, const Real& coefficient) {
      angles_[k][i] = coefficient;
      absolute[i] = k > 0 ? absolute[i] + coefficient : coefficient;
    };
    const Real& side = start_.sides[k];
    keep(0, start_.angles[k]);
    keep(1, start_.advances[k]);
    NoCrossingBound<Real> clearance(start_.angles[k] * side);
    PartialSums<Real> heights;
    heights.add(absolute[0]);
    clearance.add(start_.advances[k] * side);
    heights.add(absolute[1]);
    for (std::size_t n = 0; n < orders_; ++n) {
      const Real coefficient = own(n, series.angle(k, n));
      keep(n + 2, coefficient);
      clearance.add(coefficient * side);
      heights.add(absolute[n + 2]);
    }
    const Mask stays = clearance.holds();
    closes_[k] = ~stays & (side != Real(0));
    plain_ = plain_ & ~closes_[k];
    store_truth(stays, rows_.stays[k]);
    end(absolute, {clearance.size(), max(heights.greatest, -heights.least)}, k);
  }
}

/// Where the step leads; its peaks are known, or at an end.
template <class Real, int N>
void StepKernel<Real, N>::end(const Coefficients& absolute, const Most& most, std::size_t k) {
  Real angle = 0;
  Real height = 0;
  Real steepness = 0;
  for (std::size_t i = orders_ + 2; i-- > 0;) {
    const Real& coefficient = angles_[k][i];
    angle += coefficient;
    height += absolute[i];
    if (i > 0) steepness += counting<double>[i] * coefficient;
  }
  const Real peak = load(rows_.peak[k]);
  const Mask known = most.absolute <= peak;
  const Mask stands = most.absolute < load(rows_.toppling[k]);
  plain_ = plain_ & stands;
  if (any(plain_ & ~known)) plain_ = plain_ & (known | monotone(absolute.data(), orders_ + 2));
  lands_ = lands_ & stands;
  silent_ = silent_ & known;
  const Real top = select(known, peak, max(max(peak, abs(absolute[0])), abs(height)));
  ends_[k] = {angle, steepness / start_.length, top, top};
  store_truth(k > 0 ? stands & known & opens_no_further(most.relative, k) : stands & known, rows_.upright[k]);
}

/// Whether an interface above others, whose angle is `most` at most, opens no further than it has; else it
/// does at an end of a plain step. Partial sums tell where sizes of coefficients do not.
template <class Real, int N>
auto StepKernel<Real, N>::opens_no_further(const Real& most, std::size_t k) -> Mask {
  constexpr double roundings = 1 + 64 * std::numeric_limits<double>::epsilon();
  const Real opening = load(rows_.opening[k]);
  Mask known = most * roundings <= opening;
  ends_[k].opening = opening;
  if (!any((plain_ | lands_) & ~known)) return known;
  PartialSums<Real> sums;
  for (const Real& coefficient : angles_[k]) sums.add(coefficient);
  known = known | (max(sums.greatest, -sums.least) <= opening);
  if (any(plain_ & ~known)) plain_ = plain_ & (known | monotone(angles_[k].begin(), orders_ + 2));
  silent_ = silent_ & known;
  ends_[k].opening = select(known, opening, max(max(opening, abs(start_.angles[k])), abs(ends_[k].angle)));
  return known;
}

}  // namespace rockstack
