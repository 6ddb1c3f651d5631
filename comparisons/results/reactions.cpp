#include "comparisons/results/reactions.hpp"

#include <fmt/format.h>

#include <cmath>
#include <span>

#include "analytic/mechanics/pattern_solution.hpp"
#include "analytic/scene/ground/ground_motion.hpp"
#include "comparisons/results/csv.hpp"
#include "comparisons/results/csv_writer.hpp"

namespace rockstack {
namespace {

/// The state of a sample, whose closed interfaces have no relative motion but rounding.
State<double> state_at(const History& history, std::size_t sample) {
  using Angles = Eigen::Map<const Eigen::VectorXd>;
  const auto size = static_cast<Eigen::Index>(history.blocks);
  const Vector<double> angles = Angles(history.angles_at(sample).data(), size);
  const Vector<double> velocities = Angles(history.velocities_at(sample).data(), size);
  State<double> state{history.patterns[sample], relative(angles), relative(velocities)};
  for (int k = 0; k < history.blocks; ++k) {
    if (state.pattern[k] != Contact::closed) continue;
    state.angles[k] = 0;
    state.velocities[k] = 0;
  }
  return state;
}

/// To the digits that the accelerations behind it are good for.
std::string shortened(double value) {
  return fmt::format("{:.7g}", value);
}

/// Of a motion that is told with its reactions.
void add_told(const History& history, CsvWriter& csv) {
  const auto blocks = static_cast<std::size_t>(history.blocks);
  for (std::size_t i = 0; i < history.size(); ++i) {
    const std::span<const Reaction> row(history.reactions.data() + i * blocks, blocks);
    csv.add(history.times[i]);
    for (const Reaction& reaction : row) csv.add(shortened(reaction.normal));
    for (const Reaction& reaction : row) csv.add(shortened(reaction.tangential));
    for (const Reaction& reaction : row)
      csv.add(std::isfinite(reaction.centre) ? shortened(reaction.centre) : "");
    csv.end_line();
  }
}

}  // namespace

std::string reactions_csv(const Scene& scene, const History& history) {
  const Model<double> model = make_model<double>(scene);
  const int blocks = history.blocks;
  CsvWriter csv;
  csv.line("time", numbered("normal_", blocks), numbered("tangential_", blocks), numbered("centre_", blocks));
  if (!history.reactions.empty()) {
    add_told(history, csv);
    return csv.text();
  }
  for (std::size_t i = 0; i < history.size(); ++i) {
    const double time = history.times[i];
    const Point<double> ground{acceleration(scene.horizontal, time) - gravity_of(scene).along,
                               acceleration(scene.vertical, time)};
    const PatternSolution<double> solution = accelerate(model, state_at(history, i), ground);
    const auto& reactions = solution.reactions;
    csv.add(time);
    for (const double normal : reactions.normal) csv.add(shortened(normal));
    for (const double tangential : reactions.tangential) csv.add(shortened(tangential));
    for (int k = 0; k < blocks; ++k) {
      const bool carried =
          solution.pattern[k] == Contact::closed && reactions.normal[k] > solution.rounding[k];
      csv.add(carried ? shortened(-reactions.moment[k] / reactions.normal[k]) : "");
    }
    csv.end_line();
  }
  return csv.text();
}

}  // namespace rockstack
