#include "plots/pages/motion_data.hpp"

#include <nlohmann/json.hpp>

#include "comparisons/measures/metrics/impacts.hpp"
#include "comparisons/measures/results/reactions.hpp"

namespace rockstack::plots {

nlohmann::ordered_json stage_of(const Scene& scene, const History& history) {
  PlayerScene stage{scene.title, scene.blocks, scene.gravity, {}, {}, {}};
  if (leaves_pivots(scene.law)) stage.friction = friction_of(scene);
  if (!scene.horizontal.empty()) {
    stage.ground_times = history.times;
    for (const double time : history.times) stage.ground.push_back(acceleration(scene.horizontal, time));
  }
  return player_scene(stage, player_events(history, chatter_speed(scene)));
}

InterfaceForces forces_of(const Scene& scene, const History& history) {
  InterfaceForces forces{history.times, {}};
  const auto blocks = static_cast<std::size_t>(history.blocks);
  const std::vector<Reaction> reactions = reactions_of(scene, history);
  forces.rows.reserve(3 * reactions.size());
  for (std::size_t from = 0; from < reactions.size(); from += blocks)
    for (const auto part : {&Reaction::normal, &Reaction::tangential, &Reaction::centre})
      for (std::size_t k = 0; k < blocks; ++k) forces.rows.push_back(reactions[from + k].*part);
  return forces;
}

}  // namespace rockstack::plots
