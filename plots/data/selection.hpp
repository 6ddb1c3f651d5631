#pragma once

#include "plots/data/results.hpp"

namespace rockstack::plots {

/// What figures over time show: the exact run, and of each of shown_lines() that with the smallest step.
struct RunSelection {
  std::vector<Run> exact;  ///< one run, or none where it failed
  std::vector<Run> engines;
};

RunSelection shown_runs(const Comparison& comparison, const std::string& scene);

/// Runs of one engine, solver and settings, by ascending time step; those that differ in their iterations
/// too, by falling iterations.
using StepLine = std::vector<Run>;

/// More lines than a figure over time has room for.
inline constexpr std::size_t most_lines = 12;

/// Lines, one for each engine, solver and settings; default settings only where there are no tuned ones.
/// Where these are more than `most_lines`, of each engine the one that comes nearest at its finest step.
std::vector<StepLine> shown_lines(const Comparison& comparison, const std::string& scene);

/// A line's runs at its coarsest and its finest step; one where it has no more.
inline std::vector<Run> ends_of(const StepLine& line) {
  return line.size() < 2 ? std::vector<Run>{line.front()} : std::vector<Run>{line.back(), line.front()};
}

/// Whether the runs of a line differ in their iterations, at one step.
bool varies_iterations(const StepLine& line);

/// All engine runs of a scene that are done, line by line in the order of the file.
std::vector<StepLine> step_lines(const Comparison& comparison, const std::string& scene);

/// The largest, the middle and the smallest of the time steps of some runs; or all, where there are fewer.
std::vector<double> chosen_steps(const std::vector<Run>& runs);

/// The iterations that a suite gave the solver of a run, 0 where it gave none.
int iterations_of(const Run& run);

/// "bullet sequential-impulse, tuned"; "exact, linear equations" or "exact, law consistent" of a variant.
std::string line_label(const Run& run);

/// Label of a line of runs, without the iterations where they vary.
std::string line_label(const StepLine& line);

/// The fit of a line's errors in a column, null where there is none.
const StepFit* fit_of(const Comparison& comparison, const StepLine& line, const std::string& quantity);

/// Label of a run with its time step, "bullet sequential-impulse, tuned, 0.1 ms".
std::string run_label(const Run& run);

/// Label of a run inside a sentence, "bullet sequential-impulse (tuned, 0.1 ms)".
std::string run_phrase(const Run& run);

/// The least RMS angle difference that figures tell apart, rad: what is less is rounding.
inline constexpr double least_error = 1e-12;

/// Those that share a first rank of `all`, in words: which they are, and whether they can be told apart.
std::string nearest_phrase(const std::vector<std::string>& first, std::size_t all);

/// What the marks of a scene's figures stand for: "marks: medians of 21 replicates; bars: quartiles"; empty
/// where its rows are single runs.
std::string draws_note(const Comparison& comparison, const std::string& scene);

/// "low to high", or once where both are said alike.
inline std::string span_text(const std::string& low, const std::string& high) {
  return low == high ? low : low + " to " + high;
}

/// A duration with a unit that suits it: "0.1 ms", "12 µs", "3.5 s".
std::string duration_text(double seconds);

/// Duration with two significant digits.
std::string rounded_duration(double seconds);

}  // namespace rockstack::plots
