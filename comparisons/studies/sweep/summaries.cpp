#include "comparisons/studies/sweep/sweep.hpp"

#include <unordered_map>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/long_table.hpp"
#include "comparisons/measures/statistics/fragility.hpp"
#include "comparisons/measures/statistics/samples.hpp"
#include "comparisons/studies/sweep/counted_rows.hpp"
#include "comparisons/studies/sweep/map_summaries.hpp"

namespace rockstack {
namespace {

enum class End : char { stands, topples, fails };

/// What curves over an intensity take from the runs, a row each.
struct CurveRuns {
  std::vector<double> intensities, peak_ratios;
  std::vector<End> ends;
  std::vector<std::size_t> numbers;
  std::vector<std::uint64_t> others;  ///< checksums of all other varied values
};

constexpr std::size_t first_other = 5;  // behind the columns that curve_runs() reads of each run

std::vector<std::string> curve_columns(const std::filesystem::path& runs, const std::string& intensity) {
  std::vector<std::string> names{"run", "status", intensity, "toppled", "peak_ratio"};
  for (const std::string& name : varied_columns(runs))
    if (name != intensity && name != matrix_column) names.push_back(name);
  return names;
}

/// All other varied values of a run, as "key=value".
std::string others_in(const TableRows& row, const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t c = first_other; c < names.size(); ++c) {
    if (!text.empty()) text += ", ";
    text += names[c];
    text += "=";
    text += row.text(c);
  }
  return text;
}

CurveRuns curve_runs(const std::filesystem::path& file, const std::vector<std::string>& names) {
  CurveRuns runs;
  each_counted(file, names, [&](const TableRows& row) {
    const bool failed = row.text(1) == "failed";
    runs.numbers.push_back(static_cast<std::size_t>(row.value(0)));
    runs.intensities.push_back(row.value(2));
    runs.ends.push_back(failed ? End::fails : row.value(3) > 0 ? End::topples : End::stands);
    runs.peak_ratios.push_back(failed ? 0 : row.value(4));
    runs.others.push_back(checksum(others_in(row, names)));
  });
  return runs;
}

/// The level that an intensity belongs to: its own; or where there are more than `most`, as values are drawn,
/// the middle one of a bin, each bin with as many runs as any other.
class Levels {
 public:
  Levels(std::vector<double> all, std::size_t most) {
    constexpr std::size_t bins = 20;
    std::ranges::sort(all);
    std::ranges::unique_copy(all, std::back_inserter(intensities_));
    levels_ = intensities_;
    if (levels_.size() <= most) return;
    std::size_t place = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i] != intensities_[place]) ++place;
      levels_[place] = all[(2 * (i * bins / all.size()) + 1) * all.size() / (2 * bins)];
    }
  }

  double of(double intensity) const {
    const auto found = std::ranges::lower_bound(intensities_, intensity);
    return levels_[static_cast<std::size_t>(found - intensities_.begin())];
  }

  /// What came of the runs at each.
  std::vector<Level> tallied(const CurveRuns& runs) const {
    std::vector<Level> tallies;
    for (const double level : levels_)
      if (tallies.empty() || tallies.back().intensity != level) tallies.push_back({level});
    for (std::size_t i = 0; i < runs.ends.size(); ++i) {
      Level& level = *std::ranges::lower_bound(tallies, of(runs.intensities[i]), {}, &Level::intensity);
      ++(runs.ends[i] == End::fails ? level.failed : level.runs);
      if (runs.ends[i] == End::topples) ++level.toppled;
    }
    return tallies;
  }

 private:
  std::vector<double> intensities_, levels_;  ///< each once, rising; the level of each
};

