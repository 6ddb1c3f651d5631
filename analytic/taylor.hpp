#pragma once

#include "analytic/linkage.hpp"
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

/// 1/i.
template <class Real>
inline const std::array<Real, max_terms<Real> + 1> reciprocals = [] {
  std::array<Real, max_terms<Real> + 1> result{};
  for (std::size_t i = 1; i < result.size(); ++i) result[i] = Real(1) / Real(i);
  return result;
}();

/// The series of a chain's motion over one step. Real may also be a pack of numbers that are computed side by
/// side.
template <class Real, int N>
class ChainSeries {
 public:
  using Series = std::array<Real, max_terms<Real>>;

  /// From relative angles in rad and relative velocities times the step's length. Keeps a reference to
  /// `linkage`.
  ChainSeries(const Linkage<Real, N>& linkage, bool linear, const PerBlock<Real, N>& angles,
              const PerBlock<Real, N>& advances)
      : linkage_(linkage), linear_(linear) {
    start(angles, advances);
    factorise();
  }

  /// Computes (φ'')ₙ of all interfaces from all lower orders; `pull_x` and `pull_y` are coefficients 0 … n.
  void extend(std::size_t n, const Polynomial<Real>& pull_x, const Polynomial<Real>& pull_y) {
    std::array<Point2, capacity(N)> bends;
    for (std::size_t k = 0; k < size(); ++k)
      bends[k] = linear_ ? Point2{Real(0), Real(0)} : known_bend(rows_[k], n);
    couple(n, bends, pull_x, pull_y);
    PerBlock<Real, N> known;
    for (std::size_t k = size(); k-- > 0;)
      known[k] = moment(rows_[k], n) + (k + 1 < size() ? known[k + 1] : Real(0));
    const PerBlock<Real, N> relative = solve(known);
    Real spin = 0;
    for (std::size_t k = 0; k < size(); ++k) {
      Row& row = rows_[k];
      row.relative[n] = relative[k];
      row.reaction[n] = known[k];
      for (std::size_t j = 0; j < size(); ++j) row.reaction[n] += mass_[k][j] * relative[j];
      spin += relative[k];
      bends[k].x -= row.sine[0] * spin;
      bends[k].y += row.cosine[0] * spin;
      row.weighted[n + 2] = spin * reciprocals<Real>[n + 1];
      const Real twice = reciprocals<Real>[n + 1] * reciprocals<Real>[n + 2];
      row.cosine[n + 2] = linear_ ? Real(0) : bends[k].x * twice;
      row.sine[n + 2] = linear_ ? Real(0) : bends[k].y * twice;
    }
    couple(n, bends, pull_x, pull_y);
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

  /// Moment about the pivot of interface k, about its middle where it is closed; order n.
  const Real& reaction(std::size_t k, std::size_t n) const { return rows_[k].reaction[n]; }

 private:
  struct Point2 {
    Real x, y;
  };
  struct Row {
    Series weighted;       // i times coefficient i of ψ
    Series cosine, sine;   // of ψ
    Series across, along;  // what the cosine and the sine are multiplied by in the block's equation
    Series relative;       // φ''
    Series reaction;
    Series force_x, force_y;  // on the block and all above
  };

  void start(const PerBlock<Real, N>& angles, const PerBlock<Real, N>& advances) {
    using std::cos;
    using std::sin;
    Real angle = 0;
    Real advance = 0;
    for (std::size_t k = 0; k < size(); ++k) {
      Row& row = rows_[k];
      angle += angles[k];
      advance += advances[k];
      row.weighted[1] = advance;
      row.cosine[0] = linear_ ? Real(1) : cos(angle);
      row.sine[0] = linear_ ? Real(0) : sin(angle);
      row.cosine[1] = linear_ ? Real(0) : -row.sine[0] * advance;
      row.sine[1] = linear_ ? Real(0) : row.cosine[0] * advance;
    }
  }

  Point2 turned_link(std::size_t k) const {
    return turned_by(rows_[k], linkage_.link_x[k], linkage_.link_y[k]);
  }
  static Point2 turned_by(const Row& row, const Real& x, const Real& y) {
    return {x * row.cosine[0] + y * row.sine[0], y * row.cosine[0] - x * row.sine[0]};
  }

  /// The mass matrix of the relative angles, and its factors L D Lᵀ with closed interfaces held.
  void factorise() {
    for (std::size_t j = 0; j < size(); ++j) {
      const Point2 moment = turned_by(rows_[j], linkage_.moment_x[j], linkage_.moment_y[j]);
      mass_[j][j] = linkage_.inertia[j];
      for (std::size_t i = 0; i < j; ++i) {
        const Point2 link = turned_link(i);
        mass_[i][j] = mass_[j][i] = link.x * moment.x + link.y * moment.y;
      }
    }
    for (std::size_t i = size() - 1; i-- > 0;) {
      for (std::size_t j = 0; j < size(); ++j) mass_[i][j] += mass_[i + 1][j];
    }
    for (std::size_t j = size() - 1; j-- > 0;) {
      for (std::size_t i = 0; i < size(); ++i) mass_[i][j] += mass_[i][j + 1];
    }
    for (std::size_t i = 0; i < size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        Real sum = mass_[i][j] * linkage_.free[i] * linkage_.free[j];
        if (i == j) sum += Real(1) - linkage_.free[i];
        for (std::size_t m = 0; m < j; ++m) sum -= factors_[i][m] * factors_[m][m] * factors_[j][m];
        factors_[i][j] = i == j ? sum : sum * inverse_[j];
      }
      inverse_[i] = Real(1) / factors_[i][i];
    }
  }

