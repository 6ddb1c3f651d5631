#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "analytic/scene/pattern.hpp"

namespace rockstack {

/// A time at which contact leaves several motions.
struct Fork {
  double time = 0;            ///< s
  std::vector<Pattern> ways;  ///< what each goes on with; the first is that of a motion that is led nowhere
  std::size_t taken = 0;      ///< of these
};

/// Leads a motion through its forks.
struct Branching {
  std::vector<std::size_t> list = {};  ///< which way to take, fork by fork; the first at those beyond
  std::vector<Fork> forks = {};        ///< that the motion has come to

  /// The way that is taken at the next fork.
  std::size_t take(double time, std::vector<Pattern> ways) {
    if (ways.size() == 1) return 0;
    const std::size_t way = forks.size() < list.size() ? list[forks.size()] : 0;
    forks.push_back({time, std::move(ways), way});
    return way;
  }
};

}  // namespace rockstack