/// The curve is fitted to all intensities as they are, whatever the levels of the table.
void write_fragility(const CurveRuns& runs, const Levels& levels, const std::filesystem::path& folder) {
  const auto fit = fit_fragility(Levels(runs.intensities, runs.intensities.size()).tallied(runs));
  CsvWriter csv;
  csv.line("intensity", "runs", "toppled", "failed", "fraction", "lower", "upper", "fitted");
  for (const Level& level : levels.tallied(runs)) {
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

/// The curve of each run that did not fail, numbered in the order of their first runs, and how many there
/// are.
struct CurveNumbers {
  std::vector<std::uint32_t> of_runs;
  std::size_t curves = 0, runs = 0;
};

CurveNumbers numbered_curves(const CurveRuns& runs) {
  CurveNumbers numbers{std::vector<std::uint32_t>(runs.ends.size())};
  std::unordered_map<std::uint64_t, std::uint32_t> known;
  for (std::size_t i = 0; i < runs.ends.size(); ++i) {
    if (runs.ends[i] == End::fails) continue;
    ++numbers.runs;
    numbers.of_runs[i] = known.emplace(runs.others[i], known.size()).first->second;
  }
  numbers.curves = known.size();
  return numbers;
}

void write_fractiles(const CurveRuns& runs, const Levels& levels, const std::filesystem::path& file) {
  std::map<double, std::vector<double>> ratios_of;
  for (std::size_t i = 0; i < runs.ends.size(); ++i)
    if (runs.ends[i] != End::fails)
      ratios_of[levels.of(runs.intensities[i])].push_back(
          runs.ends[i] == End::topples ? std::numeric_limits<double>::infinity() : runs.peak_ratios[i]);
  CsvWriter fractiles;
  fractiles.line("intensity", "runs", "fractile_16", "fractile_50", "fractile_84");
  for (const auto& [intensity, ratios] : ratios_of) {
    fractiles.add(number_text(intensity), ratios.size());
    for (const double share : {0.16, 0.5, 0.84}) fractiles.add(number_text(quantile(ratios, share)));
    fractiles.end_line();
  }
  write_file(file, fractiles.text());
}

/// The other varied values of each curve, by its number.
std::vector<std::string> values_of_curves(const std::filesystem::path& file,
                                          const std::vector<std::string>& names,
                                          const CurveNumbers& numbers) {
  std::vector<std::string> values(numbers.curves);
  std::size_t i = 0;
  each_counted(file, names, [&](const TableRows& row) {
    std::string& text = values[numbers.of_runs[i++]];
    if (text.empty() && row.text(1) != "failed") text = others_in(row, names);
  });
  return values;
}

void write_curves(const CurveRuns& runs, const CurveNumbers& numbers, const std::filesystem::path& file,
                  const FileColumn& values_or_run, const std::vector<std::uint32_t>& order) {
  const auto number = [&](const std::vector<double>& values) {
    return FileColumn::Number([&](std::size_t row) { return values[order[row]]; });
  };
  write_table(file,
              {{"curve", FileColumn::Count([&](std::size_t row) { return numbers.of_runs[order[row]] + 1; })},
               values_or_run,
               {"intensity", number(runs.intensities)},
               {"peak_ratio", number(runs.peak_ratios)},
               {"toppled", FileColumn::Count([&](std::size_t row) {
                  return runs.ends[order[row]] == End::topples ? 1 : 0;
                })}},
              order.size());
}

void write_incremental(const CurveRuns& runs, const Levels& levels, const std::filesystem::path& folder,
                       const std::vector<std::string>& names) {
  const CurveNumbers numbers = numbered_curves(runs);
  if (numbers.curves == numbers.runs) return;
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < runs.ends.size(); ++i)
    if (runs.ends[i] != End::fails) order.push_back(i);
  std::ranges::stable_sort(
      order, {}, [&](std::uint32_t i) { return std::pair(numbers.of_runs[i], runs.intensities[i]); });
  const std::filesystem::path file = folder / "runs.csv";
  if (table_file(file) == file) {
    const std::vector<std::string> values = values_of_curves(file, names, numbers);
    const FileColumn::Text text = [&](std::size_t row) { return values[numbers.of_runs[order[row]]]; };
    write_curves(runs, numbers, folder / "incremental.csv", {"values", text}, order);
  } else {
    const FileColumn::Count run = [&](std::size_t row) { return runs.numbers[order[row]]; };
    write_curves(runs, numbers, folder / "incremental.npz", {"run", run}, order);
  }
  write_fractiles(runs, levels, folder / "incremental-fractiles.csv");
}

}  // namespace

void write_summaries(const std::filesystem::path& folder, const SummaryKeys& keys) {
  for (const char* name : {"fragility.csv", "fragility-fit.csv", "incremental.csv", "incremental.npz",
                           "incremental-fractiles.csv", "overturning.csv", "overturning.npz", "modes.csv",
                           "modes.npz", "indices.csv"})
    std::filesystem::remove(folder / name);
  if (keys.intensity.empty()) return;
  const std::filesystem::path runs = folder / "runs.csv";
  const std::string ending = table_file(runs).extension();
  if (!keys.period.empty()) return write_overturning(runs, keys, folder / ("overturning" + ending));
  if (!keys.friction.empty()) return write_modes(runs, keys, folder / ("modes" + ending));
  constexpr std::size_t most_lines = 100;
  const std::vector<std::string> names = curve_columns(runs, keys.intensity);
  const CurveRuns counted = curve_runs(runs, names);
  const Levels levels(counted.intensities, most_lines);
  write_fragility(counted, levels, folder);
  write_incremental(counted, levels, folder, names);
}

}  // namespace rockstack
