#pragma once

#include <filesystem>

#include "plots/data/scores.hpp"
#include "plots/drawing/gnuplot.hpp"

namespace rockstack::plots {

/// All solvers by their answers to one question: a row a solver and set, a small mark a scene, a large one
/// their median. Precondition: there is a score.
Drawing solver_scores(const Comparison& comparison, const SolverQuestion& question);

/// Draws figures/solvers.QUESTION in the results' folder for each question that has an answer, where
/// has_scores().
void draw_solver_scores(const Comparison& comparison, const std::filesystem::path& results);

}  // namespace rockstack::plots
