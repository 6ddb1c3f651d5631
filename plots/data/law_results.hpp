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

/// What `rockstack compare` has written of a study of impact laws that figures show.
struct LawResults {
  std::vector<LawCell> cells;
  std::vector<LawRun> runs;
};

/// Reads impact-laws.csv and impact-laws-engines.csv.
/// @throws InputError naming the file (and line) that is missing or malformed.
LawResults read_law_results(const fs::path& results);

}  // namespace rockstack::plots
