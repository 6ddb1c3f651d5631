#pragma once

#include <cmath>
#include <type_traits>

#include "analytic/unilateral/contact/short_vector.hpp"

namespace rockstack {

/// A table of numbers, row by row.
template <class Real>
class NumberTable {
 public:
  NumberTable() = default;
  NumberTable(std::size_t rows, std::size_t columns) : columns_(columns), entries_(rows * columns) {}

  Real& operator()(std::size_t i, std::size_t j) { return entries_[i * columns_ + j]; }
  const Real& operator()(std::size_t i, std::size_t j) const { return entries_[i * columns_ + j]; }
  Real* row(std::size_t i) { return entries_.begin() + i * columns_; }
  const Real* row(std::size_t i) const { return entries_.begin() + i * columns_; }

 private:
  std::size_t columns_ = 0;
  ShortVector<Real, 144> entries_;
};

/// Numbers of as many conditions as four blocks have.
template <class Real>
using ShortNumbers = ShortVector<Real, 20>;

/// Calls f with a size that the compiler knows, where it is small: it writes short loops out.
template <class F>
void with_known(std::size_t size, const F& f) {
  if (size == 1) return f(std::integral_constant<std::size_t, 1>());
  if (size == 2) return f(std::integral_constant<std::size_t, 2>());
  if (size == 3) return f(std::integral_constant<std::size_t, 3>());
  if (size == 4) return f(std::integral_constant<std::size_t, 4>());
  f(size);
}

/// As many linear equations as unknowns, few, by Gauss's elimination with the largest pivot of each column.
template <class Real>
class LinearSystem {
 public:
  LinearSystem() = default;
  /// `entry(i, j)` tells what equation i takes of unknown j.
  template <class Entry>
  LinearSystem(std::size_t size, const Entry& entry) : size_(size), table_(size, size), order_(size) {
    for (std::size_t i = 0; i < size; ++i) {
      order_[i] = i;
      for (std::size_t j = 0; j < size; ++j) table_(i, j) = entry(i, j);
    }
    with_known(size, [&](auto known) { eliminate(known); });
  }

  /// The unknowns of a right side.
  ShortNumbers<Real> solve(const ShortNumbers<Real>& right_side) const {
    ShortNumbers<Real> unknowns(size_);
    solve(right_side.begin(), unknowns.begin());
    return unknowns;
  }
  void solve(const Real* right_side, Real* unknowns) const {
    with_known(size_, [&](auto known) { substitute(known, right_side, unknowns); });
  }

 private:
  template <class Size>
  void eliminate(Size size) {
    using std::abs;
    Real* const rows = table_.row(0);
    for (std::size_t column = 0; column + 1 < size; ++column) {
      Real* upper = rows + column * size;
      std::size_t pivot = column;
      for (std::size_t i = column + 1; i < size; ++i)
        if (abs(rows[i * size + column]) > abs(rows[pivot * size + column])) pivot = i;
      if (pivot != column) {
        std::swap(order_[column], order_[pivot]);
        std::swap_ranges(upper, upper + size, rows + pivot * size);
      }
      for (std::size_t i = column + 1; i < size; ++i) {
        Real* row = rows + i * size;
        const Real factor = row[column] /= upper[column];
        if constexpr (std::is_same_v<Size, std::size_t>)
          if (factor == 0) continue;  // chains leave most of a large system empty
        for (std::size_t j = column + 1; j < size; ++j) row[j] -= factor * upper[j];
      }
    }
  }

  template <class Size>
  void substitute(Size size, const Real* right_side, Real* unknowns) const {
    const Real* row = table_.row(0);
    for (std::size_t i = 0; i < size; ++i, row += size) {
      Real rest = right_side[order_[i]];
      for (std::size_t j = 0; j < i; ++j) rest -= row[j] * unknowns[j];
      unknowns[i] = rest;
    }
    for (std::size_t i = size; i-- > 0;) {
      row -= size;
      Real rest = unknowns[i];
      for (std::size_t j = i + 1; j < size; ++j) rest -= row[j] * unknowns[j];
      unknowns[i] = rest / row[i];
    }
  }

  std::size_t size_ = 0;
  NumberTable<Real> table_;
  ShortVector<std::size_t, 12> order_;  ///< of conditions, as pivots take them
};

}  // namespace rockstack
