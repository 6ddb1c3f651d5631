#pragma once

#include "analytic/scene/kinematics.hpp"

namespace rockstack {

template <class Real, int N>
using PerBlock = std::array<Real, static_cast<std::size_t>(capacity(N))>;

/// The mass matrix of relative angles, kg·m², as factors L D Lᵀ. Closed interfaces have the identity's rows,
/// which stacks of any number of blocks leave out: most interfaces of a column are closed.
template <class Real, int N>
class ConstrainedMass {
 public:
  /// `free` is 1 where an interface is open, 0 where it is closed; `mass(i, j)` is the matrix, i ≥ j.
  template <class Mass>
  void factorise(std::size_t blocks, const PerBlock<Real, N>& free, const Mass& mass) {
    rows_ = 0;
    for (std::size_t k = 0; k < blocks; ++k) {
      free_[k] = free[k];
      if constexpr (N == Eigen::Dynamic) {
        factors_[k][k] = 1;
        if (free[k] != 0) interfaces_[rows_++] = k;
      }
    }
    for (std::size_t row = 0; row < rows(); ++row) {
      const std::size_t i = interface(row);
      for (std::size_t column = 0; column <= row; ++column) {
        const std::size_t j = interface(column);
        Real sum = mass(i, j) * free[i] * free[j];
        if (i == j) sum += Real(1) - free[i];
        for (std::size_t below = 0; below < column; ++below) {
          const std::size_t m = interface(below);
          sum -= factors_[i][m] * factors_[m][m] * factors_[j][m];
        }
        factors_[i][j] = i == j ? sum : sum * inverse_[j];
      }
      inverse_[i] = Real(1) / factors_[i][i];
    }
  }

  /// Entry of D: what is left of a diagonal entry when the motions of the interfaces below are taken out of
  /// it.
  const Real& diagonal(std::size_t k) const { return factors_[k][k]; }

  /// The relative motions that take up generalised momenta; zero where an interface is closed. Series ask for
  /// them at every order, and a call costs more than the answer.
  [[gnu::always_inline]] PerBlock<Real, N> solve(const PerBlock<Real, N>& momenta) const {
    PerBlock<Real, N> x;
    if constexpr (N == Eigen::Dynamic) x.fill(0);
    for (std::size_t row = 0; row < rows(); ++row) {
      const std::size_t i = interface(row);
      x[i] = momenta[i] * free_[i];
      for (std::size_t below = 0; below < row; ++below)
        x[i] -= factors_[i][interface(below)] * x[interface(below)];
    }
    for (std::size_t row = rows(); row-- > 0;) {
      const std::size_t i = interface(row);
      x[i] *= inverse_[i];
      for (std::size_t above = row + 1; above < rows(); ++above)
        x[i] -= factors_[interface(above)][i] * x[interface(above)];
    }
    return x;
  }

 private:
  std::size_t rows() const { return N == Eigen::Dynamic ? rows_ : static_cast<std::size_t>(N); }
  std::size_t interface(std::size_t row) const { return N == Eigen::Dynamic ? interfaces_[row] : row; }

  std::size_t rows_ = 0;
  std::array<std::size_t, capacity(N)> interfaces_;  ///< of the rows
  PerBlock<Real, N> free_;
  std::array<PerBlock<Real, N>, capacity(N)> factors_;  ///< L below the diagonal, D on it
  PerBlock<Real, N> inverse_;                           ///< of D
};

/// What a stack is while its pattern lasts: a chain of pendulums. Block k turns by ψₖ about its pivot. With
/// constant Lₖ (from its pivot to the next) and the first moment of mass Sₖ = mₖrₖ + (mass above) Lₖ in its
/// own frame, both turned by ψₖ, a dot a time derivative and ⊥ a quarter turn, Lagrange's equation of ψₖ is
///
///     Jₖ ψ̈ₖ + Lₖ⊥ · Σ_{j>k} S̈ⱼ + Sₖ⊥ · (Σ_{j<k} L̈ⱼ − body force) = moment about the pivot of k − that about
///     k + 1
///
/// so that the left sides from k up add up to the moment about pivot k: zero where that interface is open.
template <class Real, int N>
struct Linkage {
  int blocks = 0;
  PerBlock<Real, N> moment_x, moment_y;  ///< S, kg·m
  PerBlock<Real, N> link_x, link_y;      ///< L, m
  PerBlock<Real, N> inertia;             ///< J = I + m r² + (mass above) L², kg·m²
  PerBlock<Real, N> mass;                ///< of the block and all above, kg
  PerBlock<Real, N> width;               ///< w, m
  PerBlock<Real, N> free;                ///< 1 where the interface below is open, 0 where it is closed
  PerBlock<Real, N> lever;  ///< of small angles alone: what would be Sₓ, which bears weight alone, kg·m

