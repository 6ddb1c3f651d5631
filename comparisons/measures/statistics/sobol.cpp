#include "comparisons/measures/statistics/sobol.hpp"

#include <cmath>
#include <limits>

#include "comparisons/measures/statistics/samples.hpp"

namespace rockstack {
namespace {

double row_mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// How far the bounds of a mean of rows reach, from the sum of their squares off it.
double reach(double squares, std::size_t rows) {
  const auto n = static_cast<double>(rows);
  return reach_of_interval(rows - 1) * std::sqrt(squares / (n * (n - 1)));
}

/// Whether a mean of numbers ≥ 0 is known not to be nought.
bool is_known(const std::vector<double>& values) {
  const double middle = row_mean(values);
  double squares = 0;
  for (const double value : values) squares += std::pow(value - middle, 2);
  return middle > reach(squares, values.size());
}

/// The ratio of two means over the same rows, which row j moves by (above_j − ratio below_j)/mean(below).
VarianceShare ratio_of_means(const std::vector<double>& above, const std::vector<double>& below) {
  const double scale = row_mean(below), ratio = row_mean(above) / scale;
  double squares = 0;
  for (std::size_t j = 0; j < above.size(); ++j)
    squares += std::pow((above[j] - ratio * below[j]) / scale, 2);
  const double half = reach(squares, above.size());
  return {ratio, ratio - half, ratio + half};
}

/// The mean of all a and b.
double middle_of(const std::vector<SobolSample>& samples) {
  return row_mean(mapped(samples, [](const SobolSample& row) { return (row.a + row.b) / 2; }));
}

/// The mean square of a and b off the middle, a row each.
std::vector<double> variances_of(const std::vector<SobolSample>& samples, double middle) {
  return mapped(samples, [&](const SobolSample& row) {
    return (std::pow(row.a - middle, 2) + std::pow(row.b - middle, 2)) / 2;
  });
}

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr VarianceShare no_share{no_number, no_number, no_number};

}  // namespace

double deviation(const std::vector<SobolSample>& samples) {
  return std::sqrt(row_mean(variances_of(samples, middle_of(samples))));
}

std::vector<SobolIndices> sobol_indices(const std::vector<SobolSample>& samples, std::size_t inputs) {
  std::vector<SobolIndices> indices(inputs, {no_share, no_share});
  const bool is_constant = std::ranges::all_of(
      samples, [&](const SobolSample& row) { return row.a == row.b && row.a == samples.front().a; });
  if (samples.size() < 2 || is_constant) return indices;
  const double middle = middle_of(samples);
  const std::vector<double> variances = variances_of(samples, middle);
  if (!is_known(variances)) return indices;
  for (std::size_t i = 0; i < inputs; ++i) {
    const auto of_input = [&](const auto& term) {
      return ratio_of_means(
          mapped(samples, [&](const SobolSample& row) { return term(row, row.exchanged[i]); }), variances);
    };
    indices[i].first = of_input(
        [&](const SobolSample& row, double exchanged) { return (row.b - middle) * (exchanged - row.a); });
    indices[i].total =
        of_input([](const SobolSample& row, double exchanged) { return std::pow(row.a - exchanged, 2) / 2; });
  }
  return indices;
}

}  // namespace rockstack
