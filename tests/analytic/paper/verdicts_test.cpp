#include "tests/analytic/paper/verdicts.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/analytic/paper/checks.hpp"

namespace rockstack::paper {
namespace {

constexpr int draws = 2000;

// Errors are relative to a bound on the equation's terms. Fewer than 200 roundings of at most 2⁻⁵³ of that
// bound each make 2.2e-14; five times that is allowed.
constexpr double round_off = 1e-13;

// What is off by this much is not round-off.
constexpr double disagreement = 1e-9;

struct Found {
  double worst = 0;     ///< largest error
  int disagreeing = 0;  ///< draws with an error beyond round-off
};

Found examine(int equation, Reading reading) {
  std::mt19937_64 random(static_cast<unsigned>(equation));
  const Check& check = checks().at(equation);
  Found found;
  for (int i = 0; i < draws; ++i) {
    const double error = check(draw(random), reading);
    found.worst = std::max(found.worst, error);
    found.disagreeing += error > disagreement ? 1 : 0;
  }
  return found;
}

class Equation : public testing::TestWithParam<int> {};

TEST_P(Equation, IsWhatItsVerdictSays) {
  const int number = GetParam();
  const Verdict verdict = verdict_of(number);
  if (verdict == Verdict::definition) {
    EXPECT_EQ(checks().count(number), 0U);
    return;
  }
  ASSERT_EQ(checks().count(number), 1U);
  EXPECT_LT(examine(number, Reading::corrected).worst, round_off);
  const Found printed = examine(number, Reading::printed);
  if (verdict == Verdict::agrees) {
    EXPECT_LT(printed.worst, round_off);
  } else {
    // A wrong term can vanish by chance, hardly twenty times in two thousand.
    EXPECT_GT(printed.disagreeing, draws - 20);
  }
}

INSTANTIATE_TEST_SUITE_P(Spanos2001, Equation, testing::Range(1, equation_count + 1),
                         [](const auto& equation) { return std::to_string(equation.param); });

TEST(Verdicts, CoverEveryEquationOnceInOrder) {
  int next = 1;
  for (const VerdictRow& row : verdicts()) {
    EXPECT_EQ(row.first, next);
    EXPECT_LE(row.first, row.last);
    next = row.last + 1;
  }
  EXPECT_EQ(next, equation_count + 1);
}

}  // namespace
}  // namespace rockstack::paper
