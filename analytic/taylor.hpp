#pragma once

#include <type_traits>
#include <utility>

#include "analytic/chain_mass.hpp"
#include "analytic/pull.hpp"

namespace rockstack {

// A step as a Taylor series, computed order by order. In s = τ/length, all is built from the series of the
// blocks' absolute angles ψ, of c = cos ψ and of s = sin ψ. From c' = −s ψ' and s' = c ψ',
//
//     (c'')ₙ = −s₀ (ψ'')ₙ + known,   (s'')ₙ = c₀ (ψ'')ₙ + known,
//
// with the known part a sum of products of lower coefficients. So Lagrange's equations (linkage.hpp) give the
// coefficients (ψ'')ₙ of all blocks from one linear system, whose matrix is the mass matrix at the start of
// the step: it is factorised once. What belongs to relative angles are sums from the top down, and held
// interfaces drop out.

/// What a number of a calculation is made of: itself, or what a pack of numbers holds many of.
template <class Real>
struct NumberIn {
  using type = Real;
};
template <class Real>
using Number = typename NumberIn<Real>::type;

/// 1/i.
template <class Real>
inline const std::array<Real, max_terms<Real> + 1> reciprocals = [] {
  std::array<Real, max_terms<Real> + 1> result{};
  for (std::size_t i = 1; i < result.size(); ++i) result[i] = Real(1) / Real(i);
  return result;
}();

/// The cosine and the sine of each block's angle, from relative angles; upright for the linear equations.
template <class Real, int N>
PerBlock<PlaneVector<Real>, N> block_directions(bool linear, std::size_t size,
                                                const PerBlock<Real, N>& angles) {
  using std::cos;
  using std::sin;
  PerBlock<PlaneVector<Real>, N> result;
  Real angle = 0;
  for (std::size_t k = 0; k < size; ++k) {
    angle += angles[k];
    result[k] = linear ? PlaneVector<Real>{Real(1), Real(0)} : PlaneVector<Real>{cos(angle), sin(angle)};
  }
  return result;
}

/// The series of a chain's motion over one step. Real may also be a pack of numbers that are computed side by
/// side.
template <class Real, int N>
class ChainSeries {
 public:
  using Series = std::array<Real, max_terms<Real>>;
  using Directions = PerBlock<PlaneVector<Real>, N>;

  /// From the blocks' directions and relative velocities times the step's length; `forces` tells whether
  /// push(), force() and reaction() will be asked for. Keeps a reference to `linkage`.
  ChainSeries(const Linkage<Real, N>& linkage, bool linear, bool forces, const Directions& directions,
              const PerBlock<Real, N>& advances)
      : linkage_(linkage), linear_(linear), forces_(forces) {
    start(directions, advances);
  }

  std::size_t size() const { return linkage_.size(); }

  /// Makes the step `ratio` times as long, where order 0 is known: its coefficients go with the length
  /// squared.
  void shorten(const Real& ratio) {
    const Real square = ratio * ratio;
    for (std::size_t k = 0; k < size(); ++k) {
      Row& row = rows_[k];
      for (Series* series : {&row.weighted, &row.cosine, &row.sine}) {
        (*series)[1] *= ratio;
        (*series)[2] *= square;
      }
      for (Series* series : {&row.across, &row.along, &row.relative}) (*series)[0] *= square;
      if (!forces_) continue;
      for (Series* series : {&row.reaction, &row.force_x, &row.force_y}) (*series)[0] *= square;
    }
  }

  /// Computes (φ'')ₙ of all interfaces from all lower orders, 0 first.
  void extend(std::size_t n, const Pull<Real>& pull) {
    if constexpr (unrolled) {
      (this->*orders[n])(pull);
    } else {
      extend_by(n, pull);
    }
  }

  /// (φ'')ₙ of an interface.
  const Real& relative(std::size_t k, std::size_t n) const { return rows_[k].relative[n]; }

  /// Normal force at interface k, order n, in kg·m of s-time.
  Real push(std::size_t k, std::size_t n) const {
    if (k == 0 || linear_) return rows_[k].force_y[n];
    const Row& face = rows_[k - 1];
    Real sum = 0;
    for (std::size_t i = 0; i <= n; ++i)
      sum += face.sine[i] * rows_[k].force_x[n - i] + face.cosine[i] * rows_[k].force_y[n - i];
    return sum;
  }

