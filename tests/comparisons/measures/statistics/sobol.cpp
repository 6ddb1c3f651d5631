#include "comparisons/measures/statistics/sobol.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "comparisons/measures/statistics/latin_hypercube.hpp"

namespace rockstack {
namespace {

using Model = std::function<double(const std::vector<double>&)>;

/// How values are drawn: at random, or as a Latin hypercube of so many rows.
enum class Drawn { random, latin };

/// Saltelli's design over inputs of one distribution.
std::vector<SobolSample> design(const Model& model, const Distribution& distribution, std::uint32_t inputs,
                                std::uint64_t rows, std::uint64_t seed, Drawn drawn = Drawn::random) {
  std::vector<SobolSample> samples;
  for (std::uint64_t row = 0; row < rows; ++row) {
    const auto values = [&](std::uint32_t first) {
      std::vector<double> list;
      for (std::uint32_t i = 0; i < inputs; ++i) {
        const DrawIndex index{seed, row, first + i};
        list.push_back(drawn == Drawn::latin ? latin_draw(distribution, index, rows)
                                             : draw(distribution, index));
      }
      return list;
    };
    const std::vector<double> a = values(0), b = values(inputs);
    SobolSample sample{model(a), model(b), {}};
    for (std::uint32_t i = 0; i < inputs; ++i) {
      std::vector<double> exchanged = a;
      exchanged[i] = b[i];
      sample.exchanged.push_back(model(exchanged));
    }
    samples.push_back(sample);
  }
  return samples;
}

void expect_near_truth(const VarianceShare& share, double truth) {
  const double deviation = (share.upper - share.lower) / (2 * 1.96);
  EXPECT_NEAR(share.value, truth, 4.5 * deviation) << "four and a half deviations: once in 150,000";
  EXPECT_LT(deviation, 0.02) << "a test that can fail";
}

// T. Ishigami & T. Homma 1990: sin x + 7 sin² y + 0.1 z⁴ sin x over (−π, π)³. With a = 7 and b = 0.1 the
// variances are (1 + bπ⁴/5)²/2 of x, a²/8 of y, none of z, and 8b²π⁸/225 of x with z.
TEST(Sobol, GivesTheIndicesOfIshigamisFunction) {
  constexpr double a = 7, b = 0.1, pi = std::numbers::pi;
  const double of_x = std::pow(1 + b * std::pow(pi, 4) / 5, 2) / 2, of_y = a * a / 8,
               together = 8 * b * b * std::pow(pi, 8) / 225, all = of_x + of_y + together;
  const Model ishigami = [&](const std::vector<double>& x) {
    return std::sin(x[0]) * (1 + b * std::pow(x[2], 4)) + a * std::pow(std::sin(x[1]), 2);
  };
  for (const Drawn drawn : {Drawn::random, Drawn::latin}) {
    const auto indices =
        sobol_indices(design(ishigami, {Distribution::Kind::uniform, -pi, pi}, 3, 20000, 5, drawn), 3);
    ASSERT_EQ(indices.size(), 3u);
    expect_near_truth(indices[0].first, of_x / all);
    expect_near_truth(indices[1].first, of_y / all);
    expect_near_truth(indices[2].first, 0);
    expect_near_truth(indices[0].total, (of_x + together) / all);
    expect_near_truth(indices[1].total, of_y / all);
    expect_near_truth(indices[2].total, together / all);
  }
}

// A sum Σ cᵢ xᵢ with independent inputs of one variance has the indices cᵢ²/Σ c², either. An interval of 95 %
// misses in 5 % of all cases: of 400, 20 ± 4.4.
TEST(Sobol, BoundsHoldTheIndicesOfALinearModelAsOftenAsTheySay) {
  const std::vector<double> weights{3, 2, 1, 0};
  const Model linear = [&](const std::vector<double>& x) {
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += weights[i] * x[i];
    return sum;
  };
  constexpr int cases = 400;
  std::vector<int> first_missed(4), total_missed(4);
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    const auto indices = sobol_indices(design(linear, {Distribution::Kind::normal, 1, 2}, 4, 300, seed), 4);
    for (std::size_t i = 0; i < 4; ++i) {
      const double truth = weights[i] * weights[i] / 14;
      const auto misses = [&](const VarianceShare& share) {
        return truth < share.lower || truth > share.upper ? 1 : 0;
      };
      first_missed[i] += misses(indices[i].first);
      total_missed[i] += misses(indices[i].total);
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {  // four deviations, and one for 300 rows being few
    EXPECT_NEAR(first_missed[i], 20, 22) << i;
    EXPECT_NEAR(total_missed[i], 20, 22) << i;
    EXPECT_GE(first_missed[i], 4) << i << ": bounds are wider than need be";
    EXPECT_GE(total_missed[i], 4) << i << ": bounds are wider than need be";
  }
  EXPECT_EQ(first_missed[3] + total_missed[3], 0) << "what has no influence is known to have none";
}

// As f(b) and f(a) swap their parts where one input alone matters, that one's total is half the mean of (f(a)
// − f(b))².
TEST(Sobol, AnInputWithoutInfluenceHasIndicesOfNoughtExactly) {
  const Model one = [](const std::vector<double>& x) { return x[1] > 0.3 ? 1.0 : 0.0; };
  const auto indices = sobol_indices(design(one, {Distribution::Kind::uniform, 0, 1}, 3, 2000, 8), 3);
  for (const std::size_t i : {0U, 2U}) {
    EXPECT_EQ(indices[i].first.value, 0);
    EXPECT_EQ(indices[i].total.upper, 0);
  }
  for (const VarianceShare& share : {indices[1].first, indices[1].total}) {
    EXPECT_LT(share.lower, 1);
    EXPECT_GT(share.upper, 1);
    EXPECT_NEAR(share.value, 1, 0.1);
  }
}

TEST(Sobol, OfAConstantOrASingleRowThereAreNoIndices) {
  for (const std::vector<SobolSample>& samples :
       {std::vector<SobolSample>(5, {2, 2, {2}}), std::vector<SobolSample>(1, {1, 2, {1}})}) {
    const auto indices = sobol_indices(samples, 1);
    ASSERT_EQ(indices.size(), 1u);
    EXPECT_TRUE(std::isnan(indices[0].first.value) && std::isnan(indices[0].total.upper));
  }
}

// One event in n rows has a relative standard error of one, five of 0.45: with these the variance is known.
TEST(Sobol, OfAHandfulOfEventsThereAreNoIndices) {
  for (const int events : {1, 3, 5, 8}) {
    std::vector<SobolSample> samples(500, {0, 0, {0}});
    for (int i = 0; i < events; ++i) samples[40 * static_cast<std::size_t>(i)] = {1, 0, {0}};
    EXPECT_EQ(std::isnan(sobol_indices(samples, 1)[0].total.value), events < 5) << events;
  }
}

// Shifted and scaled outcomes have the same indices: of whole numbers times a power of two, to rounding of
// the middle.
TEST(Sobol, AreTheSameInOtherUnits) {
  auto samples = design([](const std::vector<double>& x) { return x[0] * x[1] + x[1]; },
                        {Distribution::Kind::normal, 0, 1}, 2, 200, 1);
  const auto indices = sobol_indices(samples, 2);
  for (SobolSample& row : samples) {
    for (double* value : {&row.a, &row.b, &row.exchanged[0], &row.exchanged[1]}) *value = 8 * *value + 1000;
  }
  const auto scaled = sobol_indices(samples, 2);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(scaled[i].first.value, indices[i].first.value, 1e-11);
    EXPECT_NEAR(scaled[i].total.lower, indices[i].total.lower, 1e-11);
  }
}

}  // namespace
}  // namespace rockstack
