#pragma once

#include "analytic/batch/load.hpp"

namespace rockstack {

/// Asks for the next step of the lanes that a plain one of length `made` has led to the next sample of a
/// record, as GroundPieces and scaled_body_force() do of one. `from` is the first lane of the pack.
template <class Real, std::size_t N>
void walk_record(StepRows<N>& rows, std::size_t from, const Real& made, const typename Real::Mask& plain) {
  const auto at = [&](const LaneRow& row) { return load<Real>(row, from); };
  const Real sample = at(rows.sample) + Real(1);
  const Real longest = at(rows.longest);
  auto walks = plain & (at(rows.busy) > Real(0)) & (at(rows.clear) > Real(0)) & (sample < at(rows.last)) &
               (made >= at(rows.remaining)) & (made < longest);
  LaneRow firsts, seconds;
  store_truth<Real>(walks, rows.walked, from);
  if (!any(walks)) return;
  for (std::size_t lane = from; lane < from + Real::size; ++lane) {
    if (!(rows.walked[lane] > 0)) continue;
    const double* next = rows.samples[lane] + static_cast<std::ptrdiff_t>(rows.sample[lane]) + 1;
    firsts[lane] = next[0];
    seconds[lane] = next[1];
  }
  const Real first = at(firsts);
  const Real interval = at(rows.interval);
  const Real start = sample * interval;
  const Real rate = (at(seconds) - first) / interval;
  const Real value = first + (start - sample * interval) * rate + at(rows.constant);
  const Real length = (sample + Real(1)) * interval - start;
  walks = walks & (length < longest);
  const Real scale = -(length * length);
  const Real change = rate * length;
  const auto straight = abs(change) <= at(rows.negligible_change);
  const auto put = [&](const Real& values, LaneRow& row) {
    store(select(walks, values, at(row)), row, from);
  };
  put((value + Real(0) * rate + Real(0)) * scale, rows.body_force_x[0]);
  put(select(straight, Real(-0.0), change * scale), rows.body_force_x[1]);
  put(at(rows.gravity) * scale, rows.body_force_y[0]);
  put(Real(-0.0), rows.body_force_y[1]);
  put(select(straight, Real(1), Real(2)), rows.body_force_terms);
  put(length, rows.length);
  put(length, rows.remaining);
  put(sample, rows.sample);
  put(at(rows.pieces) + Real(1), rows.pieces);
  store_truth<Real>(walks, rows.walked, from);
}

}  // namespace rockstack
