#include "comparisons/measures/statistics/joint_test.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/measures/statistics/samples.hpp"

namespace rockstack {
namespace {

constexpr double least_scale = 1e-12;  ///< below it values are rounding

/// Half a hundredth: what a change of the median by a hundredth makes of ln(1 + |v|/s). Values that are
/// spread by less are nearly alike, and what sets them apart, such as rounding, does not count as a rise.
constexpr double least_spread = 0.005;

/// Values of mean 0 and at most one sum of squares, 0 where there is no value.
std::vector<double> standardized(const ReplicatedNumber& number) {
  std::vector<double> sizes;
  for (const auto& value : number)
    if (value) sizes.push_back(std::abs(*value));
  std::vector<double> scores(number.size());
  if (sizes.empty()) return scores;
  constexpr double infinite = 700;
  const double scale = std::clamp(rockstack::median(sizes), least_scale, 1 / least_scale);
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (!number[i]) continue;
    scores[i] = std::copysign(std::min(infinite, std::log1p(std::abs(*number[i]) / scale)), *number[i]);
    sum += scores[i];
  }
  const double mean = sum / static_cast<double>(sizes.size());
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i]) scores[i] -= mean;
    squares += scores[i] * scores[i];
  }
  const double least_squares = static_cast<double>(sizes.size()) * least_spread * least_spread;
  for (double& score : scores) score /= std::sqrt(squares + least_squares);
  return scores;
}

/// By replicate, then by number.
std::vector<std::vector<double>> scores_of_replicates(const std::vector<ReplicatedNumber>& numbers) {
  std::vector<std::vector<double>> scores(numbers.front().size(), std::vector<double>(numbers.size()));
  for (std::size_t j = 0; j < numbers.size(); ++j) {
    const std::vector<double> own = standardized(numbers[j]);
    for (std::size_t i = 0; i < own.size(); ++i) scores[i][j] = own[i];
  }
  return scores;
}

/// How far the sums of a sample are from those of chance, by number.
std::vector<double> rises_of(const std::vector<std::vector<double>>& scores,
                             const std::vector<char>& chosen) {
  std::vector<double> rises(scores.front().size());
  for (std::size_t i = 0; i < scores.size(); ++i) {
    if (chosen[i] == 0) continue;
    for (std::size_t j = 0; j < rises.size(); ++j) rises[j] += scores[i][j];
  }
  for (double& rise : rises) rise = std::abs(rise);
  return rises;
}

}  // namespace

double ways_to_share(std::size_t first, std::size_t second) {
  double ways = 1;
  for (std::size_t i = 1; i <= first; ++i) ways *= static_cast<double>(second + i) / static_cast<double>(i);
  return std::round(ways);
}

double least_joint_chance(std::size_t first, std::size_t second) {
  return std::min(1.0, 2 / ways_to_share(first, second));
}

std::vector<double> joint_chances(const std::vector<ReplicatedNumber>& numbers, std::size_t first) {
  if (numbers.empty()) return {};
  constexpr double rounding = 1e-9;
  const auto scores = scores_of_replicates(numbers);
  std::vector<char> chosen(scores.size());
  std::fill_n(chosen.begin(), first, char{1});
  const std::vector<double> rises = rises_of(scores, chosen);
  std::vector<double> greatest;
  do greatest.push_back(std::ranges::max(rises_of(scores, chosen)));
  while (std::ranges::prev_permutation(chosen).found);
  std::ranges::sort(greatest);
  return mapped(rises, [&](double rise) {
    const auto least = std::ranges::lower_bound(greatest, rise * (1 - rounding));
    const double share = static_cast<double>(greatest.end() - least) / static_cast<double>(greatest.size());
    return std::max(share, least_joint_chance(first, scores.size() - first));
  });
}

}  // namespace rockstack
