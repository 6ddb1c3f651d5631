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

/// The ranks of one stratum, and those that fall to the second sample.
struct Ranks {
  std::vector<std::size_t> all;  ///< rising
  std::size_t count = 0;         ///< of the second sample
  std::size_t sum = 0;           ///< its own

  std::size_t least() const {
    return std::accumulate(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count), std::size_t{0});
  }
  std::size_t most() const {
    return std::accumulate(all.end() - static_cast<std::ptrdiff_t>(count), all.end(), std::size_t{0});
  }
};

Ranks ranks_of(const Stratum& stratum) {
  std::vector<double> sorted = stratum.first;
  sorted.insert(sorted.end(), stratum.second.begin(), stratum.second.end());
  std::sort(sorted.begin(), sorted.end());
  Ranks ranks{doubled_ranks(sorted), stratum.second.size()};
  for (const double value : stratum.second)
    ranks.sum += ranks.all[static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), value) -
                                                    sorted.begin())];
  return ranks;
}

/// In how many ways the second sample's ranks add up to each sum, every choice of them alike.
std::vector<double> ways_of(const Ranks& ranks) {
  const std::size_t most = std::accumulate(ranks.all.begin(), ranks.all.end(), std::size_t{0});
  // choices[k][s]: how many sets of k of the ranks so far add up to s
  std::vector<std::vector<double>> choices(ranks.count + 1, std::vector<double>(most + 1));
  choices[0][0] = 1;
  std::size_t reach = 0;
  for (const std::size_t rank : ranks.all) {
    reach += rank;
    for (std::size_t k = ranks.count; k > 0; --k)
      for (std::size_t sum = reach; sum >= rank; --sum) choices[k][sum] += choices[k - 1][sum - rank];
  }
  return choices[ranks.count];
}

/// Of sums over all strata.
class ExactSums {
 public:
  explicit ExactSums(const std::vector<Ranks>& strata) {
    for (const Ranks& ranks : strata) {
      const std::vector<double> own = ways_of(ranks);
      std::vector<double> both(ways_.size() + own.size() - 1);
      for (std::size_t i = 0; i < ways_.size(); ++i)
        for (std::size_t j = 0; ways_[i] > 0 && j < own.size(); ++j) both[i + j] += ways_[i] * own[j];
      ways_ = both;
    }
  }

  Tails at(std::size_t sum) const {
    const auto begin = ways_.begin(), here = begin + static_cast<std::ptrdiff_t>(sum);
    const double below = std::accumulate(begin, here, 0.0),
                 above = std::accumulate(here + 1, ways_.end(), 0.0);
    const double all = below + *here + above;
    return {(below + *here) / all, (above + *here) / all};
  }

 private:
  std::vector<double> ways_{1};  ///< by sum
};

/// The normal limit of the same.
class NormalSums {
 public:
  explicit NormalSums(const std::vector<Ranks>& strata) {
    double variance = 0;
    for (const Ranks& ranks : strata) {
      const auto all = static_cast<double>(ranks.all.size()), own = static_cast<double>(ranks.count);
      const double mean = all + 1;
      const double squares = std::accumulate(
          ranks.all.begin(), ranks.all.end(), 0.0,
          [&](double sum, std::size_t rank) { return sum + std::pow(static_cast<double>(rank) - mean, 2); });
      mean_ += own * mean;
      variance += own * (all - own) / all / (all - 1) * squares;
    }
    deviation_ = std::sqrt(variance);
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
MannWhitney compare_sums(const Sums& sums, const std::vector<Ranks>& strata) {
  std::size_t sum = 0, least = 0, most = 0;
  double won = 0, pairs = 0;
  for (const Ranks& ranks : strata) {
    const auto own = static_cast<double>(ranks.count);
    sum += ranks.sum, least += ranks.least(), most += ranks.most();
    won += static_cast<double>(ranks.sum) / 2 - own * (own + 1) / 2;
    pairs += own * static_cast<double>(ranks.all.size() - ranks.count);
  }
  return {won / pairs, sums.at(sum).p_value(), std::min(sums.at(least).p_value(), sums.at(most).p_value())};
}

}  // namespace

MannWhitney mann_whitney(const std::vector<double>& first, const std::vector<double>& second) {
  return mann_whitney(std::vector<Stratum>{{first, second}});
}

MannWhitney mann_whitney(const std::vector<Stratum>& strata) {
  std::vector<Ranks> ranks;
  std::size_t values = 0;
  for (const Stratum& stratum : strata) {
    ranks.push_back(ranks_of(stratum));
    values += ranks.back().all.size();
  }
  constexpr std::size_t most_exact = 50;
  if (values > most_exact) return compare_sums(NormalSums(ranks), ranks);
  return compare_sums(ExactSums(ranks), ranks);
}

}  // namespace rockstack
