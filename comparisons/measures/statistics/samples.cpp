#include "comparisons/measures/statistics/samples.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <functional>
#include <numbers>
#include <numeric>

#include "analytic/scene/lists.hpp"
#include "comparisons/measures/metrics/alignment.hpp"
#include "comparisons/measures/statistics/draws.hpp"

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

/// Twice the ranks of one stratum, whole numbers, where equal values share one, and those that fall to the
/// second sample.
struct Ranks {
  std::vector<std::size_t> all;  ///< rising
  std::size_t count = 0;         ///< of the second sample
  std::size_t sum = 0;           ///< its own
};

Ranks ranks_of(const Stratum& stratum) {
  std::vector<double> sorted = stratum.first;
  sorted.insert(sorted.end(), stratum.second.begin(), stratum.second.end());
  std::ranges::sort(sorted);
  const auto rank = [&](double value) {
    const auto [low, high] = std::equal_range(sorted.begin(), sorted.end(), value);
    return static_cast<std::size_t>(low - sorted.begin() + high - sorted.begin()) + 1;
  };
  Ranks ranks{mapped(sorted, rank), stratum.second.size()};
  for (const double value : stratum.second) ranks.sum += rank(value);
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

/// The chance of a sum of doubled ranks over all strata that is as far from the middle, or further.
using ChanceOf = std::function<double(std::size_t sum)>;

/// From those of both tails, the sum itself included.
double of_both_sides(double lower, double upper) {
  return std::min(1.0, 2 * std::min(lower, upper));
}

ChanceOf exact_chance(const std::vector<Ranks>& strata) {
  std::vector<double> ways{1};  // by sum
  for (const Ranks& ranks : strata) {
    const std::vector<double> own = ways_of(ranks);
    std::vector<double> both(ways.size() + own.size() - 1);
    for (std::size_t i = 0; i < ways.size(); ++i)
      for (std::size_t j = 0; ways[i] > 0 && j < own.size(); ++j) both[i + j] += ways[i] * own[j];
    ways = both;
  }
  return [ways](std::size_t sum) {
    const auto begin = ways.begin(), here = begin + static_cast<std::ptrdiff_t>(sum);
    const double below = std::accumulate(begin, here, 0.0),
                 above = std::accumulate(here + 1, ways.end(), 0.0);
    const double all = below + *here + above;
    return of_both_sides((below + *here) / all, (above + *here) / all);
  };
}

/// Its normal limit.
ChanceOf normal_chance(const std::vector<Ranks>& strata) {
  double mean_sum = 0, variance = 0;
  for (const Ranks& ranks : strata) {
    const auto all = static_cast<double>(ranks.all.size()), own = static_cast<double>(ranks.count);
    const double mean = all + 1;
    const double squares = std::accumulate(
        ranks.all.begin(), ranks.all.end(), 0.0,
        [&](double sum, std::size_t rank) { return sum + std::pow(static_cast<double>(rank) - mean, 2); });
    mean_sum += own * mean;
    variance += own * (all - own) / all / (all - 1) * squares;
  }
  return [mean_sum, deviation = std::sqrt(variance)](std::size_t sum) {
    const auto tail = [&](double apart) {
      return deviation > 0 ? std::erfc((apart - 1) / deviation / std::numbers::sqrt2) / 2 : 1;
    };
    const double apart = static_cast<double>(sum) - mean_sum;
    return of_both_sides(tail(-apart), tail(apart));
  };
}

constexpr int chance_draws = 101;  // an odd number, whose median is one of them

/// Draws 101 sequences and takes the median of how many impacts match.
template <class Draw>
int median_matched(const std::vector<ImpactTime>& exact, const std::vector<double>& windows,
                   const Draw& drawn) {
  std::vector<double> matched;
  for (std::uint64_t run = 0; run < chance_draws; ++run) {
    std::vector<ImpactTime> impacts = drawn(run);
    std::ranges::stable_sort(impacts, {}, &ImpactTime::time);
    matched.push_back(count(align(exact, impacts, windows)).matched);
  }
  return static_cast<int>(rockstack::median(std::move(matched)));
}

double uniform(double low, double high, std::uint64_t run, std::size_t key) {
  return draw({Distribution::Kind::uniform, low, high}, {1, run, static_cast<std::uint32_t>(key)});
}

}  // namespace

