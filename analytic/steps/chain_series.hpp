#pragma once

#include "analytic/mechanics/pattern_solution.hpp"
#include "analytic/steps/applied_series.hpp"
#include "analytic/steps/block_series.hpp"
#include "analytic/steps/body_force.hpp"

namespace rockstack {

// A step as a Taylor series, computed order by order. In s = τ/length, all is built from the series of the
// blocks' absolute angles ψ, of c = cos ψ and of s = sin ψ. From c' = −s ψ' and s' = c ψ',
//
//     (c'')ₙ = −s₀ (ψ'')ₙ + known,   (s'')ₙ = c₀ (ψ'')ₙ + known,
//
// with the known part a sum of products of lower coefficients. So Lagrange's equations (linkage.hpp) give the
// coefficients (ψ'')ₙ of all blocks from one linear system, whose matrix is the mass matrix at the start of
// the step, factorised once. Relative angles have sums from the top down; held interfaces drop out.

/// The series of a chain's motion over one step, of numbers or of packs of them, computed side by side.
template <class Real, int N>
class ChainSeries {
 public:
  using Point2 = PlaneVector<Real>;
  using PlaneSeries = typename BlockSeries<Real>::PlaneSeries;
  using Directions = PerBlock<PlaneVector<Real>, N>;

  /// What a series tells besides motion. Margins are made of forces too.
  struct Options {
    bool forces;   ///< push() and force()
    bool margins;  ///< these and margin()
  };

  /// From directions, and relative velocities times the step's length. Keeps references to `linkage` and to
  /// the forces that are applied, or null.
  ChainSeries(const Linkage<Real, N>& linkage, Equations equations, const Options& options,
              const Directions& directions, const PerBlock<Real, N>& advances,
              AppliedSeries<Real, N>* applied = nullptr)
      : linkage_(linkage),
        applied_(applied),
        linear_(equations != Equations::nonlinear),
        small_angles_(equations == Equations::small_angle),
        forces_(options.forces || options.margins),
        margins_(options.margins) {
    start(directions, advances);
  }

  std::size_t size() const { return linkage_.size(); }

  /// Lengths of restraints over so many orders. Precondition: forces are applied.
  std::vector<Polynomial<Real>> lengths(std::size_t orders_known) const {
    return applied_->lengths(orders_known, linkage_, blocks_);
  }

  /// Makes the step `ratio` times as long, where order 0 is known, which goes with the length squared.
  void shorten(const Real& ratio) {
    const Real square = ratio * ratio;
    for (std::size_t k = 0; k < size(); ++k) {
      BlockSeries<Real>& block = blocks_[k];
      block.weighted[1] *= ratio;
      block.weighted[2] *= square;
      block.direction[1] = ratio * block.direction[1];
      block.direction[2] = square * block.direction[2];
      block.coupling[0] = square * block.coupling[0];
      block.relative[0] *= square;
      if (!forces_) continue;
      block.force[0] = square * block.force[0];
      if (margins_) block.reaction[0] *= square;
    }
    if (applied_) applied_->shorten(ratio, linkage_, blocks_);
  }

  /// Computes (φ'')ₙ of all interfaces from all lower orders, 0 first.
  void extend(std::size_t n, const ScaledBodyForce<Real>& body_force) {
    if (applied_) {
      extend_by<true>(n, body_force);
    } else if constexpr (unrolled) {
      (this->*orders[n])(body_force);
    } else {
      extend_by<false>(n, body_force);
    }
  }

  /// (φ'')ₙ of an interface.
  const Real& relative(std::size_t k, std::size_t n) const { return blocks_[k].relative[n]; }

  /// φₙ₊₂ of an interface.
  Real angle(std::size_t k, std::size_t n) const {
    return relative(k, n) * reciprocals<Number<Real>>[n + 1] * reciprocals<Number<Real>>[n + 2];
  }

  /// Normal force at interface k, order n, in kg·m of s-time.
  Real push(std::size_t k, std::size_t n) const {
    if (k == 0 || linear_) return blocks_[k].force[n].y;
    return force(k, blocks_[k - 1].direction, n).normal;
  }

