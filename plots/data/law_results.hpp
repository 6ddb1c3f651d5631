#pragma once

#include <filesystem>
#include <string>
#include <vector>

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

/// Two answers to one kind of impact.
struct LawPair {
  std::string kind, paper, consistent;  ///< patterns before and after
  double count = 0;                     ///< states that have these answers
  double clearness = 0;                 ///< how far apart they are at most, a share of the rate before
};

/// A state just before an impact that engines were asked about.
struct LawState {
  std::string name;
  double aspect_ratio = 0;  ///< height over width of the top block
  double mass_ratio = 0;    ///< of the top block to the one below
};

/// One row of impact-laws-engines.csv: what one engine made of one state. NaN where a run failed.
struct LawRun {
  Run run;                                     ///< its scene is the state's name
  std::string follows;                         ///< "consistent", "paper" or "neither"; empty where it failed
  double from_paper = 0, from_consistent = 0;  ///< of its velocities, over the largest relative rate before
  std::vector<std::string> cells;              ///< the whole row as text, for LawResults::columns
};

/// What `rockstack compare` has written of a study of impact laws.
struct LawResults {
  std::string title, command, suite_file;
  std::vector<std::pair<std::string, Facts>> definitions;  ///< of each file, what its columns mean
  Facts environment;
  std::vector<std::string> left_out;
  std::vector<std::pair<std::string, Facts>> engines;  ///< parameters of each solver that was asked
  std::vector<LawPair> pairs;
  std::vector<LawState> states;
  std::vector<LawCell> cells;
  std::vector<std::string> columns;  ///< of the runs' cells
  std::vector<LawRun> runs;
};

/// Reads impact-laws.json, impact-laws.csv and impact-laws-engines.csv.
/// @throws InputError naming the file (and line) that is missing or malformed.
LawResults read_law_results(const std::filesystem::path& results);

}  // namespace rockstack::plots
