#pragma once

#include <array>
#include <cstdint>

namespace rockstack {

/// The block cipher Philox 4×32 of ten rounds (Salmon, Moraes, Dror & Shaw 2011, "Parallel random numbers: as
/// easy as 1, 2, 3"): random bits as a function of a counter and a key, so that no draw depends on another.
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key);

/// Which random number: that of one varied key in one run of an ensemble.
struct DrawIndex {
  std::uint64_t seed = 0;
  std::uint64_t run = 0;  ///< from 0
  std::uint32_t key = 0;  ///< from 0
};

struct Distribution {
  enum class Kind {
    uniform,    ///< between `first` and `second`
    normal,     ///< mean `first`, standard deviation `second`
    lognormal,  ///< median `first`, `second` the standard deviation of the logarithm
  };
  Kind kind{};
  double first = 0;
  double second = 0;
};

/// The draw of that index: the same on every call, whatever else was drawn before.
double draw(const Distribution& distribution, const DrawIndex& index);

/// The value that half of all draws stay below.
double median(const Distribution& distribution);

}  // namespace rockstack
