#include "plots/data/impact_losses.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/measures/results/csv.hpp"

namespace rockstack::plots {
namespace {

struct MatchedTimes {
  double number, exact, engine;
};

std::vector<MatchedTimes> matched_times(const Run& run) {
  const auto columns = read_columns(run.folder / "impacts.csv", {"number", "exact_time", "engine_time"});
  std::vector<MatchedTimes> list;
  for (std::size_t i = 0; i < columns[0].size(); ++i)
    if (!std::isnan(columns[1][i]) && !std::isnan(columns[2][i]))
      list.push_back({columns[0][i], columns[1][i], columns[2][i]});
  std::stable_sort(list.begin(), list.end(),
                   [](const MatchedTimes& a, const MatchedTimes& b) { return a.exact < b.exact; });
  return list;
}

/// The sample nearest before a time. Precondition: times rise and are not empty.
double at(const std::vector<double>& times, const std::vector<double>& values, double time) {
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  return values[after == times.begin() ? 0 : static_cast<std::size_t>(after - times.begin()) - 1];
}

}  // namespace

std::vector<ImpactLoss> read_impact_losses(const Run& run) {
  const auto energy = read_columns(run.folder / "energy.csv", {"time", "exact", "balance"});
  const std::vector<double>& times = energy[0];
  const std::vector<MatchedTimes> impacts = matched_times(run);
  std::vector<ImpactLoss> losses;
  if (times.empty()) return losses;
  double exact_from = times.front(), engine_from = times.front();
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    const bool last = i + 1 == impacts.size();
    const double exact_to = last ? times.back() : (impacts[i].exact + impacts[i + 1].exact) / 2;
    const double engine_to = last ? times.back() : (impacts[i].engine + impacts[i + 1].engine) / 2;
    if (exact_to > exact_from && engine_to > engine_from)
      losses.push_back({impacts[i].number, at(times, energy[1], exact_from) - at(times, energy[1], exact_to),
                        at(times, energy[2], engine_from) - at(times, energy[2], engine_to)});
    exact_from = exact_to;
    engine_from = engine_to;
  }
  return losses;
}

}  // namespace rockstack::plots
