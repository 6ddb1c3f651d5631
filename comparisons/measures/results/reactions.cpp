#include "comparisons/measures/results/reactions.hpp"

#include <fmt/format.h>

#include <cmath>
#include <span>

#include "analytic/mechanics/pattern_solution.hpp"
#include "analytic/scene/ground/ground_motion.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/csv_writer.hpp"

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

/// The forces of one sample, from the equations of motion.
void add_reactions(const Model<double>& model, const Scene& scene, const History& history, std::size_t sample,
                   std::vector<Reaction>& rows) {
  const double time = history.times[sample];
  const Point<double> ground{acceleration(scene.horizontal, time) - gravity_of(scene).along,
                             acceleration(scene.vertical, time)};
  const PatternSolution<double> solution = accelerate(model, state_at(history, sample), ground);
  const auto& reactions = solution.reactions;
  for (int k = 0; k < history.blocks; ++k) {
    const bool carried = solution.pattern[k] == Contact::closed && reactions.normal[k] > solution.rounding[k];
    rows.push_back({reactions.normal[k], reactions.tangential[k],
                    carried ? -reactions.moment[k] / reactions.normal[k] : std::nan("")});
  }
}

}  // namespace

std::vector<Reaction> reactions_of(const Scene& scene, const History& history) {
  if (!history.reactions.empty()) return history.reactions;
  const Model<double> model = make_model<double>(scene);
  std::vector<Reaction> rows;
  rows.reserve(history.size() * static_cast<std::size_t>(history.blocks));
  for (std::size_t i = 0; i < history.size(); ++i) add_reactions(model, scene, history, i, rows);
  return rows;
}

std::string reactions_csv(const Scene& scene, const History& history) {
  const auto blocks = static_cast<std::size_t>(history.blocks);
  const std::vector<Reaction> rows = reactions_of(scene, history);
  CsvWriter csv;
  csv.line("time", numbered("normal_", history.blocks), numbered("tangential_", history.blocks),
           numbered("centre_", history.blocks));
  for (std::size_t i = 0; i < history.size(); ++i) {
    const std::span<const Reaction> row(rows.data() + i * blocks, blocks);
    csv.add(history.times[i]);
    for (const Reaction& reaction : row) csv.add(shortened(reaction.normal));
    for (const Reaction& reaction : row) csv.add(shortened(reaction.tangential));
    for (const Reaction& reaction : row)
      csv.add(std::isfinite(reaction.centre) ? shortened(reaction.centre) : "");
    csv.end_line();
  }
  return csv.text();
}

}  // namespace rockstack
