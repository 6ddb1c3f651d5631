#include "comparisons/measures/statistics/kolmogorov_smirnov.hpp"

#include <algorithm>
#include <cmath>

namespace rockstack {
namespace {

/// The chance that the limit of √n D exceeds a number: 2 Σ (−1)^(j−1) exp(−2 j² x²).
double limiting_chance(double x) {
  if (x < 0.2) return 1;  // the sum's terms fall too slowly there, and the chance is 1 to 12 digits
  double sum = 0;
  for (int j = 1; j <= 100; ++j) {
    const double term = std::exp(-2.0 * j * j * x * x);
    sum += j % 2 == 1 ? term : -term;
    if (term < 1e-17) break;
  }
  return std::clamp(2 * sum, 0.0, 1.0);
}

double largest_difference(const std::vector<double>& first, const std::vector<double>& second) {
  double distance = 0;
  std::size_t i = 0, j = 0;
  while (i < first.size() && j < second.size()) {
    const double value = std::min(first[i], second[j]);
    while (i < first.size() && first[i] <= value) ++i;
    while (j < second.size() && second[j] <= value) ++j;
    const double apart = static_cast<double>(i) / static_cast<double>(first.size()) -
                         static_cast<double>(j) / static_cast<double>(second.size());
    distance = std::max(distance, std::abs(apart));
  }
  return distance;
}

}  // namespace

KolmogorovSmirnov kolmogorov_smirnov(std::vector<double> first, std::vector<double> second) {
  std::sort(first.begin(), first.end());
  std::sort(second.begin(), second.end());
  const auto one = static_cast<double>(first.size()), other = static_cast<double>(second.size());
  const double root = std::sqrt(one * other / (one + other));
  const double factor = root + 0.12 + 0.11 / root;
  constexpr double five_percent = 1.3581;  // where limiting_chance() is 0.05
  const double distance = largest_difference(first, second);
  return {distance, limiting_chance(factor * distance), five_percent / factor};
}

}  // namespace rockstack
