#pragma once

#include "plots/pages/html.hpp"

namespace rockstack::plots {

// What pages say beside their figures.

/// The id of the picture in a scene's player, which takes keys.
inline std::string player_anchor(std::size_t scene) {
  return fmt::format("player-{}-stage", scene + 1);
}

/// The player of a scene, with the motions of the runs that figures over time show, thinned so that a page of
/// all scenes' players stays small. `start` is how it stands at first, by the names of lesson.json; null: at
/// the beginning. Precondition: has_motion(). @throws InputError naming a missing or malformed file.
std::string player_section(const Comparison& comparison, std::size_t scene, const Json& start = {});

/// What the differences of a scene are made of: a sentence, and a row for each run with its contact model,
/// contact softness and time step; nothing where none is split.
std::string terms_table(const Comparison& comparison, const std::string& scene);

/// A sentence that a solver's author can act on, and the command that shows it.
struct Remark {
  std::string sentence, command;
};

/// What the runs of one solver say about it, over all scenes and both sets.
struct SolverRemarks {
  std::string solver;  ///< "ode:step"
  std::vector<Remark> list;
};

/// Solvers by the median over scenes of error over the least of the scene; none without has_scores().
std::vector<SolverRemarks> remarks(const Comparison& comparison);

/// Section with these remarks; nothing where there is none.
std::string remarks_section(const Comparison& comparison);

/// All runs: ten columns, errors first, and a switch that shows the others. A run's name leads to details.
std::string runs_table(const Comparison& comparison);

/// Version, parameters and files of every run. @throws InputError naming a malformed file.
std::string run_details(const Comparison& comparison);

/// How far blocks slipped and lifted in each run of law `unilateral`, an interface a row, and where theory
/// has no single answer. Empty where no run has that law.
std::string contact_section(const Comparison& comparison);

}  // namespace rockstack::plots