double reach_of_interval(std::size_t freedom) {
  using namespace boost::math::policies;
  // In double throughout: what long double needs is computed at the start of every program.
  const boost::math::students_t_distribution<double, policy<promote_double<false>>> student(
      static_cast<double>(freedom));
  return boost::math::quantile(boost::math::complement(student, 0.025));
}

AdjustedTests adjust(const std::vector<TestChance>& tests, double level) {
  std::vector<std::size_t> counted;  // tests that can reach one of so many equal shares of the level
  std::size_t shares = 0;
  do {
    ++shares;
    counted.clear();
    for (std::size_t i = 0; i < tests.size(); ++i)
      if (tests[i].least_p_value <= level / static_cast<double>(shares)) counted.push_back(i);
  } while (counted.size() > shares);
  std::ranges::sort(counted,
                    [&](std::size_t a, std::size_t b) { return tests[a].p_value < tests[b].p_value; });
  AdjustedTests adjusted{std::vector<double>(tests.size(), 1.0), counted.size()};
  double before = 0;
  for (std::size_t i = 0; i < counted.size(); ++i) {
    const double own = tests[counted[i]].p_value * static_cast<double>(counted.size() - i);
    before = std::min(1.0, std::max(before, own));
    adjusted.p_values[counted[i]] = before;
  }
  return adjusted;
}

std::vector<bool> could_show(std::vector<TestChance> tests, double level) {
  for (TestChance& test : tests) test.p_value = test.least_p_value;
  return mapped(adjust(tests, level).p_values, [&](double chance) -> bool { return chance <= level; });
}

KolmogorovSmirnov kolmogorov_smirnov(std::vector<double> first, std::vector<double> second) {
  std::ranges::sort(first);
  std::ranges::sort(second);
  const auto one = static_cast<double>(first.size()), other = static_cast<double>(second.size());
  double distance = 0;
  std::size_t i = 0, j = 0;
  while (i < first.size() && j < second.size()) {
    const double value = std::min(first[i], second[j]);
    while (i < first.size() && first[i] <= value) ++i;
    while (j < second.size() && second[j] <= value) ++j;
    distance = std::max(distance, std::abs(static_cast<double>(i) / one - static_cast<double>(j) / other));
  }
  const double root = std::sqrt(one * other / (one + other));
  const double factor = root + 0.12 + 0.11 / root;
  constexpr double five_percent = 1.3581;  // where limiting_chance() is 0.05
  return {distance, limiting_chance(factor * distance), five_percent / factor};
}

MannWhitney mann_whitney(const std::vector<double>& first, const std::vector<double>& second) {
  return mann_whitney(std::vector<Stratum>{{first, second}});
}

MannWhitney mann_whitney(const std::vector<Stratum>& strata) {
  std::vector<Ranks> all;
  std::size_t values = 0, sum = 0, least = 0, most = 0;
  double won = 0, pairs = 0;
  for (const Stratum& stratum : strata) {
    const Ranks& ranks = all.emplace_back(ranks_of(stratum));
    const auto own = static_cast<double>(ranks.count);
    const auto count = static_cast<std::ptrdiff_t>(ranks.count);
    values += ranks.all.size();
    sum += ranks.sum;
    least = std::accumulate(ranks.all.begin(), ranks.all.begin() + count, least);
    most = std::accumulate(ranks.all.end() - count, ranks.all.end(), most);
    won += static_cast<double>(ranks.sum) / 2 - own * (own + 1) / 2;
    pairs += own * static_cast<double>(ranks.all.size() - ranks.count);
  }
  constexpr std::size_t most_exact = 50;
  const ChanceOf chance = values > most_exact ? normal_chance(all) : exact_chance(all);
  return {{chance(sum), std::min(chance(least), chance(most))}, won / pairs};
}

ChanceMatches chance_matches(const std::vector<ImpactTime>& exact, const std::vector<ImpactTime>& engine,
                             const std::vector<double>& windows, double duration) {
  const auto random = [&](std::uint64_t run) {
    std::vector<ImpactTime> impacts = engine;
    for (std::size_t i = 0; i < impacts.size(); ++i) impacts[i].time = uniform(0, duration, run, i);
    return impacts;
  };
  const auto shifted = [&](std::uint64_t run) {
    std::vector<ImpactTime> impacts = engine;
    const double shift = uniform(0.1 * duration, 0.9 * duration, run, 0);
    for (ImpactTime& impact : impacts) impact.time = std::fmod(impact.time + shift, duration);
    return impacts;
  };
  return {median_matched(exact, windows, random), median_matched(exact, windows, shifted)};
}

}  // namespace rockstack
