// Lists and systems that keep up to four blocks without heap memory, and larger ones on it.

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

#include "analytic/unilateral/contact/linear_system.hpp"

namespace rockstack {
namespace {

using List = ShortVector<int, 4>;

std::vector<int> entries(const List& list) {
  return {list.begin(), list.end()};
}

List counted_up(int size) {
  List list;
  for (int i = 0; i < size; ++i) list.push_back(i);
  return list;
}

// Four entries lie in the list itself, five do not: each is copied and moved into each.
TEST(ShortVector, KeepsItsEntriesWhereverTheyLie) {
  for (const int from : {0, 3, 4, 5, 20}) {
    for (const int to : {0, 4, 5, 30}) {
      const List source = counted_up(from);
      List copied = counted_up(to), moved = copied, given = source;
      copied = source;
      moved = std::move(given);
      EXPECT_EQ(entries(copied), entries(source)) << from << " into " << to;
      EXPECT_EQ(entries(moved), entries(source)) << from << " into " << to;
      copied.push_back(-1);
      moved.push_back(-1);
      EXPECT_EQ(entries(source).size(), static_cast<std::size_t>(from)) << "entries are shared";
      EXPECT_EQ(entries(moved), entries(copied));
    }
  }
}

// The bound of Gaussian elimination with row pivots, 3 n³ ε ‖A‖ ‖x‖ for a growth of one (N. J. Higham,
// Accuracy and stability of numerical algorithms, 2002, Theorem 9.5); ten times that for what random matrices
// grow. Diagonals of nought need the pivots.
TEST(LinearSystem, LeavesNoMoreThanRoundingOfAnySize) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> any(-1, 1);
  for (const std::size_t size : {1U, 2U, 3U, 9U, 12U, 13U, 40U}) {
    NumberTable<double> matrix(size, size);
    ShortNumbers<double> right_side(size);
    for (std::size_t i = 0; i < size; ++i) {
      right_side[i] = any(generator);
      for (std::size_t j = 0; j < size; ++j) matrix(i, j) = i == j && size > 1 ? 0 : any(generator);
    }
    const ShortNumbers<double> unknowns = LinearSystem<double>(size, matrix).solve(right_side);
    double norm = 0, largest = 0;
    for (std::size_t i = 0; i < size; ++i) {
      double row = 0;
      for (std::size_t j = 0; j < size; ++j) row += std::abs(matrix(i, j));
      norm = std::max(norm, row);
      largest = std::max(largest, std::abs(unknowns[i]));
    }
    const auto n = static_cast<double>(size);
    const double bound = 30 * n * n * n * std::numeric_limits<double>::epsilon() * norm * largest;
    for (std::size_t i = 0; i < size; ++i) {
      double rest = right_side[i];
      for (std::size_t j = 0; j < size; ++j) rest -= matrix(i, j) * unknowns[j];
      EXPECT_LE(std::abs(rest), bound) << size;
    }
  }
}

}  // namespace
}  // namespace rockstack