  /// Forces at interface k across and along a block's face (the ground's: −1); order n, likewise.
  struct Force {
    Real normal, tangential;
  };
  Force force(std::size_t k, int face, std::size_t n) const {
    const Point2& own = blocks_[k].force[n];
    if (face < 0 || linear_)
      return {own.y, face < 0 || !small_angles_ ? own.x
                                                : own.x - pushed_aside(k, static_cast<std::size_t>(face), n)};
    return force(k, direction(static_cast<std::size_t>(face)), n);
  }
  /// Force along a face of this direction.
  Force force(std::size_t k, const PlaneSeries& direction, std::size_t n) const {
    const BlockSeries<Real>& block = blocks_[k];
    Force sum{Real(0), Real(0)};
    for (std::size_t i = 0; i <= n; ++i) {
      sum.normal += direction[i].y * block.force[n - i].x + direction[i].x * block.force[n - i].y;
      sum.tangential += direction[i].x * block.force[n - i].x - direction[i].y * block.force[n - i].y;
    }
    return sum;
  }

  /// The cosine and the sine of a block's angle.
  const PlaneSeries& direction(std::size_t block) const { return blocks_[block].direction; }

  /// Margins of a closed interface, from its push(), order n, in kg·m² of s-time.
  Margins<Real> margin(std::size_t k, std::size_t n, const Real& push) const {
    const Real half = push * linkage_.width[k];
    return {half + blocks_[k].reaction[n], half - blocks_[k].reaction[n]};
  }

 private:
  /// Short stacks in the processor's own numbers have each order compiled by itself.
  static constexpr bool unrolled = N != Eigen::Dynamic && std::is_arithmetic_v<Number<Real>>;

  void start(const Directions& directions, const PerBlock<Real, N>& advances) {
    Real advance = 0;
    for (std::size_t k = 0; k < size(); ++k) {
      BlockSeries<Real>& block = blocks_[k];
      advance += advances[k];
      block.weighted[1] = advance;
      block.direction[0] = directions[k];
      block.direction[1] = linear_ ? none() : advance * ahead(directions[k]);
    }
    if (small_angles_) return start_small(directions);
    mass_.factorise(linkage_, directions);
  }

  /// Order n, a number or the constant of one, of a chain with or without applied forces.
  template <bool with_forces, class Order>
  void extend_by(Order n, const ScaledBodyForce<Real>& body_force) {
    const Point2 base_acceleration{n < body_force.x.terms ? -body_force.x[n] : Real(0),
                                   n < body_force.y.terms ? -body_force.y[n] : Real(0)};
    PerBlock<Point2, N> second_derivatives;  // of directions, as far as they are known, then all
    for (std::size_t k = 0; k < size(); ++k)
      second_derivatives[k] = linear_ ? none() : blocks_[k].known_second_derivative(n);
    // A block alone is coupled to nothing but the body force.
    const std::size_t couplings =
        size() > 1 ? n : std::min<std::size_t>(n, std::max(body_force.x.terms, body_force.y.terms));
    PerBlock<Real, N> known = known_moments(n, couplings, second_derivatives, base_acceleration);
    if (small_angles_) add_levers(n, body_force.y, known);
    if constexpr (with_forces) applied_->extend(n, body_force.pushes, linkage_, blocks_, known);
    PerBlock<Real, N> opposed;
    for (std::size_t k = 0; k < size(); ++k) opposed[k] = -known[k];
    const PerBlock<Real, N> relative = mass_.constrained.solve(opposed);
    if (margins_)
      for (std::size_t k = 0; k < size(); ++k) {
        blocks_[k].reaction[n] = known[k];
        for (std::size_t j = 0; j < size(); ++j) blocks_[k].reaction[n] += mass_.matrix[k][j] * relative[j];
      }
    Real angular_acceleration = 0;
    for (std::size_t k = 0; k < size(); ++k) {
      BlockSeries<Real>& block = blocks_[k];
      block.relative[n] = relative[k];
      angular_acceleration = k == 0 ? relative[0] : angular_acceleration + relative[k];
      block.weighted[n + 2] = angular_acceleration * reciprocals<Number<Real>>[n + 1];
      const Real twice = reciprocals<Number<Real>>[n + 1] * reciprocals<Number<Real>>[n + 2];
      second_derivatives[k] = second_derivatives[k] + angular_acceleration * ahead(block.direction[0]);
      block.direction[n + 2] = linear_ ? none() : twice * second_derivatives[k];
    }
    couple(n, second_derivatives, base_acceleration);
    if constexpr (with_forces)
      if (forces_) applied_->add_forces(n, body_force.pushes, blocks_);
  }

  template <std::size_t n>
  void extend_to(const ScaledBodyForce<Real>& body_force) {
    extend_by<false>(std::integral_constant<std::size_t, n>{}, body_force);
  }

  using Extend = void (ChainSeries::*)(const ScaledBodyForce<Real>&);
  template <std::size_t... n>
  static constexpr std::array<Extend, sizeof...(n)> list(std::index_sequence<n...>) {
    return {&ChainSeries::extend_to<n>...};
  }
  static constexpr auto orders = list(std::make_index_sequence < unrolled ? max_terms<Real> - 2 : 0 > {});

