#pragma once

#include "analytic/mechanics/linkage.hpp"

namespace rockstack {

template <class Real>
struct PlaneVector {
  Real x, y;

  friend PlaneVector operator+(const PlaneVector& a, const PlaneVector& b) { return {a.x + b.x, a.y + b.y}; }
  friend PlaneVector operator*(const Real& factor, const PlaneVector& a) {
    return {factor * a.x, factor * a.y};
  }
};

/// (x, y) of a block's frame as it stands, from the cosine and the sine of its angle; or a derivative of it,
/// from theirs.
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

  /// From the cosine and the sine of each block's angle.
  void factorise(const Linkage<Real, N>& linkage, const PerBlock<Point2, N>& directions) {
    fill(linkage, directions);
    constrained.factorise(linkage.size(), linkage.free,
                          [&](std::size_t i, std::size_t j) { return matrix[i][j]; });
  }

 private:
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
