#pragma once

#include <string>
#include <vector>

#include "plots/data/results.hpp"

namespace rockstack::plots {

/// A sentence that a solver's author can act on, and the command that shows it.
struct Remark {
  std::string sentence, command;
};

/// What the runs of one solver say about it, over all scenes and both sets.
struct SolverRemarks {
  std::string solver;  ///< "ode:step"
  std::vector<Remark> list;
};

/// Solvers by their rank, the nearest to the exact motion first. Empty where has_scores() is false.
std::vector<SolverRemarks> remarks(const Comparison& comparison);

/// The same as a section of a page; nothing where there is none.
std::string remarks_section(const Comparison& comparison);

}  // namespace rockstack::plots
