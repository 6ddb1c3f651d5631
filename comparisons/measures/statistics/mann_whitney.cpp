#include "comparisons/measures/statistics/mann_whitney.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

namespace rockstack {
namespace {

/// Twice the rank of each value, of all in rising order: whole numbers, where equal values share a rank.
std::vector<std::size_t> doubled_ranks(const std::vector<double>& sorted) {
  std::vector<std::size_t> ranks;
  ranks.reserve(sorted.size());
  for (const double value : sorted) {
    const auto [low, high] = std::equal_range(sorted.begin(), sorted.end(), value);
    ranks.push_back(static_cast<std::size_t>(low - sorted.begin() + high - sorted.begin()) + 1);
  }
  return ranks;
}

/// The chances of both tails at a sum of doubled ranks, that sum included.
struct Tails {
  double lower, upper;

  double p_value() const { return std::min(1.0, 2 * std::min(lower, upper)); }
};

/// Of `count` out of `ranks`, every choice of them alike.
class ExactSums {
 public:
  ExactSums(const std::vector<std::size_t>& ranks, std::size_t count)
      : ways_(std::accumulate(ranks.begin(), ranks.end(), std::size_t{0}) + 1) {
    // choices[k][s]: how many sets of k of the ranks so far add up to s
    std::vector<std::vector<double>> choices(count + 1, std::vector<double>(ways_.size()));
    choices[0][0] = 1;
    std::size_t reach = 0;
    for (const std::size_t rank : ranks) {
      reach += rank;
      for (std::size_t k = count; k > 0; --k)
        for (std::size_t sum = reach; sum >= rank; --sum) choices[k][sum] += choices[k - 1][sum - rank];
    }
    ways_ = choices[count];
  }

  Tails at(std::size_t sum) const {
    const auto begin = ways_.begin(), here = begin + static_cast<std::ptrdiff_t>(sum);
    const double below = std::accumulate(begin, here, 0.0),
                 above = std::accumulate(here + 1, ways_.end(), 0.0);
    const double all = below + *here + above;
    return {(below + *here) / all, (above + *here) / all};
  }

 private:
  std::vector<double> ways_;  ///< by sum
};

/// The normal limit of the same.
class NormalSums {
 public:
  NormalSums(const std::vector<std::size_t>& ranks, std::size_t count) {
    const auto all = static_cast<double>(ranks.size()), own = static_cast<double>(count);
    const double mean = all + 1;
    const double squares = std::accumulate(
        ranks.begin(), ranks.end(), 0.0,
        [&](double sum, std::size_t rank) { return sum + std::pow(static_cast<double>(rank) - mean, 2); });
    mean_ = own * mean;
    deviation_ = std::sqrt(own * (all - own) / all / (all - 1) * squares);
  }

  Tails at(std::size_t sum) const {
    const auto tail = [&](double apart) {
      return deviation_ > 0 ? std::erfc((apart - 1) / deviation_ / std::numbers::sqrt2) / 2 : 1;
    };
    const double apart = static_cast<double>(sum) - mean_;
    return {tail(-apart), tail(apart)};
  }

 private:
  double mean_ = 0, deviation_ = 0;
};

template <class Sums>
MannWhitney compare_sums(const Sums& sums, const std::vector<std::size_t>& ranks, std::size_t count,
                         std::size_t sum) {
  const auto part = static_cast<std::ptrdiff_t>(count);
  const std::size_t least = std::accumulate(ranks.begin(), ranks.begin() + part, std::size_t{0});
  const std::size_t most = std::accumulate(ranks.end() - part, ranks.end(), std::size_t{0});
  const double other = static_cast<double>(ranks.size() - count), own = static_cast<double>(count);
  return {(static_cast<double>(sum) / 2 - own * (own + 1) / 2) / own / other, sums.at(sum).p_value(),
          std::min(sums.at(least).p_value(), sums.at(most).p_value())};
}

}  // namespace

MannWhitney mann_whitney(const std::vector<double>& first, const std::vector<double>& second) {
  std::vector<double> sorted = first;
  sorted.insert(sorted.end(), second.begin(), second.end());
  std::sort(sorted.begin(), sorted.end());
  const std::vector<std::size_t> ranks = doubled_ranks(sorted);
  std::size_t sum = 0;
  for (const double value : second)
    sum += ranks[static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), value) -
                                          sorted.begin())];
  constexpr std::size_t most_exact = 50;
  if (ranks.size() > most_exact)
    return compare_sums(NormalSums(ranks, second.size()), ranks, second.size(), sum);
  return compare_sums(ExactSums(ranks, second.size()), ranks, second.size(), sum);
}

}  // namespace rockstack
