#include "plots/data/selection.hpp"

#include <fmt/core.h>

#include <boost/algorithm/string/erase.hpp>

#include "comparisons/measures/results/sentences.hpp"

namespace rockstack::plots {
namespace {

/// "+numIterations=…" or the like in a run's settings, empty where it does not stand there.
std::string iterations_in(const std::string& settings) {
  const std::size_t at = settings.find("umIterations=");
  const std::size_t begin = at == std::string::npos ? at : settings.rfind('+', at);
  return begin == std::string::npos ? "" : settings.substr(begin, settings.find('+', at) - begin);
}

/// Settings but for the iterations.
std::string settings_of_line(const Run& run) {
  return boost::erase_first_copy(run.settings, iterations_in(run.settings));
}

/// Whether the runs that a suite gave iterations have one step: these make a line then, and else steps do.
bool iterations_make_lines(const std::vector<Run>& runs) {
  std::set<std::optional<double>> steps;
  for (const Run& run : runs)
    if (iterations_of(run) != 0) steps.insert(run.dt);
  return steps.size() == 1;
}

}  // namespace

std::vector<StepLine> step_lines(const Comparison& comparison, const std::string& scene) {
  std::vector<StepLine> lines;
  const std::vector<Run> runs = done_runs(comparison, scene);
  const bool by_iterations = iterations_make_lines(runs);
  const auto settings = [&](const Run& run) { return by_iterations ? settings_of_line(run) : run.settings; };
  for (const Run& run : runs) {
    if (run.exact()) continue;
    const auto is_own = [&](const StepLine& line) {
      return line.front().solver_name() == run.solver_name() && settings(line.front()) == settings(run);
    };
    found_or_added(lines, is_own, {}).push_back(run);
  }
  const auto place = [](const Run& run) { return std::pair(run.dt, -iterations_of(run)); };
  for (StepLine& line : lines) std::ranges::stable_sort(line, {}, place);
  return lines;
}

bool varies_iterations(const StepLine& line) {
  return line.size() > 1 && line.front().dt == line.back().dt && iterations_of(line.front()) > 0;
}

std::vector<StepLine> shown_lines(const Comparison& comparison, const std::string& scene) {
  std::vector<StepLine> lines = step_lines(comparison, scene);
  std::set<std::string> tuned;
  for (const StepLine& line : lines)
    if (line.front().settings == "tuned") tuned.insert(line.front().solver_name());
  std::erase_if(lines, [&](const StepLine& line) {
    return line.front().settings == "default" && tuned.contains(line.front().solver_name());
  });
  if (lines.size() <= most_lines) return lines;
  const auto error = [](const StepLine& line) { return line.front().error.value_or(HUGE_VAL); };
  std::vector<StepLine> nearest;
  for (const StepLine& line : lines) {
    const auto is_own = [&](const StepLine& one) { return one.front().engine == line.front().engine; };
    StepLine& own = found_or_added(nearest, is_own, line);
    if (error(line) < error(own)) own = line;
  }
  return nearest;
}

RunSelection shown_runs(const Comparison& comparison, const std::string& scene) {
  std::vector<Run> exact = done_runs(comparison, scene);
  exact.resize(!exact.empty() && exact.front().exact() ? 1 : 0);
  return {exact, mapped(shown_lines(comparison, scene), [](const StepLine& line) { return line.front(); })};
}

std::vector<double> chosen_steps(const std::vector<Run>& runs) {
  std::set<double> all;
  for (const Run& run : runs) all.insert(value_of(run.dt));
  std::vector<double> steps(all.rbegin(), all.rend());
  if (steps.size() > 3) steps = {steps.front(), steps[steps.size() / 2], steps.back()};
  return steps;
}

int iterations_of(const Run& run) {
  const std::string text = iterations_in(run.settings);
  return static_cast<int>(std::strtol(text.c_str() + text.find('=') + 1, nullptr, 10));
}

std::string line_label(const Run& run) {
  if (run.exact()) return "exact";
  if (run.has_other_equations()) return "exact, " + run.engine + " equations";
  if (run.has_own_friction()) return "exact, " + std::string(run.engine).replace(8, 1, " ");
  if (run.is_variant()) return "exact, law " + run.engine;
  std::string label = run.engine;
  if (!run.solver.empty()) label += " " + run.solver;
  if (!run.settings.empty()) label += ", " + run.settings;
  return label;
}

std::string line_label(const StepLine& line) {
  Run run = line.front();
  if (run.settings != line.back().settings) run.settings = settings_of_line(run);
  return line_label(run);
}

const StepFit* fit_of(const Comparison& comparison, const StepLine& line, const std::string& quantity) {
  const Run& run = line.front();
  const auto found = std::ranges::find_if(comparison.fits, [&](const SeriesFit& fit) {
    return fit.scene == run.scene && fit.engine == run.engine && fit.solver == run.solver &&
           fit.settings == run.settings && fit.quantity == quantity;
  });
  return found == comparison.fits.end() ? nullptr : &found->fit;
}

std::string run_label(const Run& run) {
  return run.exact() || !run.dt ? line_label(run) : line_label(run) + ", " + duration_text(*run.dt);
}

std::string run_phrase(const Run& run) {
  std::string label = run_label(run);
  const std::size_t comma = label.find(", ");
  return comma == std::string::npos ? label : label.replace(comma, 2, " (") + ")";
}

std::string nearest_phrase(const std::vector<std::string>& first, std::size_t all) {
  if (first.size() == all) return all == 1 ? first.front() : "none can be told apart";
  return joined_up_to(3, first) + (first.size() > 1 ? ", which cannot be told apart" : "");
}

std::string duration_text(double seconds) {
  const double size = std::abs(seconds);
  if (size >= 1 || size == 0) return fmt::format("{:.4g} s", seconds);
  if (size >= 1e-3) return fmt::format("{:.4g} ms", seconds * 1e3);
  if (size >= 0.99e-4) return fmt::format("{:.3g} ms", seconds * 1e3);
  return size >= 1e-6 ? fmt::format("{:.4g} µs", seconds * 1e6) : fmt::format("{:.4g} ns", seconds * 1e9);
}

std::string rounded_duration(double seconds) {
  if (seconds == 0 || !std::isfinite(seconds)) return duration_text(seconds);
  const double unit = std::pow(10, std::floor(std::log10(std::abs(seconds))) - 1);
  return duration_text(std::round(seconds / unit) * unit);
}

std::string draws_note(const Comparison& comparison, const std::string& scene) {
  int draws = 1;
  for (const Run& run : comparison.runs)
    if (run.scene == scene) draws = std::max(draws, run.draws.value_or(1));
  return draws > 1 ? fmt::format("marks: medians of {} replicates at nearby steps; bars: quartiles", draws)
                   : "";
}

}  // namespace rockstack::plots
