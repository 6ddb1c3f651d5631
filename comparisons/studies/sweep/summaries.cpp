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
    if (name == keys.intensity || name == keys.period || name == keys.friction || name == matrix_column)
      continue;
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

/// Runs of Saltelli's design share inputs, all but A and B.
bool is_independent(const CsvLine& line) {
  return !line.has(matrix_column) || line.text(matrix_column) == "A" || line.text(matrix_column) == "B";
}

/// The level that an intensity belongs to: its own; or where there are many, as values are drawn, the middle
/// one of a bin, each bin with as many runs as any other.
std::map<double, double> levels_of(const std::vector<Run>& runs, std::size_t most) {
  constexpr std::size_t bins = 20;
  std::vector<double> all = mapped(runs, &Run::intensity);
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
  return mapped(tallies, [](const auto& one) { return one.second; });
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
  std::ranges::stable_sort(runs, {},
                           [&](const Run& run) { return std::pair(numbers[run.others], run.intensity); });
  CsvWriter curves;
  curves.line("curve", "values", "intensity", "peak_ratio", "toppled");
  for (const Run& run : runs)
    curves.line(numbers[run.others] + 1, run.others, number_text(run.intensity), number_text(run.peak_ratio),
                run.toppled ? 1 : 0);
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

/// How many runs of each kind, by the names of columns, there are at each place of a map.
using Counts = std::map<std::vector<double>, std::map<std::string, std::size_t>>;

void write_counts(const std::filesystem::path& file, const std::vector<std::string>& axes,
                  const std::vector<std::string>& kinds, const Counts& counts) {
  CsvWriter csv;
  csv.line(axes, kinds);
  for (const auto& [place, count] : counts) {
    for (const double value : place) csv.add(number_text(value));
    for (const std::string& kind : kinds) csv.add(count.contains(kind) ? count.at(kind) : 0);
    csv.end_line();
  }
  write_file(file, csv.text());
}

void write_overturning(const std::vector<Run>& runs, const std::filesystem::path& folder) {
  Counts counts;
  for (const Run& run : runs) {
    auto& count = counts[{run.period, 1 / run.period, run.intensity}];
    ++count["runs"];
    ++count[run.failed        ? "failed"
            : !run.toppled    ? (run.moved ? "rocking" : "rest")
            : run.with_impact ? "toppled_after_impact"
                              : "toppled_without_impact"];
  }
  write_counts(folder / "overturning.csv", {"period", "frequency", "intensity"},
               {"runs", "rest", "rocking", "toppled_after_impact", "toppled_without_impact", "failed"},
               counts);
}

/// "slide_rock" of slide-rock.
std::string column_of(std::string mode) {
  std::ranges::replace_if(
      mode, [](char c) { return c == '-' || c == ' '; }, '_');
  return mode;
}

void write_modes(const std::vector<Run>& runs, const std::filesystem::path& folder) {
  Counts counts;
  for (const Run& run : runs) {
    auto& count = counts[{run.intensity, run.friction}];
    ++count["runs"];
    ++count[run.failed ? "failed" : "onset_" + column_of(run.onset)];
    if (!run.failed) ++count[column_of(run.motion)];
  }
  std::vector<std::string> kinds{"runs"};
  for (const MotionMode mode : motion_modes)
    if (mode <= MotionMode::free_flight) kinds.push_back("onset_" + column_of(name(mode)));
  for (const MotionMode mode : motion_modes) kinds.push_back(column_of(name(mode)));
  kinds.emplace_back("failed");
  write_counts(folder / "modes.csv", {"intensity", "friction"}, kinds, counts);
}

}  // namespace

void write_summaries(const std::filesystem::path& folder, const SummaryKeys& keys) {
  for (const char* name : {"fragility.csv", "fragility-fit.csv", "incremental.csv",
                           "incremental-fractiles.csv", "overturning.csv", "modes.csv", "indices.csv"})
    std::filesystem::remove(folder / name);
  if (keys.intensity.empty()) return;
  std::vector<Run> runs;
  for (CsvLine line(folder / "runs.csv"); line.next();)
    if (is_independent(line)) runs.push_back(run_in(line, keys));
  if (!keys.period.empty()) return write_overturning(runs, folder);
  if (!keys.friction.empty()) return write_modes(runs, folder);
  constexpr std::size_t most_lines = 100;
  const std::map<double, double> levels = levels_of(runs, most_lines);
  write_fragility(runs, levels, folder);
  write_incremental(runs, levels, folder);
}

}  // namespace rockstack
