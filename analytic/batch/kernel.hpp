#pragma once

#include <limits>

#include "analytic/batch/bounds.hpp"
#include "analytic/batch/directions.hpp"
#include "analytic/batch/step_rows.hpp"
#include "analytic/steps/step_rule.hpp"

namespace rockstack {

/// Makes the steps of as many lanes as a pack holds, operation by operation as TaylorSteps, first_event() and
/// Recorder do for one; what a bound on coefficients does not tell is left to them.
template <class Real, int N>
class StepKernel {
 public:
  static constexpr auto blocks = static_cast<std::size_t>(N);

  static void make_steps(StepRows<blocks>& rows) {
    for (std::size_t lane = 0; lane < batch_lanes; lane += Real::size) {
      StepKernel kernel(rows, lane);
      kernel.make_step();
    }
  }

 private:
  using Mask = typename Real::Mask;
  using Chain = ChainSeries<Real, N>;
  using Coefficients = std::array<Real, max_terms<Real>>;

  StepKernel(StepRows<blocks>& rows, std::size_t lane) : rows_(rows), lane_(lane) {}

  Real load(const LaneRow& row) const { return Real::load(row.lanes.data() + lane_); }
  void store(const Real& values, LaneRow& row) const { values.store(row.lanes.data() + lane_); }

  void store_truth(const Mask& mask, LaneRow& row) const { store(select(mask, Real(1), Real(0)), row); }

  void make_step() {
    const Real busy = load(rows_.busy);
    if (!any(busy > Real(0))) return;
    const Linkage<Real, N> linkage = load_linkage();
    typename Chain::Directions directions;
    Real leaning = 0;  // absolute angle
    bool watched = false;
    start_.length = load(rows_.length);
    start_.rate = load(rows_.rate);
    for (std::size_t k = 0; k < blocks; ++k) {
      start_.sides[k] = load(rows_.side[k]);
      start_.angles[k] = load(rows_.angle[k]);
      start_.advances[k] = load(rows_.velocity[k]) * start_.length;
      leaning = k > 0 ? leaning + start_.angles[k] : start_.angles[k];
      directions[k] = direction(leaning);
      watched = watched || any(load(rows_.watched[k]) > Real(0));
    }
    load_body_force();
    Chain series(linkage, rows_.linear ? Equations::linear : Equations::nonlinear, {rows_.forces, watched},
                 directions, start_.advances);
    series.extend(0, body_force_);
    land(series);
    converge(series, busy);
    follow_angles(series);
    if (watched) follow_margins(series);
    if (rows_.forces) follow_forces(series);
    store(start_.length, rows_.length);
    store_truth(plain_, rows_.plain);
    go_on();
  }

  /// Lanes whose step is plain are where it leads.
  void go_on() {
    for (std::size_t k = 0; k < blocks; ++k) {
      const Mask moves = plain_ & (start_.sides[k] != Real(0));
      store(select(moves, ends_[k].angle, load(rows_.angle[k])), rows_.angle[k]);
      store(select(moves, ends_[k].velocity, load(rows_.velocity[k])), rows_.velocity[k]);
      store(select(plain_, ends_[k].peak, load(rows_.peak[k])), rows_.peak[k]);
    }
  }

  /// As directions_at().
  PlaneVector<Real> direction(const Real& angle) const {
    if (rows_.linear) return {Real(1), Real(0)};
    const auto [cosine, sine] = direction_of_each(angle);
    return {cosine, sine};
  }

  Linkage<Real, N> load_linkage() const {
    Linkage<Real, N> linkage;
    linkage.blocks = N;
    for (std::size_t k = 0; k < blocks; ++k) {
      linkage.moment_x[k] = load(rows_.moment_x[k]);
      linkage.moment_y[k] = load(rows_.moment_y[k]);
      linkage.link_x[k] = load(rows_.link_x[k]);
      linkage.link_y[k] = load(rows_.link_y[k]);
      linkage.inertia[k] = load(rows_.inertia[k]);
      linkage.mass[k] = load(rows_.mass[k]);
      linkage.width[k] = load(rows_.width[k]);
      linkage.free[k] = load(rows_.free[k]);
    }
    return linkage;
  }

  void load_body_force() {
    const Real body_force_terms = load(rows_.body_force_terms);
    std::size_t terms = 0;
    while (terms < max_terms<Real> && any(body_force_terms > Real(static_cast<double>(terms)))) {
      body_force_.x[terms] = load(rows_.body_force_x[terms]);
      body_force_.y[terms] = load(rows_.body_force_y[terms]);
      ++terms;
    }
    body_force_.x.terms = body_force_.y.terms = terms;
  }

  /// Shortens the steps that an impact will end.
  void land(Chain& series) {
    const Real ratio = start_.landing(series);
    const Mask shorter = ratio < Real(1);
    if (!any(shorter)) return;
    const Real share = select(shorter, ratio, Real(1));
    start_.shorten(share);
    shorten(body_force_, share);
    series.shorten(share);
  }

  /// Computes orders until the last coefficients of all lanes are below the tolerance; each lane has its own
  /// number.
  void converge(Chain& series, const Real& busy) {
    const Real body_force_terms = load(rows_.body_force_terms);
    Mask open = busy > Real(0);
    Mask reached = open;
    Convergence<Real> convergence(load(rows_.tolerance));
    own_ = 0;
    for (orders_ = 0; any(open) && orders_ < max_orders<Real>;) {
      if (orders_ > 0) series.extend(orders_, body_force_);
      reached = convergence.note_order(start_, series, orders_);
      const Real count = static_cast<double>(++orders_);
      own_ = select(open, count, own_);
      open = open & ~(reached & (count >= body_force_terms));
    }
    const Mask exceeds = open & ~reached;
    store(own_, rows_.orders);
    store(select(exceeds, convergence.excess(), Real(0)), rows_.excess);
    plain_ = ~exceeds;
  }

