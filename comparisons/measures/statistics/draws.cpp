#include "comparisons/measures/statistics/draws.hpp"

#include <cmath>
#include <numbers>

namespace rockstack {
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) {
  constexpr int rounds = 10;
  constexpr std::uint64_t first_factor = 0xD2511F53, second_factor = 0xCD9E8D57;
  for (int round = 0; round < rounds; ++round) {
    const std::uint64_t first = first_factor * counter[0];
    const std::uint64_t second = second_factor * counter[2];
    counter = {
        static_cast<std::uint32_t>(second >> 32U) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(second),
        static_cast<std::uint32_t>(first >> 32U) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(first)};
    key[0] += 0x9E3779B9;
    key[1] += 0xBB67AE85;
  }
  return counter;
}

double draw(const Distribution& distribution, const DrawIndex& index) {
  const auto [kind, first, second] = distribution;
  const auto low = [](std::uint64_t word) { return static_cast<std::uint32_t>(word); };
  const auto high = [](std::uint64_t word) { return static_cast<std::uint32_t>(word >> 32U); };
  const auto bits =
      philox({low(index.run), high(index.run), index.key, 0}, {low(index.seed), high(index.seed)});
  // Between 0 and 1, both ends left out.
  const auto uniform = [](std::uint32_t upper, std::uint32_t lower) {
    const std::uint64_t word = (std::uint64_t{upper} << 32U) | lower;
    return (static_cast<double>(word >> 12U) + 0.5) * 0x1p-52;
  };
  const double one = uniform(bits[0], bits[1]), other = uniform(bits[2], bits[3]);
  if (kind == Distribution::Kind::uniform) return first + (second - first) * one;
  // Standard normal (Box & Muller 1958).
  const double normal = std::sqrt(-2 * std::log(one)) * std::cos(2 * std::numbers::pi * other);
  return kind == Distribution::Kind::normal ? first + second * normal : first * std::exp(second * normal);
}

double median(const Distribution& distribution) {
  return distribution.kind == Distribution::Kind::uniform ? (distribution.first + distribution.second) / 2
                                                          : distribution.first;
}

}  // namespace rockstack
