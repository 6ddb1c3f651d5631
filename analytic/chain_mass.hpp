#pragma once

#include "analytic/linkage.hpp"

namespace rockstack {

template <class Real>
struct PlaneVector {
  Real x, y;
};

/// The mass matrix of a chain's relative angles, and its factors L D Lᵀ with closed interfaces held.
template <class Real, int N>
struct ChainMass {
  using Point2 = PlaneVector<Real>;
  PerBlock<Point2, N> links, moments;  ///< L and S of the linkage as they stand, m and kg·m
  std::array<PerBlock<Real, N>, capacity(N)> matrix, factors;
  PerBlock<Real, N> inverse;  ///< of D

  /// From the cosine and the sine of each block's angle.
  void factorise(const Linkage<Real, N>& linkage, const PerBlock<Point2, N>& directions) {
    fill(linkage, directions);
    for (std::size_t i = 0; i < linkage.size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        Real sum = matrix[i][j] * linkage.free[i] * linkage.free[j];
        if (i == j) sum += Real(1) - linkage.free[i];
        for (std::size_t m = 0; m < j; ++m) sum -= factors[i][m] * factors[m][m] * factors[j][m];
        factors[i][j] = i == j ? sum : sum * inverse[j];
      }
      inverse[i] = Real(1) / factors[i][i];
    }
  }

  /// −M⁻¹ of the moments of open interfaces.
  PerBlock<Real, N> solve(const Linkage<Real, N>& linkage, const PerBlock<Real, N>& opposed) const {
    PerBlock<Real, N> x;
    for (std::size_t i = 0; i < linkage.size(); ++i) {
      x[i] = -opposed[i] * linkage.free[i];
      for (std::size_t m = 0; m < i; ++m) x[i] -= factors[i][m] * x[m];
    }
    for (std::size_t i = linkage.size(); i-- > 0;) {
      x[i] *= inverse[i];
      for (std::size_t m = i + 1; m < linkage.size(); ++m) x[i] -= factors[m][i] * x[m];
    }
    return x;
  }

 private:
  static Point2 turned(const Point2& direction, const Real& x, const Real& y) {
    return {x * direction.x + y * direction.y, y * direction.x - x * direction.y};
  }

  /// The matrix of absolute angles, then sums over all blocks from either index up: those that turn with a
  /// relative angle.
  void fill(const Linkage<Real, N>& linkage, const PerBlock<Point2, N>& directions) {
    const std::size_t size = linkage.size();
    for (std::size_t j = 0; j < size; ++j) {
      links[j] = turned(directions[j], linkage.link_x[j], linkage.link_y[j]);
      const Point2 moment = moments[j] = turned(directions[j], linkage.moment_x[j], linkage.moment_y[j]);
      matrix[j][j] = linkage.inertia[j];
      for (std::size_t i = 0; i < j; ++i)
        matrix[i][j] = matrix[j][i] = links[i].x * moment.x + links[i].y * moment.y;
    }
    for (std::size_t i = size - 1; i-- > 0;) {
      for (std::size_t j = 0; j < size; ++j) matrix[i][j] += matrix[i + 1][j];
    }
    for (std::size_t j = size - 1; j-- > 0;) {
      for (std::size_t i = 0; i < size; ++i) matrix[i][j] += matrix[i][j + 1];
    }
  }
};

}  // namespace rockstack
