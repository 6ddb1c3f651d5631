#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plots/data/results.hpp"

namespace rockstack::plots {

/// A stretch of time in one pattern.
struct PatternSpan {
  double from = 0, to = 0;  ///< s
  std::string pattern;
};

/// What the exact run's events say.
struct ExactEvents {
  std::vector<PatternSpan> spans;                 ///< without gaps, from 0 to the end
  std::vector<std::vector<double>> impact_times;  ///< s, one list an interface
  std::size_t impacts = 0;
};

/// Reads events.csv of an exact run. `end` is its last time in s; `start` the pattern it starts with, "" if
/// unknown.
/// @throws InputError naming file and line.
ExactEvents read_events(const Run& exact, int blocks, double end, const std::string& start);

/// The pattern of the first line of a run's history, "" where it names none.
std::string starting_pattern(const Run& run);

/// An event of the exact run with the patterns on both sides of it.
struct PatternChange {
  double time = 0;   ///< s
  std::string kind;  ///< as events.csv names it
  int interface = 0;
  std::string from, to;
  double approach = 0;  ///< relative speed just before, rad/s
};

/// All events of an exact run's events.csv. @throws InputError naming file and line.
std::vector<PatternChange> read_changes(const Run& exact, int blocks);

/// The impacts among them.
std::vector<PatternChange> read_impact_changes(const Run& exact, int blocks);

/// A name of the paper's for two blocks, and the sides that its interfaces pivot about: −1 left, 0 closed, 1
/// right.
using NamedSides = std::pair<std::string_view, std::array<int, 2>>;
const std::array<NamedSides, 9>& two_block_patterns();

/// The verdicts on an engine's impacts. Times in s, NaN where there is none.
struct MatchedImpact {
  double number = 0;  ///< of the exact impact, from 1
  double difference = 0;
};
struct Impacts {
  std::vector<MatchedImpact> matched;
  std::vector<double> missed;  ///< numbers of exact impacts
  std::vector<double> extra;   ///< places between the numbers of the exact impacts before and after
};

/// Reads impacts.csv of an engine run. @throws InputError naming file and line.
Impacts read_impacts(const Run& run);

}  // namespace rockstack::plots
