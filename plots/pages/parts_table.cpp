#include "plots/pages/sections.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "comparisons/measures/statistics/samples.hpp"
#include "plots/data/selection.hpp"
#include "plots/pages/html.hpp"
#include "plots/pages/page_parts.hpp"

namespace rockstack::plots {
namespace {

/// Per cent, without a sign of zero.
double percent_of(double share) {
  return std::round(100 * share) + 0.0;
}

std::string size_and_share(const std::optional<double>& size, const std::optional<double>& share) {
  const std::string text = fmt::format("{:.2g}", value_of(size));
  return share ? fmt::format("{} ({:.0f} %)", text, percent_of(*share)) : text;
}

std::string cell_of(const std::optional<double>& value) {
  return value ? fmt::format("{:.2g}", *value) : "";
}

std::string sentence(const std::vector<Run>& runs) {
  std::vector<double> model, softness, step;
  for (const Run& run : runs) {
    if (!run.step_share) continue;
    model.push_back(value_of(run.model_share));
    softness.push_back(value_of(run.softness_share));
    step.push_back(*run.step_share);
  }
  if (step.empty()) return "";
  return element(
      "p", fmt::format("In the median of {} runs the contact model makes {:.0f} % of the difference, contact "
                       "softness {:.0f} % and the time step {:.0f} %.",
                       step.size(), percent_of(median(model)), percent_of(median(softness)),
                       percent_of(median(step))));
}

}  // namespace

std::string parts_table(const Comparison& comparison, const std::string& scene) {
  const std::vector<std::string> columns{"run",
                                         "RMS difference (rad)",
                                         "contact model (share)",
                                         "contact softness (share)",
                                         "time step (share)",
                                         "stiffness of a point (N/m)",
                                         "damping ratio",
                                         "restitution",
                                         "spring softer by, then extrapolated"};
  std::vector<Run> runs = done_runs(comparison, scene);
  std::erase_if(runs, [](const Run& run) { return !run.step_difference; });
  if (runs.empty()) return "";
  std::string rows;
  for (const Run& run : runs)
    rows += table_row(columns, {run_label(run), fmt::format("{:.2g}", value_of(run.rms_angle_difference)),
                                size_and_share(run.model_difference, run.model_share),
                                size_and_share(run.softness_difference, run.softness_share),
                                size_and_share(run.step_difference, run.step_share),
                                cell_of(run.contact_stiffness), cell_of(run.contact_damping_ratio),
                                cell_of(run.contact_restitution), cell_of(run.spring_factor)});
  return element("h3", "What the differences are made of") + sentence(runs) +
         element("div", table(columns, rows), " class=\"statements\"") + "\n";
}

}  // namespace rockstack::plots