  /// Forces at interface k along the normal and the direction of a block's face (the ground's: −1); order n,
  /// likewise.
  struct Force {
    Real normal, tangential;
  };
  Force force(std::size_t k, int face, std::size_t n) const {
    const Row& row = rows_[k];
    if (face < 0 || linear_) return {row.force_y[n], row.force_x[n]};
    const auto towards = static_cast<std::size_t>(face);
    return force(k, cosine(towards), sine(towards), n);
  }
  /// Likewise, along a face whose angle has these.
  Force force(std::size_t k, const Series& cosines, const Series& sines, std::size_t n) const {
    const Row& row = rows_[k];
    Force sum{Real(0), Real(0)};
    for (std::size_t i = 0; i <= n; ++i) {
      sum.normal += sines[i] * row.force_x[n - i] + cosines[i] * row.force_y[n - i];
      sum.tangential += cosines[i] * row.force_x[n - i] - sines[i] * row.force_y[n - i];
    }
    return sum;
  }

  const Series& cosine(std::size_t block) const { return rows_[block].cosine; }
  const Series& sine(std::size_t block) const { return rows_[block].sine; }

  /// Moment about the pivot of interface k, about its middle where it is closed; order n.
  const Real& reaction(std::size_t k, std::size_t n) const { return rows_[k].reaction[n]; }

 private:
  /// Short stacks in the processor's own numbers have each order compiled by itself.
  static constexpr bool unrolled = N != Eigen::Dynamic && std::is_arithmetic_v<Number<Real>>;

  using Point2 = PlaneVector<Real>;
  struct Row {
    Series weighted;       // i times coefficient i of ψ
    Series cosine, sine;   // of ψ
    Series across, along;  // what the cosine and the sine are multiplied by in the block's equation
    Series relative;       // φ''
    Series reaction;
    Series force_x, force_y;  // on the block and all above
  };

  void start(const Directions& directions, const PerBlock<Real, N>& advances) {
    Real advance = 0;
    for (std::size_t k = 0; k < size(); ++k) {
      Row& row = rows_[k];
      advance += advances[k];
      row.weighted[1] = advance;
      row.cosine[0] = directions[k].x;
      row.sine[0] = directions[k].y;
      row.cosine[1] = linear_ ? Real(0) : -row.sine[0] * advance;
      row.sine[1] = linear_ ? Real(0) : row.cosine[0] * advance;
    }
    mass_.factorise(linkage_, directions);
  }

  /// Order n, a number or the constant of one.
  template <class Order>
  void extend_by(Order n, const Pull<Real>& pull) {
    PerBlock<Point2, N> bends;
    for (std::size_t k = 0; k < size(); ++k)
      bends[k] = linear_ ? Point2{Real(0), Real(0)} : known_bend(rows_[k], n);
    couple(n, bends, pull);
    PerBlock<Real, N> known;
    for (std::size_t k = size(); k-- > 0;) {
      known[k] = moment(rows_[k], n);
      if (k + 1 < size()) known[k] += known[k + 1];
    }
    const PerBlock<Real, N> relative = mass_.solve(linkage_, known);
    if (forces_) {
      for (std::size_t k = 0; k < size(); ++k) {
        rows_[k].reaction[n] = known[k];
        for (std::size_t j = 0; j < size(); ++j) rows_[k].reaction[n] += mass_.matrix[k][j] * relative[j];
      }
    }
    PerBlock<Real, N> spins;
    Real spin = 0;
    for (std::size_t k = 0; k < size(); ++k) {
      Row& row = rows_[k];
      row.relative[n] = relative[k];
      spin = spins[k] = k == 0 ? relative[0] : spin + relative[k];
      row.weighted[n + 2] = spin * reciprocals<Number<Real>>[n + 1];
      const Real twice = reciprocals<Number<Real>>[n + 1] * reciprocals<Number<Real>>[n + 2];
      row.cosine[n + 2] = linear_ ? Real(0) : (bends[k].x - row.sine[0] * spin) * twice;
      row.sine[n + 2] = linear_ ? Real(0) : (bends[k].y + row.cosine[0] * spin) * twice;
    }
    couple(n, spins);
  }

  template <std::size_t n>
  void extend_to(const Pull<Real>& pull) {
    extend_by(std::integral_constant<std::size_t, n>{}, pull);
  }

  using Extend = void (ChainSeries::*)(const Pull<Real>&);
  template <std::size_t... n>
  static constexpr std::array<Extend, sizeof...(n)> list(std::index_sequence<n...>) {
    return {&ChainSeries::extend_to<n>...};
  }
  static constexpr auto orders = list(std::make_index_sequence < unrolled ? max_terms<Real> - 2 : 0 > {});

