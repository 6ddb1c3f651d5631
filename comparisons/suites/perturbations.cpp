#include "comparisons/suites/suite.hpp"

#include <fmt/format.h>

#include "comparisons/measures/statistics/draws.hpp"
#include "comparisons/suites/suite_keys.hpp"

namespace rockstack {
namespace {

/// Lets blocks in flight, from the lowest one with a gap up, start otherwise by amounts: a factor leaves zero
/// as it is, and with it a landing on both corners at once. `next` gives shares of a scale.
template <class Next>
void vary_flight(Scene& scene, const Next& next) {
  InitialState& initial = scene.initial;
  const auto first = std::ranges::find_if(initial.gaps, [](double gap) { return gap > 0; });
  if (first == initial.gaps.end()) return;
  const double rate = std::sqrt(scene.gravity / stack_height(scene));
  for (auto* values : {&initial.slip_velocities, &initial.gap_velocities})
    values->resize(scene.blocks.size());
  for (auto k = static_cast<std::size_t>(first - initial.gaps.begin()); k < scene.blocks.size(); ++k) {
    const double angle = slenderness(scene, static_cast<int>(k)), length = 2 * scene.blocks[k].half_height;
    initial.angles[k] += next() * angle;
    initial.velocities[k] += next() * angle * rate;
    initial.gaps[k] += std::abs(next()) * length;
    initial.slip_velocities[k] += next() * length * rate;
    initial.gap_velocities[k] += next() * length * rate;
  }
}

}  // namespace

Scene perturbed(const Scene& scene, const Perturbations& perturbations, int run) {
  std::uint32_t key = 0;
  const auto next_factor = [&] {
    const DrawIndex index{perturbations.seed, static_cast<std::uint64_t>(run), key++};
    return 1 + draw({Distribution::Kind::uniform, -perturbations.size, perturbations.size}, index);
  };
  Scene result = scene;
  for (Block& block : result.blocks) {
    block.half_width *= next_factor();
    block.half_height *= next_factor();
  }
  const double start = next_factor();
  InitialState& initial = result.initial;
  for (std::vector<double>* values : {&initial.angles, &initial.velocities, &initial.slip_velocities,
                                      &initial.gaps, &initial.gap_velocities})
    for (double& value : *values) value *= start;
  for (GroundMotion* motion : {&result.horizontal, &result.vertical}) {
    const double factor = next_factor();
    for (double& sample : motion->samples) sample *= factor;
    if (motion->pulse) motion->pulse->amplitude *= factor;
  }
  vary_flight(result, [&] { return next_factor() - 1; });
  return result;
}

Scene replicate_scene(const Scene& scene, const Replicates& replicates, int replicate) {
  return replicate == 0 ? scene
                        : perturbed(scene, {replicates.runs, replicates.scene, replicates.seed}, replicate);
}

double replicate_step(double dt, const Replicates& replicates, int replicate) {
  if (replicate == 0) return dt;
  const double place = (2.0 * replicate - 1) / (replicates.runs - 1) - 1;
  return dt * (1 + replicates.steps * place);
}

Perturbations read_perturbations(const Node& table) {
  require_table(table, perturbations_keys);
  Perturbations perturbations;
  perturbations.runs = static_cast<int>(whole_number(required(table, "runs", "a whole number ≥ 2"), 2));
  if (const Node* node = find(table, "size")) perturbations.size = number_above_zero(*node);
  if (perturbations.size > 0.1) throw wrong_value(*find(table, "size"), "a number > 0 and ≤ 0.1");
  if (const Node* node = find(table, "seed"))
    perturbations.seed = static_cast<std::uint64_t>(whole_number(*node, 0, largest_seed));
  return perturbations;
}

Replicates read_replicates(const Node& table) {
  require_table(table, replicates_keys);
  const auto share = [&](const char* key, double& value, double most) {
    value = number_or(table, key, value);
    if (!(value >= 0 && value <= most))
      throw wrong_value(*find(table, key), fmt::format("a number from 0 to {}", most));
  };
  Replicates replicates;
  replicates.runs =
      static_cast<int>(whole_number(required(table, "runs", "a whole number ≥ 1"), 1, most_replicates));
  for (const char* key : {"most_steps", "steps"}) {  // the horizon takes the others
    const Node* node = find(table, key);
    if (node != nullptr && replicates.runs == 1)
      throw wrong_value(*node, "left out where `runs` is 1: there are no others");
  }
  if (const Node* node = find(table, "most_steps")) replicates.most_steps = number_above_zero(*node);
  share("steps", replicates.steps, 0.5);
  share("scene", replicates.scene, 0.1);
  if (const Node* node = find(table, "seed"))
    replicates.seed = static_cast<std::uint64_t>(whole_number(*node, 0, largest_seed));
  return replicates;
}

}  // namespace rockstack
