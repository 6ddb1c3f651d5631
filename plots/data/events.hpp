#pragma once

#include <string>
#include <vector>

#include "analytic/scene/history.hpp"
#include "comparisons/measures/metrics/contact.hpp"
#include "plots/data/results.hpp"

namespace rockstack::plots {

/// A stretch of time in one pattern.
struct PatternSpan {
  double from = 0, to = 0;  ///< s
  Pattern pattern;
};

/// From the first time to the last without gaps; none where a history knows no patterns.
std::vector<PatternSpan> pattern_spans(const History& history);

/// The times of the impacts at an interface, s.
std::vector<double> impact_times(const History& history, int interface);

/// A pattern's name for people: an arrow the way an interface slides, a dash where it is apart.
std::string shown_pattern(const Pattern& pattern);

/// What a run's summary.json says of its contacts.
struct ContactSummary {
  std::vector<InterfaceSummary> interfaces;  ///< none under laws of pivots
  std::vector<std::string> warnings;         ///< of where theory has no single answer, and the like
};

/// @throws InputError naming the file that is malformed; nothing where it is missing.
ContactSummary read_contact_summary(const Run& run);

}  // namespace rockstack::plots
