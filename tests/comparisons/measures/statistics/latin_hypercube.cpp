#include "comparisons/measures/statistics/latin_hypercube.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace rockstack {
namespace {

// Φ(x) = erfc(−x/√2)/2 is the C library's, and the quantile Boost's: x moves by φ(x)⁻¹ times the rounding of
// Φ, 1e-12 of it out to share 1e-4. 1.959963984540054 and 1.2815515655446004 stand in tables of the normal
// distribution.
TEST(LatinHypercube, QuantilesInvertTheDistributions) {
  const Distribution uniform{Distribution::Kind::uniform, 2, 5}, normal{Distribution::Kind::normal, -1, 0.5},
      lognormal{Distribution::Kind::lognormal, 4, 0.3};
  const auto share_below = [](double x) { return std::erfc(-x / std::sqrt(2.0)) / 2; };
  for (int i = 1; i < 10000; i += 7) {
    const double share = i / 10000.0;
    EXPECT_NEAR(quantile(uniform, share), 2 + 3 * share, 1e-15 * 5);
    EXPECT_NEAR(share_below((quantile(normal, share) + 1) / 0.5), share, 1e-12 * share);
    EXPECT_NEAR(share_below(std::log(quantile(lognormal, share) / 4) / 0.3), share, 1e-12 * share);
  }
  EXPECT_NEAR(quantile({Distribution::Kind::normal, 0, 1}, 0.975), 1.959963984540054, 1e-12);
  EXPECT_NEAR(quantile({Distribution::Kind::normal, 0, 1}, 0.1), -1.2815515655446004, 1e-12);
  for (const Distribution& each : {uniform, normal, lognormal})
    EXPECT_NEAR(quantile(each, 0.5), median(each), 1e-15 * 4);
}

TEST(LatinHypercube, AShuffledOrderHasEachPlaceOnce) {
  for (const std::uint64_t count : {1U, 2U, 3U, 7U, 64U, 1000U, 4097U}) {
    std::set<std::uint64_t> places;
    for (std::uint64_t number = 0; number < count; ++number) places.insert(shuffled(number, count, 5, 17, 2));
    EXPECT_EQ(places.size(), count);
    EXPECT_EQ(*places.rbegin(), count - 1);
  }
}

// The 24 orders of four numbers should come equally often: the sum of squares over what is
// expected is χ² with 23 degrees of freedom, below 63.2 but once in 100,000 times.
TEST(LatinHypercube, AllOrdersAreEquallyLikely) {
  constexpr int orders = 24000;
  std::map<std::vector<std::uint64_t>, int> counts;
  for (int order = 0; order < orders; ++order) {
    std::vector<std::uint64_t> places;
    for (std::uint64_t number = 0; number < 4; ++number)
      places.push_back(shuffled(number, 4, static_cast<std::uint64_t>(order), 3, 1));
    ++counts[places];
  }
  ASSERT_EQ(counts.size(), 24u);
  double squares = 0;
  for (const auto& [places, count] : counts) squares += std::pow(count - orders / 24.0, 2) / (orders / 24.0);
  EXPECT_LT(squares, 63.2);
}

// In every part of the distribution that has one chance in n lies one draw of n: by the closed form of its
// share.
TEST(LatinHypercube, ALatinHypercubeHasOneDrawInEachPart) {
  for (const std::uint64_t samples : {1U, 5U, 1000U}) {
    for (const std::uint64_t point : {0U, 3U}) {
      std::set<double> parts, normal_parts;
      for (std::uint64_t run = point * samples; run < (point + 1) * samples; ++run) {
        const auto n = static_cast<double>(samples);
        const DrawIndex index{9, run, 2};
        parts.insert(std::floor(latin_draw({Distribution::Kind::uniform, 0, n}, index, samples)));
        const double x = latin_draw({Distribution::Kind::normal, 0, 1}, index, samples);
        normal_parts.insert(std::floor(n * std::erfc(-x / std::sqrt(2.0)) / 2));
      }
      EXPECT_EQ(parts.size(), samples);
      EXPECT_EQ(normal_parts, parts);
      EXPECT_EQ(*parts.begin(), 0);
      EXPECT_EQ(*parts.rbegin(), static_cast<double>(samples - 1));
    }
  }
}

// Stein 1987 (Technometrics 29, 143–151): of an additive function the mean over a Latin hypercube scatters by
// n^(−3/2), that over random draws by n^(−1/2). Here of x + y over n = 100: √(2/12)/1000 and √(2/12)/10.
TEST(LatinHypercube, ALatinHypercubeHasTheMeanOfASumNearlyExactly) {
  constexpr std::uint64_t samples = 100, cubes = 200;
  const Distribution uniform{Distribution::Kind::uniform, 0, 1};
  double squares = 0, product = 0;
  for (std::uint64_t cube = 0; cube < cubes; ++cube) {
    double mean = 0;
    for (std::uint64_t run = cube * samples; run < (cube + 1) * samples; ++run) {
      const double x = latin_draw(uniform, {1, run, 0}, samples),
                   y = latin_draw(uniform, {1, run, 1}, samples);
      mean += (x + y) / samples;
      product += (x - 0.5) * (y - 0.5);
    }
    squares += std::pow(mean - 1, 2) / cubes;
  }
  // A mean square of 200 scatters by √(2/200) = 10 %, a correlation of 20,000 pairs by 1/√20000: five of
  // each.
  EXPECT_NEAR(std::sqrt(squares), std::sqrt(2 / 12.0) / 1000, 0.25 * std::sqrt(2 / 12.0) / 1000);
  EXPECT_NEAR(12 * product / (cubes * samples), 0, 5 / std::sqrt(static_cast<double>(cubes * samples)));
}

}  // namespace
}  // namespace rockstack