  /// A coefficient of the lanes whose series has that order; the sums of the others stay as they are.
  Real own(std::size_t order, const Real& coefficient) const {
    return select(Real(static_cast<double>(order)) < own_, coefficient, Real(0));
  }

  void follow_angles(const Chain& series) {
    Coefficients absolute;
    for (std::size_t k = 0; k < blocks; ++k) {
      const auto keep = [&](std::size_t i, const Real& coefficient) {
        store(coefficient, rows_.angles[k][i]);
        absolute[i] = k > 0 ? absolute[i] + coefficient : coefficient;
      };
      const Real& side = start_.sides[k];
      keep(0, start_.angles[k]);
      keep(1, start_.advances[k]);
      Clearance<Real> clearance(start_.angles[k] * side);
      Leaning<Real> swing(absolute[0]);
      clearance.add(start_.advances[k] * side);
      swing.add(1, absolute[1]);
      for (std::size_t n = 0; n < orders_; ++n) {
        const Real coefficient = own(n, series.angle(k, n));
        keep(n + 2, coefficient);
        clearance.add(coefficient * side);
        swing.add(static_cast<double>(n + 2), absolute[n + 2]);
      }
      const Mask stays = clearance.holds();
      plain_ = plain_ & (stays | (side == Real(0)));
      store_truth(stays, rows_.stays[k]);
      end(absolute, swing, k);
    }
  }

  /// Where the step leads. The block's peak is to be known, or at an end of the step.
  void end(const Coefficients& absolute, const Leaning<Real>& swing, std::size_t k) {
    Real angle = 0;
    Real height = 0;
    Real steepness = 0;
    for (std::size_t i = orders_ + 2; i-- > 0;) {
      const Real coefficient = load(rows_.angles[k][i]);
      angle += coefficient;
      height += absolute[i];
      if (i > 0) steepness += static_cast<double>(i) * coefficient;
    }
    const Real peak = load(rows_.peak[k]);
    const Mask known = swing.size() <= peak;
    const Mask stands = swing.size() < load(rows_.toppling[k]);
    plain_ = plain_ & stands & (known | swing.is_monotone());
    store_truth(stands & known, rows_.upright[k]);
    ends_[k] = {angle, steepness / start_.length,
                select(known, peak, max(max(peak, abs(absolute[0])), abs(height)))};
  }

  void follow_margins(const Chain& series) {
    for (std::size_t k = 0; k < blocks; ++k) {
      const Mask watched = load(rows_.watched[k]) > Real(0);
      if (!any(watched)) continue;
      for (std::size_t n = 0; n < orders_; ++n) {
        const auto margin = series.margin(k, n);
        store(own(n, margin.right), rows_.right[k][n]);
        store(own(n, margin.left), rows_.left[k][n]);
      }
      const Mask stays = stays_clear(rows_.right[k]) & stays_clear(rows_.left[k]);
      plain_ = plain_ & (stays | ~watched);
      store(select(watched, select(stays, Real(1), Real(0)), load(rows_.stays[k])), rows_.stays[k]);
    }
  }

  Mask stays_clear(const CoefficientRows& margin) const {
    Clearance<Real> clearance(load(margin[0]));
    for (std::size_t n = 1; n < orders_; ++n) clearance.add(load(margin[n]));
    return clearance.holds();
  }

  void follow_forces(const Chain& series) {
    const Real scale = 1 / (start_.length * start_.length);
    for (std::size_t k = 0; k < blocks; ++k) {
      typename Chain::PlaneSeries direction;
      const bool upright = k == 0 || rows_.linear;
      if (!upright) {
        const Mask upper = load(rows_.face[k]) > Real(0);
        for (std::size_t n = 0; n < orders_; ++n) {
          const auto& own = series.direction(k)[n];
          const auto& below = series.direction(k - 1)[n];
          direction[n] = {select(upper, own.x, below.x), select(upper, own.y, below.y)};
        }
      }
      ForceBounds<Real> bounds(load(rows_.friction[k]));
      for (std::size_t n = 0; n < orders_; ++n) {
        const auto force = upright ? series.force(k, -1, n) : series.force(k, direction, n);
        const Real normal = own(n, force.normal * scale);
        const Real tangential = own(n, force.tangential * scale);
        store(normal, rows_.normal[k][n]);
        store(tangential, rows_.tangential[k][n]);
        bounds.add(normal, tangential);
      }
      const Mask borne = bounds.hold(load(rows_.least_normal[k]), load(rows_.rounding));
      plain_ = plain_ & borne;
      store_truth(borne, rows_.borne[k]);
    }
  }

  ScaledBodyForce<Real> body_force_;
  StepStart<Real, N> start_;
  Real own_;  ///< orders of each lane
  Mask plain_;
  struct End {
    Real angle, velocity, peak;
  };
  std::array<End, blocks> ends_;
  StepRows<blocks>& rows_;
  std::size_t lane_;
  std::size_t orders_ = 0;  ///< of the lane that has most
};

}  // namespace rockstack
