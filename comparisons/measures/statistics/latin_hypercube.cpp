#include "comparisons/measures/statistics/latin_hypercube.hpp"

#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <numbers>

namespace rockstack {
namespace {

// What random bits are for, in the last word of a counter: 0 are draws.
constexpr std::uint32_t order_bits = 1, place_bits = 2;

std::uint32_t low_word(std::uint64_t word) {
  return static_cast<std::uint32_t>(word);
}

std::uint32_t high_word(std::uint64_t word) {
  return static_cast<std::uint32_t>(word >> 32U);
}

/// The value at which the standard normal distribution is `share`.
double normal_quantile(double share) {
  using namespace boost::math::policies;
  // In double throughout: what long double needs is computed at the start of every program.
  return -std::numbers::sqrt2 * boost::math::erfc_inv(2 * share, policy<promote_double<false>>());
}

}  // namespace

double quantile(const Distribution& distribution, double share) {
  const auto [kind, first, second] = distribution;
  if (kind == Distribution::Kind::uniform) return first + (second - first) * share;
  const double normal = normal_quantile(share);
  return kind == Distribution::Kind::normal ? first + second * normal : first * std::exp(second * normal);
}

std::uint64_t shuffled(std::uint64_t number, std::uint64_t count, std::uint64_t order, std::uint64_t seed,
                       std::uint32_t key) {
  constexpr std::uint32_t rounds = 8;
  const auto root = static_cast<std::uint64_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  const std::uint64_t other = (count + root - 1) / root;
  const auto word = [&](std::uint64_t half, std::uint32_t round) -> std::uint64_t {
    return philox({low_word(order), low_word(half) * rounds + round, key, order_bits},
                  {low_word(seed), high_word(seed)})[0];
  };
  do {
    std::uint64_t left = number % root, right = number / root;
    for (std::uint32_t round = 0; round < rounds; round += 2) {
      left = (left + word(right, round)) % root;
      right = (right + word(left, round + 1)) % other;
    }
    number = left + root * right;
  } while (number >= count);
  return number;
}

double latin_draw(const Distribution& distribution, const DrawIndex& index, std::uint64_t samples) {
  const std::uint64_t part =
      shuffled(index.run % samples, samples, index.run / samples, index.seed, index.key);
  const std::uint32_t bits = philox({low_word(index.run), high_word(index.run), index.key, place_bits},
                                    {low_word(index.seed), high_word(index.seed)})[0];
  const double within =
      (static_cast<double>(bits >> 12U) + 0.5) * 0x1p-20;  // few bits: none is lost beside 2³⁰
  return quantile(distribution, (static_cast<double>(part) + within) / static_cast<double>(samples));
}

}  // namespace rockstack
