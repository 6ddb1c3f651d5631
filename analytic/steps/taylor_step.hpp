#pragma once

#include "analytic/scene/solve_options.hpp"
#include "analytic/steps/chain_series.hpp"
#include "analytic/steps/dense_output.hpp"
#include "analytic/steps/landing.hpp"

namespace rockstack {

// What decides how long a Taylor step is, and of which order.

/// What a step starts from, and how long it is at most.
template <class Real, int N>
struct StepStart {
  PerBlock<Real, N> sides;     ///< signs of contacts
  PerBlock<Real, N> angles;    ///< φ, rad
  PerBlock<Real, N> advances;  ///< φ̇ times the length
  Real length;                 ///< s
  Real rate;                   ///< √(g/H), H the stack's height, 1/s

  void shorten(const Real& ratio) {
    length *= ratio;
    for (Real& advance : advances) advance *= ratio;
  }

  /// The share of a step by whose end the first interface that is open has come back, as far as its start can
  /// tell. Below a millionth of √(H/g) three orders do in any case, and a landing that rounding keeps away
  /// must not be foreseen for ever. `series` has its order 0.
  Real landing(const ChainSeries<Real, N>& series) const {
    Real first = 1;
    for (std::size_t k = 0; k < series.size(); ++k)
      first = min(first, rockstack::landing<Real>(sides[k] * angles[k], sides[k] * advances[k],
                                                  sides[k] * series.relative(k, 0), length, rate));
    return max(first, Real(1e-6) / (length * rate));
  }
};

/// Follows the orders of a series until what is left out is below a tolerance, relative to the step's motion:
/// estimated by the last coefficients, as they may be small by chance at least by a 64th of those before.
/// Where an interface starts from rest, three are looked at: if the weight vanishes just then, as a vertical
/// acceleration of the ground comes to −g along a line, φ̈ starts with t, φ with t³, the moment of weight goes
/// on with t · t³, and so forth: two orders of three are zero.
template <class Real>
class Convergence {
 public:
  explicit Convergence(const Real& tolerance) : tolerance_(tolerance) {}

  /// An order of the series: 0, 1, … Whether what is left out from there on is below the tolerance.
  template <int N>
  auto note_order(const StepStart<Real, N>& start, const ChainSeries<Real, N>& series, std::size_t order) {
    Real last = 0;
    for (std::size_t k = 0; k < series.size(); ++k) {
      const Real size = abs(series.relative(k, order));
      last = max(last, size);
      if (order == 0) {
        const Real zero = 0, side = start.sides[k], angle = start.angles[k], advance = start.advances[k];
        const auto rests = (side != zero) & (angle == zero) & (advance == zero);
        third_share_ = max(third_share_, select(rests, Real(1.0 / 4096), zero));
      }
      if (order < 2)
        scale_ =
            max(scale_, abs(start.advances[k]) + size + abs(start.angles[k]) * start.length * start.rate);
    }
    rest_ = max(last, earlier_ / 64);
    if (order >= 2) rest_ = max(rest_, third_share_ * before_earlier_);
    allowed_ = tolerance_ * Real(counting<Number<Real>>[order + 1]) * scale_;
    before_earlier_ = earlier_;
    earlier_ = last;
    return rest_ <= allowed_;
  }

  /// How many times the tolerance is left out.
  Real excess() const { return rest_ / allowed_; }

 private:
  Real tolerance_;
  Real scale_ = 0;
  Real earlier_ = std::numeric_limits<Number<Real>>::infinity();
  Real before_earlier_ = earlier_;
  Real rest_ = 0;
  Real allowed_ = 0;
  Real third_share_ = 0;  ///< that the last coefficient but two counts by
};

/// Makes steps from Taylor series: as long as the ground's acceleration is smooth, or as the highest order
/// allows. The order is the lowest whose last coefficients are below the tolerance, and that leaves none of
/// the body force's out; where there is none, the step is shorter (body_force.hpp).
template <class Real, int N>
class TaylorSteps {
 public:
  /// Keeps a reference to `model`.
  TaylorSteps(const Model<Real, N>& model, const SolveOptions& options)
      : model_(model),
        forces_(options.validity),
        tolerance_(std::max<Real>(Real(options.tolerance), 4 * std::numeric_limits<Real>::epsilon())) {}

