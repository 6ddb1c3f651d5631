#pragma once

#include <cstddef>
#include <string>

#include "plots/data/results.hpp"

namespace rockstack::plots {

/// The id under which a page tells the version, parameters and files of a run.
std::string run_anchor(std::size_t run);

/// All runs of a comparison: ten columns, errors first, and a switch that shows the others. The name of a run
/// leads to run_anchor().
std::string runs_table(const Comparison& comparison);

/// Version, parameters and files of every run, by its anchor. @throws InputError naming a malformed file.
std::string run_details(const Comparison& comparison);

/// How far blocks slipped and lifted in each run of law `unilateral`, an interface a row, and where theory
/// has no single answer. Empty where no run has that law.
std::string contact_section(const Comparison& comparison);

}  // namespace rockstack::plots
