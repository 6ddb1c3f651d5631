#pragma once

#include "analytic/batch/bounds.hpp"
#include "analytic/batch/foresight.hpp"
#include "analytic/batch/record_walk.hpp"
#include "analytic/steps/taylor_step.hpp"

// Inlines functions whose parts are so small that calls count. Under a sanitizer they would only take long to
// compile.
#ifdef __SANITIZE_ADDRESS__
#define ROCKSTACK_WITHOUT_CALLS
#else
#define ROCKSTACK_WITHOUT_CALLS [[gnu::flatten]]
#endif

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

  Real load(const LaneRow& row) const { return rockstack::load<Real>(row, lane_); }
  void store(const Real& values, LaneRow& row) const { rockstack::store(values, row, lane_); }
  void store_truth(const Mask& mask, LaneRow& row) const { rockstack::store_truth<Real>(mask, row, lane_); }

  ROCKSTACK_WITHOUT_CALLS void make_step() {
    const Real busy = load(rows_.busy);
    if (!any(busy > Real(0))) return;
    const typename Chain::Directions directions = load_start();
    model_.stack = load_stack<Real, N>(rows_, lane_);
    const Linkage<Real, N> linkage = make_linkage(model_.stack, start_.sides);
    bool watched = false;
    for (const LaneRow& row : rows_.watched) watched = watched || any(load(row) > Real(0));
    body_force_ = load_body_force<Real>(rows_, lane_);
    Chain series(linkage, rows_.linear ? Equations::linear : Equations::nonlinear, {rows_.forces, watched},
                 directions, start_.advances);
    series.extend(0, body_force_);
    foresee_landing(series);
    converge(series, busy);
    follow_angles(series);
    if (rows_.forces) follow_forces(series);
    if (watched) follow_margins(series);
    land();
    store(start_.length, rows_.length);
    store_truth(plain_, rows_.plain);
    go_on();
    if (any(lands_)) meet();
    walk_record(rows_, lane_, start_.length, plain_);
    if (any((busy > Real(0)) & ~(plain_ | (lands_ & silent_)))) tell();
  }

  /// Lanes whose step is plain, or lands, are where it leads.
  void go_on() {
    const Mask goes = plain_ | lands_;
    for (std::size_t k = 0; k < blocks; ++k) {
      const Mask moves = goes & (start_.sides[k] != Real(0));
      store(select(moves, ends_[k].angle, load(rows_.angle[k])), rows_.angle[k]);
      store(select(moves, ends_[k].velocity, load(rows_.velocity[k])), rows_.velocity[k]);
      store(select(plain_, ends_[k].peak, load(rows_.peak[k])), rows_.peak[k]);
      store(select(plain_, ends_[k].opening, load(rows_.opening[k])), rows_.opening[k]);
    }
  }

  /// What the steps of the others are.
  void tell() {
    const auto put = [&](const Polynomial<Real>& polynomial, CoefficientRows& rows) {
      for (std::size_t n = 0; n < polynomial.terms; ++n) store(polynomial[n], rows[n]);
    };
    for (std::size_t k = 0; k < blocks; ++k) {
      put(angles_[k], rows_.angles[k]);
      put(margins_[k].right, rows_.right[k]);
      put(margins_[k].left, rows_.left[k]);
      put(forces_[k].normal, rows_.normal[k]);
      put(forces_[k].tangential, rows_.tangential[k]);
    }
  }

  /// Direction of one angle, as in directions_at().
  PlaneVector<Real> direction(const Real& angle) const {
    if (rows_.linear) return {Real(1), Real(0)};
    const auto [cosine, sine] = direction_of_each(angle);
    return {cosine, sine};
  }

  typename Chain::Directions load_start() {
    typename Chain::Directions directions;
    Real leaning = 0;  // absolute angle
    start_.length = load(rows_.length);
    start_.rate = load(rows_.rate);
    for (std::size_t k = 0; k < blocks; ++k) {
      start_.sides[k] = load(rows_.side[k]);
      start_.angles[k] = load(rows_.angle[k]);
      start_.advances[k] = load(rows_.velocity[k]) * start_.length;
      leaning = k > 0 ? leaning + start_.angles[k] : start_.angles[k];
      directions[k] = direction(leaning);
    }
    return directions;
  }

  /// Shortens the steps that an impact will end.
  void foresee_landing(Chain& series) {
    const Real ratio = start_.landing(series);
    const Mask shorter = ratio < Real(1);
    if (!any(shorter)) return;
    const Real share = select(shorter, ratio, Real(1));
    start_.shorten(share);
    shorten(body_force_, share);
    series.shorten(share);
  }

  /// Computes orders, of each lane its own number, until their last coefficients are below the tolerance.
  void converge(Chain& series, const Real& busy) {
    const Real body_force_terms = load(rows_.body_force_terms);
    Mask open = busy > Real(0);
    Mask reached = open;
    Convergence<Real> convergence(load(rows_.tolerance));
    own_ = 0;
    for (orders_ = 0; any(open) && orders_ < max_orders<Real>;) {
      if (orders_ > 0) series.extend(orders_, body_force_);
      reached = convergence.note_order(start_, series, orders_);
      has_[orders_] = open;
      const Real count = counting<double>[++orders_];
      own_ = select(open, count, own_);
      open = open & ~(reached & (count >= body_force_terms));
    }
    const Mask exceeds = open & ~reached;
    store(own_, rows_.orders);
    store(select(exceeds, convergence.excess(), Real(0)), rows_.excess);
    plain_ = ~exceeds;
    lands_ = ~exceeds & (busy > Real(0)) & (load(rows_.clear) > Real(0));
    silent_ = lands_;
  }

  /// A coefficient of the lanes whose series has that order; the sums of the others stay as they are.
  Real own(std::size_t order, const Real& coefficient) const {
    return select(has_[order], coefficient, Real(0));
  }

  // Where angles lead: kernel_angles.hpp.
  void follow_angles(const Chain& series);
  struct Most {
    Real relative, absolute;  ///< no angle is larger over the step, rad
  };
  void end(const Coefficients& absolute, const Most& most, std::size_t k);
  Mask opens_no_further(const Real& most, std::size_t k);

  // Where interfaces carry forces: kernel_forces.hpp.
  void follow_margins(const Chain& series);
  void follow_forces(const Chain& series);
  Mask stays_clear(const Polynomial<Real>& margin) const;
  template <class Coefficient>
  Real reach(const Coefficient& coefficient) const;
  bool clearly_borne(const Chain& series, std::size_t k, const typename Chain::PlaneSeries* face,
                     const Real& scale) const;

  /// Finds the impacts of lanes in which one interface closes, and nothing else happens.
  void land() {
    const Closing<Real> falling = closing<Real, blocks>(angles_, start_.sides, closes_);
    lands_ = lands_ & falling.alone;
    if (any(lands_)) {
      const Roots<Real> roots = first_crossings(falling.angle, own_ + Real(2), lands_);
      lands_ = roots.found;
      for (std::size_t k = 0; k < blocks; ++k) {
        const auto [angle, advance] = tangent(angles_[k], roots.s);
        ends_[k].angle = select(lands_, angle, ends_[k].angle);
        ends_[k].velocity = select(lands_, advance / start_.length, ends_[k].velocity);
      }
      store(roots.s, rows_.landing);
      store(falling.interface, rows_.lander);
    }
    store_truth(lands_, rows_.lands);
    store_truth(silent_, rows_.silent);
  }

  /// Foresees the impacts.
  void meet() {
    Directions<Real, N> directions;
    PerBlock<Mask, N> impacting;
    Vector<Real, N> velocities;
    Real leaning = 0;
    for (std::size_t k = 0; k < blocks; ++k) {
      impacting[k] = lands_ & (load(rows_.lander) == Real(static_cast<double>(k)));
      velocities[k] = load(rows_.velocity[k]);
      const Real angle = select(impacting[k], Real(0), load(rows_.angle[k]));
      leaning = k > 0 ? leaning + angle : angle;
      const PlaneVector<Real> leans = direction(leaning);
      directions.cosine[k] = leans.x;
      directions.sine[k] = leans.y;
    }
    const auto [impact, holds] = foresee(model_, start_.sides, velocities, directions, impacting);
    store_truth(lands_ & holds, rows_.foreseen);
    const auto put = [&](const Vector<Real, N>& values, PerBlock<LaneRow, N>& rows) {
      for (std::size_t k = 0; k < blocks; ++k) store(values[k], rows[k]);
    };
    put(directions.cosine, rows_.cosine);
    put(directions.sine, rows_.sine);
    put(impact.before.motion.rotation, rows_.rotation);
    put(impact.before.motion.centre.row(0), rows_.centre_speed_x);
    put(impact.before.motion.centre.row(1), rows_.centre_speed_y);
    put(impact.solution.relative, rows_.after);
    put(impact.solution.rounding, rows_.negligible);
    put(impact.solution.reactions.normal, rows_.impulse_normal);
    put(impact.solution.reactions.tangential, rows_.impulse_tangential);
    put(impact.solution.reactions.moment, rows_.impulse_moment);
  }

  ScaledBodyForce<Real> body_force_;
  Model<Real, N> model_;  ///< without gravity
  StepStart<Real, N> start_;
  Real own_;  ///< orders of each lane
  Mask plain_, lands_, silent_;
  std::array<Mask, max_orders<Real>> has_;  ///< whether lanes have an order
  std::array<Mask, blocks> closes_;         ///< open interfaces that may close
  std::array<Polynomial<Real>, blocks> angles_;
  std::array<MarginPolynomials<Real>, blocks> margins_;
  std::array<ForcePolynomials<Real>, blocks> forces_;
  struct End {
    Real angle, velocity, peak, opening;
  };
  std::array<End, blocks> ends_;
  Coefficients pushes_;          ///< normal force at the last interface, along the face below it
  std::size_t pushed_ = blocks;  ///< that interface, where it is known
  StepRows<blocks>& rows_;
  std::size_t lane_;
  std::size_t orders_ = 0;  ///< of the lane that has most
};

/// The steps of short stacks by one instruction set.
template <class Set>
inline constexpr StepKernels step_kernels{&StepKernel<Pack<Set>, 1>::make_steps,
                                          &StepKernel<Pack<Set>, 2>::make_steps,
                                          &StepKernel<Pack<Set>, 3>::make_steps};

}  // namespace rockstack