  /// A step from `offset` into a ground piece, `remaining` at most, with margins of `watched` interfaces.
  DenseOutput<Real, N> operator()(const State<Real, N>& state, const Directions<Real, N>& directions,
                                  const Linkage<Real, N>& linkage, const GroundPiece<Real>& piece,
                                  const Real& offset, const Real& remaining, const Interfaces& watched) {
    const Real step = length(piece, remaining);
    ScaledBodyForce<Real> body_force = scaled_body_force(model_.gravity, piece, offset, step);
    const std::size_t body_force_terms = body_force.terms();
    const bool applied = !body_force.pushes.empty() || !model_.restraints.empty();
    if (is_closed(state.pattern) && !applied) {
      DenseOutput<Real, N> output{step, state, {}, {}};
      margins_at_rest(linkage, body_force, watched, output);
      lengthen(output.length, body_force_terms);
      return output;
    }
    StepStart<Real, N> start{{}, {}, {}, step, rate_};
    typename ChainSeries<Real, N>::Directions block_directions;
    for (std::size_t k = 0; k < linkage.size(); ++k) {
      start.sides[k] = Real(sign(state.pattern[k]));
      start.angles[k] = state.angles[k];
      start.advances[k] = state.velocities[k] * step;
      block_directions[k] = {directions.cosine[k], directions.sine[k]};
    }
    std::optional<AppliedSeries<Real, N>> forces;
    if (applied) forces.emplace(model_, start.sides, step);
    ChainSeries<Real, N> series(linkage, model_.equations, {forces_, watched.any()}, block_directions,
                                start.advances, applied ? &*forces : nullptr);
    series.extend(0, body_force);
    const Real ratio = start.landing(series);
    if (ratio < 1) {
      start.shorten(ratio);
      shorten(body_force, ratio);
      series.shorten(ratio);
    }
    Convergence<Real> convergence(tolerance_);
    bool reached = false;
    std::size_t orders = 0;
    for (; !(reached && orders >= body_force_terms) && orders < max_orders<Real>; ++orders) {
      if (orders > 0) series.extend(orders, body_force);
      reached = convergence.note_order(start, series, orders);
    }
    DenseOutput<Real, N> output{start.length, state, {}, {}};
    read(start, series, orders, watched, output);
    if (forces_) read_forces(series, orders, output);
    if (applied) output.lengths = series.lengths(orders);
    fit(reached ? Real(0) : convergence.excess(), orders, output);
    return output;
  }

  /// Length of the next step, with `remaining` s of a ground piece to go, unless something ends it, s.
  Real length(const GroundPiece<Real>& piece, const Real& remaining) const {
    return std::min({remaining, longest_, longest_series(piece)});
  }

  /// Shortens a step whose series did not get down to the tolerance, and had `excess` times as much left;
  /// lengthens the next where it did easily. Of n orders, what is left goes with the length's n-th power at
  /// least, and what is allowed with its third at most; so the second ratio is short enough. The first leaves
  /// room, and is the lesser one but for a large excess.
  void fit(const Real& excess, std::size_t orders, DenseOutput<Real, N>& output) {
    if (excess > 1) {
      const Real ratio = std::min<Real>(pow(excess, Real(-1) / Real(orders - 1)) * Real(0.9),
                                        pow(excess, Real(-1) / Real(orders - 3)));
      output.length *= ratio;
      longest_ = output.length;
      for (auto& angle : output.angles) rescale(angle, ratio);
      for (auto& restraint_length : output.lengths) rescale(restraint_length, ratio);
      for (auto& margin : output.margins) {
        rescale(margin.right, ratio);
        rescale(margin.left, ratio);
      }
      for (auto& force : output.forces) {
        rescale(force.normal, ratio);
        rescale(force.tangential, ratio);
      }
    } else {
      lengthen(output.length, orders);
    }
  }

  /// Lengthens the next step where one of a length got down to the tolerance easily.
  void lengthen(const Real& step, std::size_t orders) {
    if (step == longest_ && orders + 2 < max_orders<Real>) longest_ *= Real(1.25);
  }