  std::size_t size() const { return static_cast<std::size_t>(N == Eigen::Dynamic ? blocks : N); }
};

/// `pattern` as side() takes it.
template <class Real, int N, class Sides>
Linkage<Real, N> make_linkage(const Stack<Real, N>& stack, const Sides& pattern) {
  Linkage<Real, N> linkage;
  linkage.blocks = stack.size();
  Real above = 0;  // mass, kg
  Real next = 0;   // where the pivot above is, from the middle, m
  for (std::size_t k = linkage.size(); k-- > 0;) {
    const Real mass = stack.mass[k];
    const Real pivots = side<Real>(pattern, k);
    const Real pivot = pivots * stack.half_width[k];
    const Real height = stack.half_height[k];
    const Real link = next - pivot;
    const Real centre_x = stack.centre_x[k] - pivot;
    const Real centre_y = stack.centre_y[k];
    linkage.moment_x[k] = above * link + mass * centre_x;
    linkage.moment_y[k] = above * (2 * height) + mass * centre_y;
    linkage.link_x[k] = link;
    linkage.link_y[k] = 2 * height;
    linkage.inertia[k] = stack.inertia[k] + mass * (centre_x * centre_x + centre_y * centre_y) +
                         above * (link * link + 4 * height * height);
    above += mass;
    linkage.mass[k] = above;
    linkage.width[k] = stack.half_width[k];
    linkage.free[k] = pivots * pivots;
    next = pivot;
    if (!stack.small_angles) continue;
    linkage.lever[k] = linkage.moment_x[k];
    linkage.moment_x[k] = linkage.link_x[k] = 0;
    linkage.inertia[k] = stack.inertia[k] + (mass + 4 * (above - mass)) * (height * height);
  }
  return linkage;
}

template <class Real>
struct PlaneVector {
  Real x, y;

  friend PlaneVector operator+(const PlaneVector& a, const PlaneVector& b) { return {a.x + b.x, a.y + b.y}; }
  friend PlaneVector operator*(const Real& factor, const PlaneVector& a) {
    return {factor * a.x, factor * a.y};
  }
};

/// (x, y) of a block's frame as it stands, by the cosine and sine of its angle; or a derivative, by theirs.
template <class Real>
PlaneVector<Real> turned(const PlaneVector<Real>& direction, const Real& x, const Real& y) {
  return {x * direction.x + y * direction.y, y * direction.x - x * direction.y};
}

/// a⊥ · b, with ⊥ the quarter turn that an increasing angle makes.
template <class Real>
Real across(const PlaneVector<Real>& a, const PlaneVector<Real>& b) {
  return a.y * b.x - a.x * b.y;
}

/// The mass matrix of a chain's relative angles.
template <class Real, int N>
struct ChainMass {
  using Point2 = PlaneVector<Real>;
  PerBlock<Point2, N> links, moments;  ///< L and S of the linkage as they stand, m and kg·m
  std::array<PerBlock<Real, N>, capacity(N)> matrix;
  ConstrainedMass<Real, N> constrained;

  /// From the cosine and the sine of each block's angle: the matrix of absolute angles, then sums over all
  /// blocks from either index up, those that turn with a relative angle.
  void factorise(const Linkage<Real, N>& linkage, const PerBlock<Point2, N>& directions) {
    const std::size_t size = linkage.size();
    for (std::size_t j = 0; j < size; ++j) {
      links[j] = turned(directions[j], linkage.link_x[j], linkage.link_y[j]);
      const Point2 moment = moments[j] = turned(directions[j], linkage.moment_x[j], linkage.moment_y[j]);
      matrix[j][j] = linkage.inertia[j];
      for (std::size_t i = 0; i < j; ++i)
        matrix[i][j] = matrix[j][i] = links[i].x * moment.x + links[i].y * moment.y;
    }
    for (std::size_t i = size - 1; i-- > 0;)
      for (std::size_t j = 0; j < size; ++j) matrix[i][j] += matrix[i + 1][j];
    for (std::size_t j = size - 1; j-- > 0;)
      for (std::size_t i = 0; i < size; ++i) matrix[i][j] += matrix[i][j + 1];
    constrained.factorise(size, linkage.free, [&](std::size_t i, std::size_t j) { return matrix[i][j]; });
  }
};

}  // namespace rockstack
