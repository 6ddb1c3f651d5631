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

void vary_motion(GroundMotion& motion, double factor) {
  for (double& sample : motion.samples) sample *= factor;
  if (motion.pulse) motion.pulse->amplitude *= factor;
  for (VelocityStep& step : motion.steps) step.size *= factor;
}

/// The largest relative change of a scene that is still hardly another.
constexpr double most_change = 0.1;

CheckedNumber changes() {
  return {"> 0, up to " + number_text(most_change), "a number", [](const Node& node) {
            if (!(number(node) > 0 && node.number <= most_change))
              throw wrong_value(node, "a number > 0 and ≤ " + number_text(most_change));
            return node.number;
          }};
}

}  // namespace

const KeysOf<Replicates> replicates_keys{
    "[draws]",
    "runs behind each number of an engine, which is their median",
    {{"runs", "5", "", whole_numbers(1, most_replicates), required_key,
      "with the one at the nominal step and scene", &Replicates::runs},
     {"most_steps",
      "3e5",
      "",
      {"a number > 0", "a number", number_above_zero},
      "any number",
      "that these runs may take together: fewer are made where steps are many, one at least",
      &Replicates::most_steps},
     {"steps", "0.03", "", numbers_between(0, 0.5), "largest relative change of the time step",
      &Replicates::steps},
     {"scene", "1e-6", "", numbers_between(0, most_change), "1e-6", "largest relative change of the scene",
      &Replicates::scene},
     {"seed", "1", "", whole_numbers(0, largest_seed), "of the changes of the scene", &Replicates::seed}}};

const KeysOf<Perturbations> perturbations_keys{
    "[perturbations]",
    "many scenes that hardly differ, for distributions",
    {{"runs", "20", "", whole_numbers(2), required_key, "number of scenes", &Perturbations::runs},
     {"size", "1e-6", "", changes(), "1e-6", "largest relative change", &Perturbations::size},
     {"seed", "1", "", whole_numbers(0, largest_seed), "of the changes", &Perturbations::seed}}};

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
    vary_motion(*motion, next_factor());
  }
  for (Push& push : result.pushes) vary_motion(push.force, next_factor());
  for (Restraint& restraint : result.restraints) {
    const double factor = next_factor();
    restraint.stiffness *= factor;
    restraint.damping *= factor;
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
  Perturbations perturbations;
  read_members(table, perturbations_keys, perturbations);
  return perturbations;
}

Replicates read_replicates(const Node& table) {
  Replicates replicates;
  read_members(table, replicates_keys, replicates);
  for (const char* key : {"most_steps", "steps"}) {  // the horizon takes the others
    const Node* node = find(table, key);
    if (node != nullptr && replicates.runs == 1)
      throw wrong_value(*node, "left out where `runs` is 1: there are no others");
  }
  return replicates;
}

}  // namespace rockstack