  const Real& longest() const { return longest_; }  ///< s, for the next step
  const Real& tolerance() const { return tolerance_; }
  const Real& rate() const { return rate_; }

 private:
  /// The margins of a stack at rest: body forces act at its centres of mass.
  void margins_at_rest(const Linkage<Real, N>& linkage, const ScaledBodyForce<Real>& body_force,
                       const Interfaces& watched, DenseOutput<Real, N>& output) const {
    Real moment = 0;  // of the masses above an interface, about its height, kg·m
    Real aside = 0;   // likewise, about its middle
    for (std::size_t k = linkage.size(); k-- > 0;) {
      moment += linkage.moment_y[k];
      aside += linkage.moment_x[k];
      if (forces_) forces_at_rest(linkage.mass[k], body_force, output.length, output.forces[k]);
      if (!watched.test(k)) continue;
      const Real push = linkage.mass[k] * model_.stack.half_width[static_cast<int>(k)];
      MarginPolynomials<Real>& margin = output.margins[k];
      margin.right.terms = margin.left.terms = std::max(body_force.x.terms, body_force.y.terms);
      for (std::size_t n = 0; n < margin.right.terms; ++n) {
        const Real upright = n < body_force.y.terms ? -body_force.y[n] * push : Real(0);
        Real lean = n < body_force.x.terms ? -body_force.x[n] * moment : Real(0);
        if (n < body_force.y.terms) lean += body_force.y[n] * aside;
        margin.right[n] = upright + lean;
        margin.left[n] = upright - lean;
      }
    }
  }

  /// What an interface carries of a mass that is at rest above it.
  static void forces_at_rest(const Real& mass, const ScaledBodyForce<Real>& body_force, const Real& length,
                             ForcePolynomials<Real>& force) {
    const Real scale = -mass / (length * length);
    force.normal.terms = force.tangential.terms = std::max(body_force.x.terms, body_force.y.terms);
    for (std::size_t n = 0; n < force.normal.terms; ++n) {
      force.normal[n] = n < body_force.y.terms ? body_force.y[n] * scale : Real(0);
      force.tangential[n] = n < body_force.x.terms ? body_force.x[n] * scale : Real(0);
    }
  }

  void read(const StepStart<Real, N>& start, const ChainSeries<Real, N>& series, std::size_t orders,
            const Interfaces& watched, DenseOutput<Real, N>& output) const {
    for (std::size_t k = 0; k < series.size(); ++k) {
      if (output.start.pattern[static_cast<int>(k)] != Contact::closed) {
        Polynomial<Real>& angle = output.angles[k];
        angle.terms = orders + 2;
        angle[0] = start.angles[k];
        angle[1] = start.advances[k];
        for (std::size_t n = 0; n < orders; ++n) angle[n + 2] = series.angle(k, n);
      } else if (watched.test(k)) {
        MarginPolynomials<Real>& margin = output.margins[k];
        margin.right.terms = margin.left.terms = orders;
        for (std::size_t n = 0; n < orders; ++n) {
          const auto coefficient = series.margin(k, n, series.push(k, n));
          margin.right[n] = coefficient.right;
          margin.left[n] = coefficient.left;
        }
      }
    }
  }

  void read_forces(const ChainSeries<Real, N>& series, std::size_t orders,
                   DenseOutput<Real, N>& output) const {
    const Real scale = 1 / (output.length * output.length);
    for (int k = 0; k < model_.stack.size(); ++k) {
      ForcePolynomials<Real>& force_series = output.forces[k];
      force_series.normal.terms = force_series.tangential.terms = orders;
      for (std::size_t n = 0; n < orders; ++n) {
        const auto force = series.force(static_cast<std::size_t>(k), face(model_.stack, k), n);
        force_series.normal[n] = force.normal * scale;
        force_series.tangential[n] = force.tangential * scale;
      }
    }
  }

  const Model<Real, N>& model_;
  bool forces_;  ///< whether steps tell the forces
  Real tolerance_;
  Real rate_ = sqrt(model_.gravity / (2 * model_.stack.half_height.sum()));  ///< √(g/H), 1/s
  Real longest_ = 1 / rate_;                                                 ///< s, for the next step
};

}  // namespace rockstack
