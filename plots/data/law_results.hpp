#pragma once

#include "plots/data/results.hpp"

namespace rockstack::plots {

/// One row of impact-laws.csv: the impacts of one kind on stacks within a cell of the grid.
struct LawCell {
  int blocks = 0;
  std::string kind;
  double aspect_ratio_from = 0, aspect_ratio_to = 0;  ///< height over width of the top block
  double mass_ratio_from = 0, mass_ratio_to = 0;      ///< of the top block to the one below
  double impacts = 0;                                 ///< states that were judged
  double differ = 0;                                  ///< after which the laws have different patterns
  double none = 0;                                    ///< after which no pattern is consistent
};

/// One row of impact-laws-engines.csv: what one engine made of one state. NaN where a run failed.
struct LawRun {
  Run run;                                     ///< its scene is the state's name
  std::string follows;                         ///< "consistent", "paper" or "neither"; empty where it failed
  double from_paper = 0, from_consistent = 0;  ///< of its velocities, over the largest relative rate before
};

/// What `rockstack compare` has written of a study of impact laws, without what its page alone takes.
struct LawResults {
  std::size_t states = 0;  ///< that engines were asked about
  std::vector<std::string> left_out;
  std::vector<LawCell> cells;
  std::vector<LawRun> runs;
};

/// Reads impact-laws.json, impact-laws.csv and impact-laws-engines.csv.
/// @throws InputError naming the file (and line) that is missing or malformed.
LawResults read_law_results(const fs::path& results);

/// The impacts of some cells together.
struct LawShare {
  std::string of;  ///< what they have in common
  double impacts = 0, differ = 0, none = 0;

  void add(const LawCell& cell) {
    impacts += cell.impacts;
    differ += cell.differ;
    none += cell.none;
  }
  double differ_percent() const { return impacts > 0 ? 100 * differ / impacts : 0; }
  double none_percent() const { return impacts > 0 ? 100 * none / impacts : 0; }
};

/// Some engine runs together.
struct LawTally {
  std::string of;  ///< what they have in common
  int consistent = 0, paper = 0, neither = 0, failed = 0;
  std::vector<double> from_paper = {}, from_consistent = {};  ///< of those that did not fail
  const LawRun* farthest = nullptr;                           ///< from law consistent, null where all failed

  void add(const LawRun& one);
  int runs() const { return consistent + paper + neither + failed; }
};

/// Shares of cells, or tallies of runs, that have the same name, in order of appearance. Points into `parts`.
template <class Together, class Part, class Name>
std::vector<Together> together_by(const std::vector<Part>& parts, const Name& name) {
  std::vector<Together> list;
  for (const Part& part : parts) {
    const std::string of = name(part);
    found_or_added(list, [&](const Together& one) { return one.of == of; }, {of}).add(part);
  }
  return list;
}

}  // namespace rockstack::plots
