#pragma once

#include "comparisons/measures/statistics/draws.hpp"

namespace rockstack {

/// The value that a share of all draws, > 0 and < 1, stays below.
double quantile(const Distribution& distribution, double share);

/// A number's place among `count` > 0 in a random order, both from 0: all different for the runs 0 to count −
/// 1 of an order, which is that of the seed, the key and `order`. A Feistel network over the next larger
/// product of two numbers, walked until it is below `count` (Black & Rogaway 2002, "Ciphers with arbitrary
/// finite domains").
std::uint64_t shuffled(std::uint64_t number, std::uint64_t count, std::uint64_t order, std::uint64_t seed,
                       std::uint32_t key);

/// The draw of that index from a Latin hypercube (McKay, Beckman & Conover 1979, Technometrics 21, 239–245):
/// of `samples` consecutive runs, the first of them a multiple of that, one draw lies in each of as many
/// parts of the distribution that are equally likely. Precondition: samples is at most 2³⁰.
double latin_draw(const Distribution& distribution, const DrawIndex& index, std::uint64_t samples);

}  // namespace rockstack