  /// The known parts of (c'')ₙ and (s'')ₙ.
  template <class Order>
  static Point2 known_bend(const Row& row, Order n) {
    Real x = row.weighted[1] * row.sine[n + 1];
    Real y = row.weighted[1] * row.cosine[n + 1];
    for (std::size_t j = 2; j < n + 2; ++j) {
      x += row.weighted[j] * row.sine[n + 2 - j];
      y += row.weighted[j] * row.cosine[n + 2 - j];
    }
    return {-Real(n + 1) * x, Real(n + 1) * y};
  }

  /// Order n of what each block feels of the others, as far as it is known, and of the pull.
  template <class Order>
  void couple(Order n, const PerBlock<Point2, N>& bends, const Pull<Real>& pull) {
    Point2 below{n < pull.x.terms ? -pull.x[n] : Real(0), n < pull.y.terms ? -pull.y[n] : Real(0)};
    for (std::size_t k = 0; k < size(); ++k) {
      const Real& sx = linkage_.moment_x[k];
      const Real& sy = linkage_.moment_y[k];
      Row& row = rows_[k];
      row.across[n] = sy * below.x - sx * below.y;
      row.along[n] = -(sx * below.x + sy * below.y);
      if (forces_) {
        row.force_x[n] = linkage_.mass[k] * below.x;
        row.force_y[n] = linkage_.mass[k] * below.y;
      }
      if (k + 1 == size()) break;
      below.x += linkage_.link_x[k] * bends[k].x + linkage_.link_y[k] * bends[k].y;
      below.y += linkage_.link_y[k] * bends[k].x - linkage_.link_x[k] * bends[k].y;
    }
    Point2 above{Real(0), Real(0)};
    for (std::size_t k = size(); k-- > 0;) {
      const Real& sx = linkage_.moment_x[k];
      const Real& sy = linkage_.moment_y[k];
      if (k + 1 < size()) lean(n, k, above);
      if (k == 0 && !forces_) break;
      above.x += sx * bends[k].x + sy * bends[k].y;
      above.y += sy * bends[k].x - sx * bends[k].y;
      if (!forces_) continue;
      rows_[k].force_x[n] += above.x;
      rows_[k].force_y[n] += above.y;
    }
  }

  /// The rest of it, from the spins (ψ'')ₙ.
  template <class Order>
  void couple(Order n, const PerBlock<Real, N>& spins) {
    Point2 below{Real(0), Real(0)};
    for (std::size_t k = 0; k + 1 < size(); ++k) {
      below.x += spins[k] * mass_.links[k].y;
      below.y -= spins[k] * mass_.links[k].x;
      const Real& sx = linkage_.moment_x[k + 1];
      const Real& sy = linkage_.moment_y[k + 1];
      Row& row = rows_[k + 1];
      row.across[n] += sy * below.x - sx * below.y;
      row.along[n] -= sx * below.x + sy * below.y;
      if (!forces_) continue;
      row.force_x[n] += linkage_.mass[k + 1] * below.x;
      row.force_y[n] += linkage_.mass[k + 1] * below.y;
    }
    Point2 above{Real(0), Real(0)};
    for (std::size_t k = size(); k-- > 0;) {
      if (k + 1 < size()) lean(n, k, above);
      if (k == 0 && !forces_) break;
      above.x += spins[k] * mass_.moments[k].y;
      above.y -= spins[k] * mass_.moments[k].x;
      if (!forces_) continue;
      rows_[k].force_x[n] += above.x;
      rows_[k].force_y[n] += above.y;
    }
  }

  /// Adds what block k feels of those above it.
  template <class Order>
  void lean(Order n, std::size_t k, const Point2& above) {
    const Real& lx = linkage_.link_x[k];
    const Real& ly = linkage_.link_y[k];
    rows_[k].across[n] += ly * above.x - lx * above.y;
    rows_[k].along[n] -= lx * above.x + ly * above.y;
  }

  /// Order n of Sₖ⊥ · (…) + Lₖ⊥ · (…).
  template <class Order>
  static Real moment(const Row& row, Order n) {
    Real sum = row.cosine[0] * row.across[n] + row.sine[0] * row.along[n];
    for (std::size_t i = 1; i <= n; ++i)
      sum += row.cosine[i] * row.across[n - i] + row.sine[i] * row.along[n - i];
    return sum;
  }

  const Linkage<Real, N>& linkage_;
  bool linear_;
  bool forces_;
  std::array<Row, capacity(N)> rows_;
  ChainMass<Real, N> mass_;  ///< at the start of the step
};

}  // namespace rockstack
