#pragma once

#include "analytic/unilateral/contact/contact_model.hpp"
#include "analytic/unilateral/contact/contact_problem.hpp"

namespace rockstack {

/// z ≥ 0 with w = q + Az ≥ 0 and zᵀw = 0.
template <class Real>
struct ComplementarySolution {
  FreeVector<Real> z, w;
};

/// w − Az − e z₀ = q with columns w, z, z₀, q: Lemke's.
template <class Real>
struct Tableau {
  SquareMatrix<Real> table;
  std::vector<Eigen::Index> basis;  ///< the column of each row

  Eigen::Index size() const { return table.rows(); }
  Eigen::Index artificial() const { return 2 * size(); }
  Eigen::Index right_side() const { return 2 * size() + 1; }

  void pivot(Eigen::Index row, Eigen::Index column) {
    const Real divisor = table(row, column);
    table.row(row) /= divisor;
    for (Eigen::Index i = 0; i < size(); ++i) {
      const Real factor = table(i, column);
      if (i != row && factor != 0) table.row(i) -= factor * table.row(row);
    }
    basis[row] = column;
  }

  /// True where row i leaves before row j: the lexicographic order of right side and inverse basis.
  bool leaves_before(Eigen::Index i, Eigen::Index j, Eigen::Index column) const {
    using std::abs;
    const Real rounding = tolerance<Real>(1e-13);
    for (Eigen::Index entry = -1; entry < size(); ++entry) {
      const Eigen::Index at = entry < 0 ? right_side() : entry;
      const Real first = table(i, at) / table(i, column);
      const Real second = table(j, at) / table(j, column);
      if (abs(first - second) > rounding * (abs(first) + abs(second) + Real(entry < 0 ? 1e-3 : 1)))
        return first < second;
      if (entry < 0 && is_artificial(i)) return true;
      if (entry < 0 && is_artificial(j)) return false;
    }
    return false;
  }
  ComplementarySolution<Real> solution() const {
    ComplementarySolution<Real> result{FreeVector<Real>::Zero(size()), FreeVector<Real>::Zero(size())};
    for (Eigen::Index i = 0; i < size(); ++i) {
      const Eigen::Index column = basis[i];
      if (column < size())
        result.w[column] = table(i, right_side());
      else if (column < 2 * size())
        result.z[column - size()] = table(i, right_side());
    }
    return result;
  }

  bool is_artificial(Eigen::Index row) const { return basis[row] == artificial(); }
};

/// Lemke's method from one covering vector, of a problem whose entries are of the size of one.
template <class Real>
std::optional<ComplementarySolution<Real>> lemke(const SquareMatrix<Real>& matrix,
                                                 const FreeVector<Real>& vector,
                                                 const FreeVector<Real>& covering) {
  const Eigen::Index size = vector.size();
  Tableau<Real> tableau{SquareMatrix<Real>::Zero(size, 2 * size + 2), {}};
  tableau.table.leftCols(size).setIdentity();
  tableau.table.middleCols(size, size) = -matrix;
  tableau.table.col(2 * size) = -covering;
  tableau.table.col(2 * size + 1) = vector;
  for (Eigen::Index i = 0; i < size; ++i) tableau.basis.push_back(i);

  Eigen::Index row = 0;
  vector.cwiseQuotient(covering).minCoeff(&row);
  Eigen::Index entering = tableau.artificial();
  for (int pivots = 0; pivots < 64 * static_cast<int>(size + 4); ++pivots) {
    const Eigen::Index leaving = tableau.basis[row];
    tableau.pivot(row, entering);
    if (leaving == tableau.artificial()) return tableau.solution();
    entering = leaving < size ? leaving + size : leaving - size;
    row = -1;
    for (Eigen::Index i = 0; i < size; ++i) {
      if (tableau.table(i, entering) <= tolerance<Real>(1e-11)) continue;
      if (row < 0 || tableau.leaves_before(i, row, entering)) row = i;
    }
    if (row < 0) return std::nullopt;
  }
  return std::nullopt;
}

/// Factors for unknowns and their conditions that bring the diagonal to one; where it is zero, the row.
template <class Real>
FreeVector<Real> balance(const SquareMatrix<Real>& matrix) {
  using std::sqrt;
  FreeVector<Real> factors = FreeVector<Real>::Ones(matrix.rows());
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    if (matrix(i, i) > 0) factors[i] = 1 / sqrt(matrix(i, i));
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    if (matrix(i, i) > 0) continue;
    const Real size = matrix.row(i).cwiseAbs().cwiseProduct(factors.transpose()).maxCoeff();
    if (size > 0) factors[i] = 1 / size;
  }
  return factors;
}

/// A solution of a linear complementarity problem by Lemke's method with the lexicographic rule, so that it
/// ends; nothing where it ends in a ray. It finds one wherever A is copositive and q is one of impacts:
/// Stewart & Trinkle 1996, Int. J. Numer. Meth. Engng 39, 2673–2691.
template <class Real>
std::optional<ComplementarySolution<Real>> solve_complementarity(const SquareMatrix<Real>& matrix,
                                                                 const FreeVector<Real>& vector) {
  const Eigen::Index size = vector.size();
  if (size == 0 || vector.minCoeff() >= 0)
    return ComplementarySolution<Real>{FreeVector<Real>::Zero(size), vector};
  const FreeVector<Real> factors = balance(matrix);
  const SquareMatrix<Real> balanced = factors.asDiagonal() * matrix * factors.asDiagonal();
  const FreeVector<Real> right_side = factors.cwiseProduct(vector);
  const Real scale = right_side.template lpNorm<Eigen::Infinity>();
  // Where rounding leads one path into a ray, another may get through.
  constexpr int paths = 8;
  for (int path = 0; path < paths; ++path) {
    FreeVector<Real> covering = FreeVector<Real>::Ones(size);
    for (Eigen::Index i = 0; i < size; ++i) covering[i] += Real(0.5 * std::sin(double(path) * double(i + 1)));
    auto solution = lemke<Real>(balanced, right_side / scale, covering);
    if (!solution) continue;
    solution->z = scale * factors.cwiseProduct(solution->z);
    solution->w = scale * solution->w.cwiseQuotient(factors);
    return solution;
  }
  return std::nullopt;
}

}  // namespace rockstack
