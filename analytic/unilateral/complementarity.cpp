#include "analytic/unilateral/complementarity.hpp"

#include <cmath>
#include <vector>

namespace rockstack {
namespace {

/// w − Az − e z₀ = q with columns w, z, z₀, q.
struct Tableau {
  Eigen::MatrixXd table;
  std::vector<Eigen::Index> basis;  ///< the column of each row

  Eigen::Index size() const { return table.rows(); }
  Eigen::Index artificial() const { return 2 * size(); }
  Eigen::Index right_side() const { return 2 * size() + 1; }

  void pivot(Eigen::Index row, Eigen::Index column) {
    const double divisor = table(row, column);
    table.row(row) /= divisor;
    for (Eigen::Index i = 0; i < size(); ++i) {
      const double factor = table(i, column);
      if (i != row && factor != 0) table.row(i) -= factor * table.row(row);
    }
    basis[static_cast<std::size_t>(row)] = column;
  }

  /// True where row i leaves before row j: the lexicographic order of right side and inverse basis.
  bool leaves_before(Eigen::Index i, Eigen::Index j, Eigen::Index column) const {
    const double rounding = 1e-13;
    for (Eigen::Index entry = -1; entry < size(); ++entry) {
      const Eigen::Index at = entry < 0 ? right_side() : entry;
      const double first = table(i, at) / table(i, column);
      const double second = table(j, at) / table(j, column);
      if (std::abs(first - second) > rounding * (std::abs(first) + std::abs(second) + (entry < 0 ? 1e-3 : 1)))
        return first < second;
      if (entry < 0 && is_artificial(i)) return true;
      if (entry < 0 && is_artificial(j)) return false;
    }
    return false;
  }
  ComplementarySolution solution() const {
    ComplementarySolution result{Eigen::VectorXd::Zero(size()), Eigen::VectorXd::Zero(size())};
    for (Eigen::Index i = 0; i < size(); ++i) {
      const Eigen::Index column = basis[static_cast<std::size_t>(i)];
      if (column < size())
        result.w[column] = table(i, right_side());
      else if (column < 2 * size())
        result.z[column - size()] = table(i, right_side());
    }
    return result;
  }

  bool is_artificial(Eigen::Index row) const { return basis[static_cast<std::size_t>(row)] == artificial(); }
};

/// Lemke's method from one covering vector, of a problem whose entries are of the size of one.
std::optional<ComplementarySolution> lemke(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& vector,
                                           const Eigen::VectorXd& covering) {
  const Eigen::Index size = vector.size();
  Tableau tableau{Eigen::MatrixXd::Zero(size, 2 * size + 2), {}};
  tableau.table.leftCols(size).setIdentity();
  tableau.table.middleCols(size, size) = -matrix;
  tableau.table.col(2 * size) = -covering;
  tableau.table.col(2 * size + 1) = vector;
  for (Eigen::Index i = 0; i < size; ++i) tableau.basis.push_back(i);

  Eigen::Index row = 0;
  vector.cwiseQuotient(covering).minCoeff(&row);
  Eigen::Index entering = tableau.artificial();
  for (int pivots = 0; pivots < 64 * static_cast<int>(size + 4); ++pivots) {
    const Eigen::Index leaving = tableau.basis[static_cast<std::size_t>(row)];
    tableau.pivot(row, entering);
    if (leaving == tableau.artificial()) return tableau.solution();
    entering = leaving < size ? leaving + size : leaving - size;
    row = -1;
    for (Eigen::Index i = 0; i < size; ++i) {
      if (tableau.table(i, entering) <= 1e-11) continue;
      if (row < 0 || tableau.leaves_before(i, row, entering)) row = i;
    }
    if (row < 0) return std::nullopt;
  }
  return std::nullopt;
}

/// Factors for unknowns and their conditions that bring the diagonal to one; where it is zero, the row.
Eigen::VectorXd balance(const Eigen::MatrixXd& matrix) {
  Eigen::VectorXd factors = Eigen::VectorXd::Ones(matrix.rows());
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    if (matrix(i, i) > 0) factors[i] = 1 / std::sqrt(matrix(i, i));
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    if (matrix(i, i) > 0) continue;
    const double size = matrix.row(i).cwiseAbs().cwiseProduct(factors.transpose()).maxCoeff();
    if (size > 0) factors[i] = 1 / size;
  }
  return factors;
}

}  // namespace

std::optional<ComplementarySolution> solve_complementarity(const Eigen::MatrixXd& matrix,
                                                           const Eigen::VectorXd& vector) {
  const Eigen::Index size = vector.size();
  if (size == 0 || vector.minCoeff() >= 0) return ComplementarySolution{Eigen::VectorXd::Zero(size), vector};
  const Eigen::VectorXd factors = balance(matrix);
  const Eigen::MatrixXd balanced = factors.asDiagonal() * matrix * factors.asDiagonal();
  const Eigen::VectorXd right_side = factors.cwiseProduct(vector);
  const double scale = right_side.lpNorm<Eigen::Infinity>();
  // Where rounding leads one path into a ray, another may get through.
  constexpr int paths = 8;
  for (int path = 0; path < paths; ++path) {
    Eigen::VectorXd covering = Eigen::VectorXd::Ones(size);
    for (Eigen::Index i = 0; i < size; ++i) covering[i] += 0.5 * std::sin(double(path) * double(i + 1));
    auto solution = lemke(balanced, right_side / scale, covering);
    if (!solution) continue;
    solution->z = scale * factors.cwiseProduct(solution->z);
    solution->w = scale * solution->w.cwiseQuotient(factors);
    return solution;
  }
  return std::nullopt;
}

}  // namespace rockstack
