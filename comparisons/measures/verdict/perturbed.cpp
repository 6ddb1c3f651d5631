#include "comparisons/measures/verdict/perturbed.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/measures/verdict/outcome.hpp"

namespace rockstack {
namespace {

std::string phrase_of(const std::string& run, const std::vector<RunMetrics>& rows) {
  const auto row =
      std::find_if(rows.begin(), rows.end(), [&](const RunMetrics& one) { return one.run == run; });
  if (row == rows.end() || !is_engine(*row)) return run;
  return fmt::format("{} at {}", set_name(*row), quantity_text(*row->dt, "s"));
}

}  // namespace

std::string toppling_sentence(const std::vector<DistributionDistance>& distances,
                              const std::vector<RunMetrics>& rows, const std::string& scene) {
  std::vector<std::string> engines;
  double exact = 0, most = 0;
  std::size_t count = 0;
  for (const DistributionDistance& one : distances) {
    if (one.scene != scene || one.quantity != "toppled") continue;
    exact = one.exact_mean, count = one.exact;
    most = std::max({most, one.exact_mean, one.other_mean});
    engines.push_back(fmt::format("{:.3g} % with {}{}", 100 * one.other_mean, phrase_of(one.run, rows),
                                  one.apart.distance > one.apart.critical ? ", more than chance apart" : ""));
  }
  if (most == 0) return "";
  return fmt::format("Of {} scenes that differ a little from {} {:.3g} % topple exactly, and {}.", count,
                     scene, 100 * exact, joined(engines));
}

std::string convergence_sentence(const std::vector<SeriesFit>& fits, const std::string& scene) {
  std::vector<double> orders;
  for (const SeriesFit& one : fits)
    if (one.scene == scene && one.fit.holds() && one.quantity == "first_impact_time_difference")
      orders.push_back(one.fit.order.value);
  if (orders.empty()) return "";
  std::sort(orders.begin(), orders.end());
  return fmt::format(
      "The error of the first impact falls with the step to the power {:.2f} ({} of {:.2f} to {:.2f}).",
      orders[(orders.size() - 1) / 2], counted(orders.size(), "fit"), orders.front(), orders.back());
}

}  // namespace rockstack
