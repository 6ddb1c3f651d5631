#pragma once

#include "analytic/scene/input/key.hpp"
#include "comparisons/suites/suite.hpp"

namespace rockstack {

// Every key of a suite file. A new one that is a number or a text is a member and a line where its table is
// defined: in suite_file.cpp, engine_series.cpp or perturbations.cpp, beside what reads the others.

extern const KeysOf<Suite> suite_keys;
extern const KeyTable engine_keys, trajectory_keys;
extern const KeysOf<Replicates> replicates_keys;
extern const KeysOf<Perturbations> perturbations_keys;
extern const KeyTable statements_keys;

/// All tables of a suite file, in the order of a file.
inline constexpr std::initializer_list<const KeyTable*> suite_tables{
    &suite_keys, &engine_keys, &trajectory_keys, &replicates_keys, &perturbations_keys, &statements_keys};

}  // namespace rockstack
