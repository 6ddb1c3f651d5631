#include "comparisons/measures/results/reactions.hpp"

#include "analytic/mechanics/pattern_solution.hpp"
#include "comparisons/measures/metrics/bodies.hpp"

namespace rockstack {
namespace {

/// The state of a sample, whose closed interfaces have no relative motion but rounding.
State<double> state_at(const History& history, std::size_t sample) {
  State<double> state{history.patterns[sample], relative(vector_of(history.angles_at(sample))),
                      relative(vector_of(history.velocities_at(sample)))};
  for (int k = 0; k < history.blocks; ++k) {
    if (state.pattern[k] != Contact::closed) continue;
    state.angles[k] = 0;
    state.velocities[k] = 0;
  }
  return state;
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

}  // namespace rockstack
