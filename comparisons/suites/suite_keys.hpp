#pragma once

#include "analytic/scene/input/key.hpp"
#include "comparisons/measures/results/print_style.hpp"
#include "comparisons/suites/suite.hpp"

namespace rockstack {

// Every key of a suite file. A new one that is a number or a text is a member and a line where its table is
// defined: in suite_file.cpp, engine_series.cpp or perturbations.cpp, beside what reads the others; those of
// [figures] are in measures/results/print_style.cpp.

/// A table [[engines]]; nodes are those of its file.
struct EngineTable {
  const Node *name = nullptr, *worker = nullptr, *parameters = nullptr;
  std::vector<std::string> except;
  std::vector<std::string> settings{"default", "tuned"};
  std::vector<double> steps = default_steps;  ///< s
};

/// Its name that stands for all engines, but for those of `except`.
inline constexpr const char* all_engines = "*";

/// A table [[trajectories]].
struct TrajectoryTable {
  NamedTrajectory named;
  const Node* scene = nullptr;
};

extern const KeysOf<Suite> suite_keys;
extern const KeysOf<EngineTable> engine_keys;
extern const KeysOf<TrajectoryTable> trajectory_keys;
extern const KeysOf<Replicates> replicates_keys;
extern const KeysOf<Perturbations> perturbations_keys;
extern const KeysOf<Suite> statements_keys;

/// All tables of a suite file, in the order of a file.
inline constexpr std::initializer_list<const KeyTable*> suite_tables{
    &suite_keys,         &engine_keys, &trajectory_keys, &replicates_keys,
    &perturbations_keys, &print_keys,  &statements_keys};

}  // namespace rockstack
