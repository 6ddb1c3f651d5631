#pragma once

#include <optional>
#include <utility>

#include "analytic/unilateral/contact/contact_model.hpp"
#include "analytic/unilateral/contact/linear_system.hpp"

namespace rockstack {

/// z ≥ 0 with w = q + Az ≥ 0 and zᵀw = 0.
template <class Real>
struct ComplementarySolution {
  ShortNumbers<Real> z, w;
};

/// The largest size of numbers, 0 of none.
template <class Real>
Real largest(const ShortNumbers<Real>& numbers) {
  Real size = 0;
  for (const Real& number : numbers) size = std::max<Real>(size, abs(number));
  return size;
}

/// w − Az − e z₀ = q, of Lemke's method, with a column for each variable that is not in the basis, those of
/// the basis being unit vectors. Variables are numbered w, z, z₀.
template <class Real>
struct Tableau {
  std::size_t size;
  NumberTable<Real> table;                ///< the right side is its last column
  ShortVector<std::size_t, 20> basis;     ///< the variable of each row
  ShortVector<std::size_t, 20> outside;   ///< the variable of each column
  ShortVector<std::size_t, 40> place_of;  ///< the row or the column of each variable

  Tableau(const NumberTable<Real>& matrix, const ShortNumbers<Real>& vector,
          const ShortNumbers<Real>& covering)
      : size(vector.size()), table(size, size + 2), basis(size), outside(size + 1), place_of(2 * size + 1) {
    for (std::size_t i = 0; i < size; ++i) {
      basis[i] = place_of[i] = i;
      outside[i] = size + i;
      place_of[size + i] = i;
      for (std::size_t j = 0; j < size; ++j) table(i, j) = -matrix(i, j);
      table(i, size) = -covering[i];
      table(i, right_side()) = vector[i];
    }
    outside[size] = artificial();
    place_of[artificial()] = size;
  }

  std::size_t artificial() const { return 2 * size; }
  std::size_t right_side() const { return size + 1; }
  bool is_basic(std::size_t variable) const {
    return place_of[variable] < size && basis[place_of[variable]] == variable;
  }

  /// Takes the variable of a column into the basis in the place of that of a row.
  void exchange(std::size_t row, std::size_t column) {
    Real* own = table.row(row);
    const Real divisor = std::exchange(own[column], Real(1));
    for (std::size_t j = 0; j < size + 2; ++j) own[j] /= divisor;
    for (std::size_t i = 0; i < size; ++i) {
      Real* other = table.row(i);
      if (i == row || other[column] == 0) continue;
      const Real factor = std::exchange(other[column], Real(0));
      for (std::size_t j = 0; j < size + 2; ++j) other[j] -= factor * own[j];
    }
    std::swap(basis[row], outside[column]);
    place_of[basis[row]] = row;
    place_of[outside[column]] = column;
  }

  /// True where row i leaves before row j: the lexicographic order of right side and inverse basis.
  bool leaves_before(std::size_t i, std::size_t j, std::size_t column) const {
    const auto is_less = [&](const Real& first, const Real& second,
                             const Real& least) -> std::optional<bool> {
      if (!(abs(first - second) > tolerance<Real>(1e-13) * (abs(first) + abs(second) + least)))
        return std::nullopt;
      return first < second;
    };
    const Real of_i = table(i, column), of_j = table(j, column);
    if (const auto less = is_less(table(i, right_side()) / of_i, table(j, right_side()) / of_j, Real(1e-3)))
      return *less;
    if (basis[i] == artificial()) return true;
    if (basis[j] == artificial()) return false;
    for (std::size_t slack = 0; slack < size; ++slack) {
      const std::size_t place = place_of[slack];
      const bool basic = is_basic(slack);
      const Real at_i = basic ? Real(place == i) : table(i, place);
      const Real at_j = basic ? Real(place == j) : table(j, place);
      if (const auto less = is_less(at_i / of_i, at_j / of_j, Real(1))) return *less;
    }
    return false;
  }

  ComplementarySolution<Real> solution() const {
    ComplementarySolution<Real> result{ShortNumbers<Real>(size, 0), ShortNumbers<Real>(size, 0)};
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t variable = basis[i];
      if (variable < size)
        result.w[variable] = table(i, right_side());
      else if (variable < 2 * size)
        result.z[variable - size] = table(i, right_side());
    }
    return result;
  }
};

