#pragma once

#include "analytic/scene/history.hpp"

namespace rockstack::plots {

/// A stretch of time in one pattern.
struct PatternSpan {
  double from = 0, to = 0;  ///< s
  Pattern pattern;
};

/// From the first time to the last without gaps; none where a history knows no patterns.
std::vector<PatternSpan> pattern_spans(const History& history);

}  // namespace rockstack::plots
