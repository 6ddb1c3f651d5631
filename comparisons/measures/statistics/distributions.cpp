#include "comparisons/measures/statistics/distributions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <numeric>

#include "comparisons/measures/results/tables.hpp"

namespace rockstack {
namespace {

using Json = nlohmann::ordered_json;
using Value = std::function<double(const MotionTally&)>;

std::vector<double> values_of(const std::vector<MotionTally>& tallies, const Value& value) {
  std::vector<double> values;
  values.reserve(tallies.size());
  for (const MotionTally& tally : tallies) values.push_back(value(tally));
  return values;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Json json_of(const DistributionDistance& one) {
  return {{"scene", one.scene},
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

std::vector<MotionTally> tallies_in(const std::filesystem::path& run_folder) {
  const auto file = run_folder / "perturbed.csv";
  if (!std::filesystem::exists(file)) return {};
  std::vector<MotionTally> tallies = read_tallies(file);
  std::erase_if(tallies, [](const MotionTally& tally) { return tally.failed(); });
  return tallies;
}

}  // namespace

std::vector<DistributionDistance> distances(const std::vector<MotionTally>& exact,
                                            const std::vector<MotionTally>& other) {
  std::vector<DistributionDistance> list;
  const auto add = [&](const std::string& quantity, const Value& value) {
    const auto first = values_of(exact, value), second = values_of(other, value);
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

std::string distributions_csv(const std::vector<DistributionDistance>& list) {
  return csv_of(distributions_json(list));
}

Json distributions_json(const std::vector<DistributionDistance>& list) {
  Json json = Json::array();
  for (const DistributionDistance& one : list) json.push_back(json_of(one));
  return json;
}

std::vector<DistributionDistance> distances_from(const Json& list) {
  std::vector<DistributionDistance> distances;
  for (const Json& one : list) {
    const auto number = [&](const char* key) { return one.at(key).get<double>(); };
    distances.push_back({one.at("scene").get<std::string>(),
                         one.at("run").get<std::string>(),
                         one.at("quantity").get<std::string>(),
                         one.at("exact_runs").get<std::size_t>(),
                         one.at("runs").get<std::size_t>(),
                         number("exact_mean"),
                         number("mean"),
                         {number("distance"), number("p_value"), number("critical")}});
  }
  return distances;
}

std::string distribution_definition() {
  return "the same slightly perturbed scenes for every answer; distance is the Kolmogorov–Smirnov distance "
         "between the engine's distribution of the quantity and the exact one, p_value the chance of that "
         "distance "
         "or more if both were one distribution and the scenes drawn anew for each, critical the distance "
         "with a "
         "chance of 5 %. peak_k is the largest angle of block k (rad), impacts counts those above the "
         "chatter "
         "speed, toppled is 1 where a block topples";
}

}  // namespace rockstack
