#include "comparisons/measures/statistics/tally.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/impacts.hpp"
#include "comparisons/measures/metrics/toppling.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/csv_writer.hpp"

namespace rockstack {

MotionTally exact_tally(const Scene& scene) {
  const History history = solve(scene, {.peaks = true});
  return {history.peaks, static_cast<int>(reported_impacts(history, chatter_speed(scene)).size()),
          !reported_toppling(history).empty()};
}

MotionTally observed_tally(const Scene& scene, const History& history) {
  MotionTally tally{std::vector<double>(scene.blocks.size()),
                    static_cast<int>(observed_impacts(history, chatter_speed(scene)).size()),
                    !observed_toppling(scene, history).empty()};
  for (std::size_t i = 0; i < history.angles.size(); ++i) {
    double& peak = tally.peaks[i % tally.peaks.size()];
    peak = std::max(peak, std::abs(history.angles[i]));
  }
  return tally;
}

std::string tallies_csv(const std::vector<MotionTally>& tallies, int blocks) {
  const std::vector<std::string> no_cells(static_cast<std::size_t>(blocks) + 2);
  CsvWriter csv;
  csv.line("run", numbered("peak_", blocks), "impacts", "toppled");
  for (std::size_t run = 0; run < tallies.size(); ++run) {
    const MotionTally& tally = tallies[run];
    csv.add(run);
    if (tally.failed()) {
      csv.line(no_cells);
    } else {
      csv.line(tally.peaks, tally.impacts, tally.topples ? 1 : 0);
    }
  }
  return csv.text();
}

std::vector<MotionTally> read_tallies(const std::filesystem::path& file) {
  const Table table = read_table(file);
  const auto blocks =
      static_cast<int>(std::count_if(table.columns.begin(), table.columns.end(),
                                     [](const std::string& name) { return name.starts_with("peak_"); }));
  std::vector<MotionTally> tallies;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::string place = fmt::format("{}:{}", file.string(), i + 2);
    const auto cell = [&](const std::string& name) -> const std::string& {
      return table.rows[i][column(table, name, file)];
    };
    const auto value = [&](const std::string& name) { return number(cell(name), place, name); };
    MotionTally& tally = tallies.emplace_back();
    if (cell("impacts").empty()) continue;
    tally.impacts = whole_number(cell("impacts"), place, "impacts", 0, std::numeric_limits<int>::max());
    tally.topples = value("toppled") != 0;
    for (const std::string& name : numbered("peak_", blocks)) tally.peaks.push_back(value(name));
  }
  return tallies;
}

}  // namespace rockstack
