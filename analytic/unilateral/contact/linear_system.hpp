#pragma once

#include <cmath>

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

/// As many linear equations as unknowns, few, by Gauss's elimination with the largest pivot of each column.
template <class Real>
class LinearSystem {
 public:
  LinearSystem() = default;
  /// `entry(i, j)` tells what equation i takes of unknown j.
  template <class Entry>
  LinearSystem(std::size_t size, const Entry& entry) : size_(size), table_(size, size), order_(size) {
    using std::abs;
    for (std::size_t i = 0; i < size; ++i) {
      order_[i] = i;
      for (std::size_t j = 0; j < size; ++j) table_(i, j) = entry(i, j);
    }
    for (std::size_t column = 0; column + 1 < size; ++column) {
      std::size_t pivot = column;
      for (std::size_t i = column + 1; i < size; ++i)
        if (abs(table_(i, column)) > abs(table_(pivot, column))) pivot = i;
      Real* upper = table_.row(column);
      if (pivot != column) {
        std::swap(order_[column], order_[pivot]);
        std::swap_ranges(upper, upper + size, table_.row(pivot));
      }
      for (std::size_t i = column + 1; i < size; ++i) {
        Real* row = table_.row(i);
        const Real factor = row[column] /= upper[column];
        for (std::size_t j = column + 1; j < size; ++j) row[j] -= factor * upper[j];
      }
    }
  }

  std::size_t size() const { return size_; }

  /// The unknowns of a right side.
  ShortNumbers<Real> solve(const ShortNumbers<Real>& right_side) const {
    ShortNumbers<Real> unknowns(size_);
    const Real* row = table_.row(0);
    if (size_ == 2) {  // as below, without loops that are longer than what they do
      const Real upper = right_side[order_[0]];
      unknowns[1] = (right_side[order_[1]] - row[2] * upper) / row[3];
      unknowns[0] = (upper - row[1] * unknowns[1]) / row[0];
      return unknowns;
    }
    for (std::size_t i = 0; i < size_; ++i, row += size_) {
      Real rest = right_side[order_[i]];
      for (std::size_t j = 0; j < i; ++j) rest -= row[j] * unknowns[j];
      unknowns[i] = rest;
    }
    for (std::size_t i = size_; i-- > 0;) {
      row -= size_;
      Real rest = unknowns[i];
      for (std::size_t j = i + 1; j < size_; ++j) rest -= row[j] * unknowns[j];
      unknowns[i] = rest / row[i];
    }
    return unknowns;
  }

 private:
  std::size_t size_ = 0;
  NumberTable<Real> table_;
  ShortVector<std::size_t, 12> order_;  ///< of conditions, as pivots take them
};

}  // namespace rockstack
