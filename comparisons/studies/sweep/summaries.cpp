#include "analytic/scene/lists.hpp"
#include "comparisons/studies/sweep/sweep.hpp"

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/statistics/fragility.hpp"
#include "comparisons/measures/statistics/samples.hpp"

namespace rockstack {
namespace {

/// What summaries take from one line of runs.csv.
struct Run {
  double intensity = 0, period = 0, friction = 0;
  std::string others;  ///< all other varied values, as "key=value"
  bool failed = false, toppled = false, moved = false;
  bool with_impact = false;
  double peak_ratio = 0;
  std::string onset, motion;  ///< names of modes
};

/// Values of varied keys stand between `run` and `peak_1`.
Run run_in(const CsvLine& line, const SummaryKeys& keys) {
  Run run;
  run.intensity = line.value(keys.intensity);
  if (!keys.period.empty()) run.period = line.value(keys.period);
  if (!keys.friction.empty()) run.friction = line.value(keys.friction);
  const std::size_t first_outcome = line.index("peak_1");
  for (std::size_t c = 1; c < first_outcome; ++c) {
    const std::string& name = line.names()[c];
    if (name == keys.intensity || name == keys.period || name == keys.friction) continue;
    run.others += (run.others.empty() ? "" : ", ") + name + "=" + line.text(c);
  }
  run.failed = line.text("status") == "failed";
  if (run.failed) return run;
  if (!keys.friction.empty()) run.onset = line.text("onset"), run.motion = line.text("motion");
  run.toppled = line.value("toppled") > 0;
  run.moved = line.value("events") > 0;
  run.with_impact = line.value("impacts") > 0;
  run.peak_ratio = line.value("peak_ratio");
  return run;
}

/// The level that an intensity belongs to: its own; or where there are many, as values are drawn, the middle
/// one of a bin, each bin with as many runs as any other.
std::map<double, double> levels_of(const std::vector<Run>& runs, std::size_t most) {
  constexpr std::size_t bins = 20;
  std::vector<double> all = each_of(runs, &Run::intensity);
  std::ranges::sort(all);
  std::map<double, double> levels;
  for (const double intensity : all) levels.emplace(intensity, intensity);
  if (levels.size() <= most) return levels;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::size_t bin = i * bins / all.size();
    levels[all[i]] = all[(2 * bin + 1) * all.size() / (2 * bins)];
  }
  return levels;
}

/// What came of the runs at each level.
std::vector<Level> tallied(const std::vector<Run>& runs, const std::map<double, double>& levels) {
  std::map<double, Level> tallies;
  for (const Run& run : runs) {
    const double intensity = levels.at(run.intensity);
    Level& level = tallies[intensity];
    level.intensity = intensity;
    ++(run.failed ? level.failed : level.runs);
    if (run.toppled) ++level.toppled;
  }
  return each_of(tallies, [](const auto& one) { return one.second; });
}

/// The curve is fitted to all intensities as they are, whatever the levels of the table.
void write_fragility(const std::vector<Run>& runs, const std::map<double, double>& levels,
                     const std::filesystem::path& folder) {
  const auto fit = fit_fragility(tallied(runs, levels_of(runs, runs.size())));
  CsvWriter csv;
  csv.line("intensity", "runs", "toppled", "failed", "fraction", "lower", "upper", "fitted");
  for (const Level& level : tallied(runs, levels)) {
    const Bounds bounds = wilson_bounds(level.toppled, level.runs);
    const std::string fraction =
        level.runs == 0 ? ""
                        : number_text(static_cast<double>(level.toppled) / static_cast<double>(level.runs));
    csv.line(number_text(level.intensity), level.runs, level.toppled, level.failed, fraction,
             number_text(bounds.lower), number_text(bounds.upper),
             fit ? number_text(probability(*fit, level.intensity)) : "");
  }
  write_file(folder / "fragility.csv", csv.text());
  CsvWriter fitted;
  fitted.line("median", "beta", "log_likelihood");
  if (fit) fitted.line(number_text(fit->median), number_text(fit->beta), number_text(fit->log_likelihood));
  write_file(folder / "fragility-fit.csv", fitted.text());
}

void write_incremental(std::vector<Run> runs, const std::map<double, double>& levels,
                       const std::filesystem::path& folder) {
  std::erase_if(runs, [](const Run& run) { return run.failed; });
  std::map<double, std::vector<double>> ratios_of;
  for (const Run& run : runs)
    ratios_of[levels.at(run.intensity)].push_back(run.toppled ? std::numeric_limits<double>::infinity()
                                                              : run.peak_ratio);
  // Stable: curves stay in the order of their first run.
  std::map<std::string, std::size_t> numbers;
  for (const Run& run : runs) numbers.emplace(run.others, numbers.size());
  if (numbers.size() == runs.size()) return;
  std::vector<std::pair<std::size_t, const Run*>> ordered;
  ordered.reserve(runs.size());
  for (const Run& run : runs) ordered.emplace_back(numbers[run.others], &run);
  std::ranges::stable_sort(ordered, [](const auto& a, const auto& b) {
    return std::pair(a.first, a.second->intensity) < std::pair(b.first, b.second->intensity);
  });
  CsvWriter curves;
  curves.line("curve", "values", "intensity", "peak_ratio", "toppled");
  for (const auto& [number, run] : ordered)
    curves.line(number + 1, run->others, number_text(run->intensity), number_text(run->peak_ratio),
                run->toppled ? 1 : 0);
  write_file(folder / "incremental.csv", curves.text());
  CsvWriter fractiles;
  fractiles.line("intensity", "runs", "fractile_16", "fractile_50", "fractile_84");
  for (const auto& [intensity, ratios] : ratios_of) {
    fractiles.add(number_text(intensity), ratios.size());
    for (const double share : {0.16, 0.5, 0.84}) fractiles.add(number_text(quantile(ratios, share)));
    fractiles.end_line();
  }
  write_file(folder / "incremental-fractiles.csv", fractiles.text());
}

void write_overturning(const std::vector<Run>& runs, const std::filesystem::path& folder) {
  struct Cell {
    std::size_t runs = 0, rest = 0, rocking = 0, after_impact = 0, without_impact = 0, failed = 0;
  };
  std::map<std::pair<double, double>, Cell> cells;
  for (const Run& run : runs) {
    Cell& cell = cells[{run.period, run.intensity}];
    ++cell.runs;
    ++(run.failed        ? cell.failed
       : !run.toppled    ? (run.moved ? cell.rocking : cell.rest)
       : run.with_impact ? cell.after_impact
                         : cell.without_impact);
  }
  CsvWriter csv;
  csv.line("period", "frequency", "intensity", "runs", "rest", "rocking", "toppled_after_impact",
           "toppled_without_impact", "failed");
  for (const auto& [place, cell] : cells) {
    for (const double value : {place.first, 1 / place.first, place.second}) csv.add(number_text(value));
    csv.line(cell.runs, cell.rest, cell.rocking, cell.after_impact, cell.without_impact, cell.failed);
  }
  write_file(folder / "overturning.csv", csv.text());
}

/// "slide_rock" of slide-rock.
std::string column_of(MotionMode mode) {
  std::string column = name(mode);
  std::ranges::replace_if(
      column, [](char c) { return c == '-' || c == ' '; }, '_');
  return column;
}

void write_modes(const std::vector<Run>& runs, const std::filesystem::path& folder) {
  struct Cell {
    std::size_t runs = 0, failed = 0;
    std::map<std::string, std::size_t> onset, motion;
  };
  const auto onsets = std::span(motion_modes).first(1 + static_cast<std::size_t>(MotionMode::free_flight));
  std::map<std::pair<double, double>, Cell> cells;
  for (const Run& run : runs) {
    Cell& cell = cells[{run.intensity, run.friction}];
    ++cell.runs;
    ++(run.failed ? cell.failed : cell.onset[run.onset]);
    if (!run.failed) ++cell.motion[run.motion];
  }
  CsvWriter csv;
  csv.add("intensity", "friction", "runs");
  for (const MotionMode mode : onsets) csv.add("onset_" + column_of(mode));
  for (const MotionMode mode : motion_modes) csv.add(column_of(mode));
  csv.line("failed");
  for (auto& [place, cell] : cells) {
    csv.add(number_text(place.first), number_text(place.second), cell.runs);
    for (const MotionMode mode : onsets) csv.add(cell.onset[name(mode)]);
    for (const MotionMode mode : motion_modes) csv.add(cell.motion[name(mode)]);
    csv.line(cell.failed);
  }
  write_file(folder / "modes.csv", csv.text());
}

}  // namespace

void write_summaries(const std::filesystem::path& folder, const SummaryKeys& keys) {
  for (const char* name : {"fragility.csv", "fragility-fit.csv", "incremental.csv",
                           "incremental-fractiles.csv", "overturning.csv", "modes.csv"})
    std::filesystem::remove(folder / name);
  if (keys.intensity.empty()) return;
  std::vector<Run> runs;
  for (CsvLine line(folder / "runs.csv"); line.next();) runs.push_back(run_in(line, keys));
  if (!keys.period.empty()) return write_overturning(runs, folder);
  if (!keys.friction.empty()) return write_modes(runs, folder);
  constexpr std::size_t most_lines = 100;
  const std::map<double, double> levels = levels_of(runs, most_lines);
  write_fragility(runs, levels, folder);
  write_incremental(runs, levels, folder);
}

}  // namespace rockstack
