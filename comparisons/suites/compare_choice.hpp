#pragma once

#include "comparisons/suites/suite.hpp"

namespace rockstack {

/// What a comparison is asked for by the program's options, or from Python.
struct CompareChoice {
  SceneChoice scenes = {};                      ///< suites say their own
  std::optional<int> replicates = {};           ///< in the place of those of all suites
  std::optional<double> history_interval = {};  ///< likewise, s
};

/// How messages name its numbers: as arguments in Python, unless options are given.
struct CompareNames {
  std::string steps = "dt", replicates = "draws", history_interval = "history_interval";
};

/// @throws InputError with name, value and what is allowed for a number that no suite could have.
void require_valid(const CompareChoice& choice, const CompareNames& names = {});

/// Changes what a suite says by itself.
void apply(const CompareChoice& choice, Suite& suite);

/// Refuses what is chosen beside a suite or a study. `prefix`: of names in messages, "--" of options.
/// @throws InputError with the first that is.
void refuse(const SceneChoice& choice, const std::string& study, const std::string& prefix = "");

/// @throws InputError where the number of that name is not finite and > 0.
void require_above_zero(const std::string& name, double value);

}  // namespace rockstack