  /// Order n of the moments about all pivots, but for what the blocks' accelerations (ψ'')ₙ will add.
  template <class Order>
  PerBlock<Real, N> known_moments(Order n, std::size_t couplings,
                                  const PerBlock<Point2, N>& second_derivatives,
                                  const Point2& base_acceleration) const {
    PerBlock<Real, N> moments;
    Point2 below = base_acceleration;
    for (std::size_t k = 0; k < size(); ++k) {
      moments[k] = across(mass_.moments[k], below);
      if (!linear_) moments[k] += blocks_[k].past_moment(n, couplings);
      if (k + 1 < size())
        below = below + turned(second_derivatives[k], linkage_.link_x[k], linkage_.link_y[k]);
    }
    Point2 above = none();
    for (std::size_t k = size() - 1; k-- > 0;) {
      above = above + turned(second_derivatives[k + 1], linkage_.moment_x[k + 1], linkage_.moment_y[k + 1]);
      moments[k] += moments[k + 1] + across(mass_.links[k], above);
    }
    return moments;
  }

  /// Order n of what each block feels of the others and of the base's acceleration, and of the forces.
  template <class Order>
  void couple(Order n, const PerBlock<Point2, N>& second_derivatives, const Point2& base_acceleration) {
    Point2 below = base_acceleration;
    for (std::size_t k = 0; k < size(); ++k) {
      BlockSeries<Real>& block = blocks_[k];
      block.coupling[n] = coupling_of(below, linkage_.moment_x[k], linkage_.moment_y[k]);
      if (forces_) block.force[n] = linkage_.mass[k] * below;
      if (k + 1 < size())
        below = below + turned(second_derivatives[k], linkage_.link_x[k], linkage_.link_y[k]);
    }
    Point2 above = none();
    for (std::size_t k = size(); k-- > 0;) {
      BlockSeries<Real>& block = blocks_[k];
      if (k + 1 < size())
        block.coupling[n] = block.coupling[n] + coupling_of(above, linkage_.link_x[k], linkage_.link_y[k]);
      if (k == 0 && !forces_) break;
      above = above + turned(second_derivatives[k], linkage_.moment_x[k], linkage_.moment_y[k]);
      if (forces_) block.force[n] = block.force[n] + above;
    }
  }

  static Point2 none() { return {Real(0), Real(0)}; }

  /// Starts the series of small angles: directions are (1, θ); all but the levers of weight is upright.
  void start_small(Directions directions) {
    for (std::size_t k = 0; k < size(); ++k) {
      angles_[k] = directions[k].y;
      directions[k] = blocks_[k].direction[0] = {Real(1), Real(0)};
    }
    mass_.factorise(linkage_, directions);
  }

  /// ψₙ of a block, of small angles alone.
  Real small_angle(std::size_t k, std::size_t n) const {
    return n == 0 ? angles_[k] : blocks_[k].weighted[n] * reciprocals<Number<Real>>[n];
  }

  /// Order n of the moments of weight about all pivots: with its levers Sₓ + Sᵧθ, where θ is small.
  void add_levers(std::size_t n, const Polynomial<Real>& weight, PerBlock<Real, N>& moments) const {
    Real above = 0;
    for (std::size_t k = size(); k-- > 0;) {
      for (std::size_t i = 0; i <= n; ++i) {
        if (n - i >= weight.terms) continue;
        const Real upright = linkage_.moment_y[k] * small_angle(k, i);
        above += (i == 0 ? upright + linkage_.lever[k] : upright) * weight[n - i];
      }
      moments[k] += above;
    }
  }

  /// Order n of the normal force at interface k times the small angle of a block's face.
  Real pushed_aside(std::size_t k, std::size_t face, std::size_t n) const {
    Real sum = 0;
    for (std::size_t i = 0; i <= n; ++i) sum += small_angle(face, i) * blocks_[k].force[n - i].y;
    return sum;
  }

  const Linkage<Real, N>& linkage_;
  AppliedSeries<Real, N>* applied_;
  bool linear_;        ///< without velocity terms
  bool small_angles_;  ///< of the linear equations, those of small angles
  bool forces_;
  bool margins_;
  PerBlock<Real, N> angles_;  ///< at the start, of small angles alone, rad
  std::array<BlockSeries<Real>, capacity(N)> blocks_;
  ChainMass<Real, N> mass_;  ///< at the start of the step
};

}  // namespace rockstack
