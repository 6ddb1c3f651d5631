#pragma once

#include <functional>
#include <string>
#include <vector>

#include "plots/data/law_results.hpp"

namespace rockstack::plots {

/// The impacts of some cells together.
struct LawShare {
  std::string of;  ///< what they have in common
  double impacts = 0, differ = 0, none = 0;

  double differ_percent() const { return impacts > 0 ? 100 * differ / impacts : 0; }
  double none_percent() const { return impacts > 0 ? 100 * none / impacts : 0; }
};

/// Cells together that have the same name, in order of appearance.
std::vector<LawShare> shares_by(const std::vector<LawCell>& cells,
                                const std::function<std::string(const LawCell&)>& name);

/// The range of a cell along either axis, "0.25 to 0.386".
std::string aspect_ratio_range(const LawCell& cell);
std::string mass_ratio_range(const LawCell& cell);

/// Some engine runs together.
struct LawTally {
  std::string of;  ///< what they have in common
  int consistent = 0, paper = 0, neither = 0, failed = 0;
  std::vector<double> from_paper, from_consistent;  ///< of those that did not fail
  const LawRun* farthest = nullptr;                 ///< from law consistent, null where all failed

  int runs() const { return consistent + paper + neither + failed; }
};

/// Runs together that have the same name, in order of appearance. Points into `runs`.
std::vector<LawTally> tallies_by(const std::vector<LawRun>& runs,
                                 const std::function<std::string(const LawRun&)>& name);

}  // namespace rockstack::plots
