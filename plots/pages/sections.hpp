#pragma once

#include <string>
#include <vector>

#include "plots/data/results.hpp"

namespace rockstack::plots {

// What a comparison's page says beside its figures.

/// What the differences of a scene are made of: a sentence, and a row for each run with its contact model,
/// contact softness and time step; nothing where none is split.
std::string parts_table(const Comparison& comparison, const std::string& scene);

/// A sentence that a solver's author can act on, and the command that shows it.
struct Remark {
  std::string sentence, command;
};

/// What the runs of one solver say about it, over all scenes and both sets.
struct SolverRemarks {
  std::string solver;  ///< "ode:step"
  std::vector<Remark> list;
};

/// Solvers by the median over scenes of their errors, each over the least of its scene. Empty where
/// has_scores() is false.
std::vector<SolverRemarks> remarks(const Comparison& comparison);

/// The same as a section of a page; nothing where there is none.
std::string remarks_section(const Comparison& comparison);

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
