#include "plots/data/impact_losses.hpp"

#include <algorithm>

#include "plots/data/run_files.hpp"

namespace rockstack::plots {
namespace {

std::vector<AlignedImpact> matched_impacts(const Run& run) {
  std::vector<AlignedImpact> list = *impacts_of(run);
  std::erase_if(list, [](const AlignedImpact& one) { return !one.exact || !one.engine || !one.number; });
  std::stable_sort(list.begin(), list.end(),
                   [](const AlignedImpact& a, const AlignedImpact& b) { return *a.exact < *b.exact; });
  return list;
}

/// The sample nearest before a time. Precondition: times rise and are not empty.
double at(const std::vector<double>& times, const std::vector<double>& values, double time) {
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  return values[after == times.begin() ? 0 : static_cast<std::size_t>(after - times.begin()) - 1];
}

}  // namespace

std::vector<ImpactLoss> impact_losses(const Run& run) {
  const auto energy = energies_of(run);
  const std::vector<double>& times = energy->times;
  const std::vector<AlignedImpact> impacts = matched_impacts(run);
  std::vector<ImpactLoss> losses;
  if (times.empty()) return losses;
  double exact_from = times.front(), engine_from = times.front();
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    const bool last = i + 1 == impacts.size();
    const double exact_to = last ? times.back() : (*impacts[i].exact + *impacts[i + 1].exact) / 2;
    const double engine_to = last ? times.back() : (*impacts[i].engine + *impacts[i + 1].engine) / 2;
    if (exact_to > exact_from && engine_to > engine_from)
      losses.push_back({static_cast<double>(*impacts[i].number),
                        at(times, energy->exact, exact_from) - at(times, energy->exact, exact_to),
                        at(times, energy->balance, engine_from) - at(times, energy->balance, engine_to)});
    exact_from = exact_to;
    engine_from = engine_to;
  }
  return losses;
}

}  // namespace rockstack::plots