/// Lemke's method from one covering vector, of a problem whose entries are of the size of one. The artificial
/// variable keeps its row. Zero to rounding, it ties with all that may leave, and does: so even where no
/// other row has a pivot, as next to a ray of slips where nothing pushes, along which A is zero.
template <class Real>
std::optional<ComplementarySolution<Real>> lemke(const NumberTable<Real>& matrix,
                                                 const ShortNumbers<Real>& vector,
                                                 const ShortNumbers<Real>& covering) {
  const std::size_t size = vector.size();
  Tableau<Real> tableau(matrix, vector, covering);
  std::size_t row = 0;
  for (std::size_t i = 1; i < size; ++i)
    if (vector[i] / covering[i] < vector[row] / covering[row]) row = i;
  const Real& artificial = tableau.table(row, tableau.right_side());
  std::size_t entering = tableau.artificial();
  for (std::size_t pivots = 0; pivots < 64 * (size + 4); ++pivots) {
    const std::size_t leaving = tableau.basis[row];
    tableau.exchange(row, tableau.place_of[entering]);
    if (leaving == tableau.artificial() || artificial <= tolerance<Real>(1e-13)) return tableau.solution();
    entering = leaving < size ? leaving + size : leaving - size;
    const std::size_t column = tableau.place_of[entering];
    row = size;
    for (std::size_t i = 0; i < size; ++i) {
      if (tableau.table(i, column) <= tolerance<Real>(1e-11)) continue;
      if (row == size || tableau.leaves_before(i, row, column)) row = i;
    }
    if (row == size) return std::nullopt;
  }
  return std::nullopt;
}

/// Factors for unknowns and their conditions that bring the diagonal to one; where it is zero, the row.
template <class Real>
ShortNumbers<Real> balance(const NumberTable<Real>& matrix, std::size_t size) {
  ShortNumbers<Real> factors(size, 1);
  for (std::size_t i = 0; i < size; ++i)
    if (matrix(i, i) > 0) factors[i] = 1 / sqrt(matrix(i, i));
  for (std::size_t i = 0; i < size; ++i) {
    if (matrix(i, i) > 0) continue;
    Real most = 0;
    for (std::size_t j = 0; j < size; ++j) most = std::max<Real>(most, abs(matrix(i, j)) * factors[j]);
    if (most > 0) factors[i] = 1 / most;
  }
  return factors;
}

/// A solution of a linear complementarity problem by Lemke's method with the lexicographic rule, so that it
/// ends; nothing where it ends in a ray. It finds one wherever A is copositive and q is one of impacts:
/// Stewart & Trinkle 1996, Int. J. Numer. Meth. Engng 39, 2673–2691.
template <class Real>
std::optional<ComplementarySolution<Real>> solve_complementarity(const NumberTable<Real>& matrix,
                                                                 const ShortNumbers<Real>& vector) {
  const std::size_t size = vector.size();
  if (std::ranges::all_of(vector, [](const Real& entry) { return entry >= 0; }))
    return ComplementarySolution<Real>{ShortNumbers<Real>(size, 0), vector};
  const ShortNumbers<Real> factors = balance(matrix, size);
  NumberTable<Real> balanced(size, size);
  ShortNumbers<Real> right_side(size);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) balanced(i, j) = factors[i] * matrix(i, j) * factors[j];
    right_side[i] = factors[i] * vector[i];
  }
  const Real scale = largest(right_side);
  for (Real& entry : right_side) entry /= scale;
  // Where rounding leads one path into a ray, another may get through.
  constexpr int paths = 8;
  for (int path = 0; path < paths; ++path) {
    ShortNumbers<Real> covering(size, 1);
    if (path > 0)
      for (std::size_t i = 0; i < size; ++i)
        covering[i] += Real(0.5 * std::sin(double(path) * double(i + 1)));
    auto solution = lemke<Real>(balanced, right_side, covering);
    if (!solution) continue;
    for (std::size_t i = 0; i < size; ++i) {
      solution->z[i] *= scale * factors[i];
      solution->w[i] *= scale / factors[i];
    }
    return solution;
  }
  return std::nullopt;
}

}  // namespace rockstack