  /// −M⁻¹ of the moments of open interfaces.
  PerBlock<Real, N> solve(const PerBlock<Real, N>& moments) const {
    PerBlock<Real, N> x;
    for (std::size_t i = 0; i < size(); ++i) {
      x[i] = -moments[i] * linkage_.free[i];
      for (std::size_t m = 0; m < i; ++m) x[i] -= factors_[i][m] * x[m];
    }
    for (std::size_t i = size(); i-- > 0;) {
      x[i] *= inverse_[i];
      for (std::size_t m = i + 1; m < size(); ++m) x[i] -= factors_[m][i] * x[m];
    }
    return x;
  }

  /// The known parts of (c'')ₙ and (s'')ₙ.
  static Point2 known_bend(const Row& row, std::size_t n) {
    Real x = 0;
    Real y = 0;
    for (std::size_t j = 1; j < n + 2; ++j) {
      x -= row.weighted[j] * row.sine[n + 2 - j];
      y += row.weighted[j] * row.cosine[n + 2 - j];
    }
    return {Real(n + 1) * x, Real(n + 1) * y};
  }

  /// Order n of what each block feels of the others and of the pull.
  void couple(std::size_t n, const std::array<Point2, capacity(N)>& bends, const Polynomial<Real>& pull_x,
              const Polynomial<Real>& pull_y) {
    Point2 below{n < pull_x.terms ? -pull_x[n] : Real(0), n < pull_y.terms ? -pull_y[n] : Real(0)};
    std::array<Point2, capacity(N)> pivots;
    for (std::size_t k = 0; k < size(); ++k) {
      pivots[k] = below;
      below.x += linkage_.link_x[k] * bends[k].x + linkage_.link_y[k] * bends[k].y;
      below.y += linkage_.link_y[k] * bends[k].x - linkage_.link_x[k] * bends[k].y;
    }
    Point2 above{Real(0), Real(0)};
    for (std::size_t k = size(); k-- > 0;) {
      const Real& sx = linkage_.moment_x[k];
      const Real& sy = linkage_.moment_y[k];
      const Real& lx = linkage_.link_x[k];
      const Real& ly = linkage_.link_y[k];
      Row& row = rows_[k];
      row.across[n] = sy * pivots[k].x - sx * pivots[k].y + ly * above.x - lx * above.y;
      row.along[n] = -(sx * pivots[k].x + sy * pivots[k].y + lx * above.x + ly * above.y);
      above.x += sx * bends[k].x + sy * bends[k].y;
      above.y += sy * bends[k].x - sx * bends[k].y;
      row.force_x[n] = linkage_.mass[k] * pivots[k].x + above.x;
      row.force_y[n] = linkage_.mass[k] * pivots[k].y + above.y;
    }
  }

  /// Order n of Sₖ⊥ · (…) + Lₖ⊥ · (…).
  Real moment(const Row& row, std::size_t n) const {
    Real sum = 0;
    for (std::size_t i = 0; i <= n; ++i)
      sum += row.cosine[i] * row.across[n - i] + row.sine[i] * row.along[n - i];
    return sum;
  }

  std::size_t size() const { return linkage_.size(); }

  const Linkage<Real, N>& linkage_;
  bool linear_;
  std::array<Row, capacity(N)> rows_;
  std::array<PerBlock<Real, N>, capacity(N)> mass_, factors_;
  PerBlock<Real, N> inverse_;
};

}  // namespace rockstack
