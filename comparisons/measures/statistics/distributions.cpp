#include "comparisons/measures/statistics/distributions.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <numeric>

#include "analytic/scene/lists.hpp"
#include "analytic/solve.hpp"
#include "comparisons/measures/results/csv.hpp"

namespace rockstack {
namespace {

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::vector<MotionTally> tallies_in(const std::filesystem::path& run_folder) {
  const auto file = run_folder / "perturbed.csv";
  if (!std::filesystem::exists(file)) return {};
  std::vector<MotionTally> tallies = read_tallies(file);
  std::erase_if(tallies, [](const MotionTally& tally) { return tally.failed(); });
  return tallies;
}

}  // namespace

MotionTally exact_tally(const Scene& scene) {
  const History history = solve(scene, {.peaks = true});
  return {history.peaks, static_cast<int>(reported_impacts(scene, history, chatter_speed(scene)).size()),
          !reported_toppling(history).empty()};
}

MotionTally observed_tally(const Scene& scene, const History& history) {
  return {peak_angles(history),
          static_cast<int>(observed_impacts(scene, history, chatter_speed(scene)).size()),
          !observed_toppling(scene, history).empty()};
}

std::string tallies_csv(const std::vector<MotionTally>& tallies, int blocks) {
  const std::vector<std::string> no_cells(static_cast<std::size_t>(blocks) + 2);
  CsvWriter csv;
  csv.line("run", numbered("peak_", blocks), "impacts", "toppled");
  for (std::size_t run = 0; run < tallies.size(); ++run) {
    const MotionTally& tally = tallies[run];
    csv.add(run);
    if (tally.failed())
      csv.line(no_cells);
    else
      csv.line(tally.peaks, tally.impacts, tally.topples ? 1 : 0);
  }
  return csv.text();
}

std::vector<MotionTally> read_tallies(const std::filesystem::path& file) {
  std::vector<MotionTally> tallies;
  CsvLine line(file);
  const auto is_peak = [](const std::string& name) { return name.starts_with("peak_"); };
  const auto blocks = static_cast<int>(std::ranges::count_if(line.names(), is_peak));
  const CsvLine::Indices peaks = line.indices(numbered("peak_", blocks));
  while (line.next()) {
    MotionTally& tally = tallies.emplace_back();
    const std::size_t impacts = line.index("impacts");
    if (line.text(impacts).empty()) continue;
    tally.impacts = line.whole(impacts, 0, std::numeric_limits<int>::max());
    tally.topples = line.value("toppled") != 0;
    line.add(peaks, tally.peaks);
  }
  return tallies;
}

std::vector<DistributionDistance> distances(const std::vector<MotionTally>& exact,
                                            const std::vector<MotionTally>& other) {
  std::vector<DistributionDistance> list;
  const auto add = [&](const std::string& quantity, const auto& value) {
    const auto first = mapped(exact, value), second = mapped(other, value);
    list.push_back({"", "", quantity, first.size(), second.size(), mean(first), mean(second),
                    kolmogorov_smirnov(first, second)});
  };
  for (std::size_t k = 0; k < exact.front().peaks.size(); ++k)
    add(fmt::format("peak_{}", k + 1), [k](const MotionTally& tally) { return tally.peaks[k]; });
  add("impacts", [](const MotionTally& tally) { return static_cast<double>(tally.impacts); });
  add("toppled", [](const MotionTally& tally) { return tally.topples ? 1.0 : 0.0; });
  return list;
}

std::vector<DistributionDistance> distances(const std::vector<RunMetrics>& rows,
                                            const std::filesystem::path& folder) {
  std::vector<DistributionDistance> list;
  for (const RunMetrics& row : rows) {
    if (row.engine == "exact") continue;
    const auto exact = tallies_in(folder / "runs" / (row.scene + ".exact"));
    const auto other = tallies_in(folder / "runs" / row.run);
    if (exact.empty() || other.empty()) continue;
    for (DistributionDistance& one : distances(exact, other)) {
      one.scene = row.scene;
      one.run = row.run;
      list.push_back(std::move(one));
    }
  }
  return list;
}

void to_json(Json& json, const DistributionDistance& one) {
  json = {{"scene", one.scene},
          {"run", one.run},
          {"quantity", one.quantity},
          {"exact_runs", one.exact},
          {"runs", one.other},
          {"exact_mean", one.exact_mean},
          {"mean", one.other_mean},
          {"distance", one.apart.distance},
          {"critical", one.apart.critical},
          {"p_value", one.apart.p_value}};
}

void from_json(const Json& json, DistributionDistance& one) {
  const KolmogorovSmirnov apart{json.at("distance"), json.at("p_value"), json.at("critical")};
  one = {json.at("scene"), json.at("run"),        json.at("quantity"), json.at("exact_runs"),
         json.at("runs"),  json.at("exact_mean"), json.at("mean"),     apart};
}

}  // namespace rockstack
