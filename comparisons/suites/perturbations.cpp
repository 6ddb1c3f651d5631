#include "comparisons/suites/perturbations.hpp"

#include "comparisons/measures/statistics/draws.hpp"

namespace rockstack {
namespace {

void scale(GroundMotion& motion, double factor) {
  for (double& sample : motion.samples) sample *= factor;
  if (motion.pulse) motion.pulse->amplitude *= factor;
}

void scale(std::vector<double>& values, double factor) {
  for (double& value : values) value *= factor;
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
  scale(result.initial.angles, start);
  scale(result.initial.velocities, start);
  scale(result.initial.slip_velocities, start);
  scale(result.horizontal, next_factor());
  scale(result.vertical, next_factor());
  return result;
}

Scene drawn_scene(const Scene& scene, const Draws& draws, int draw) {
  return draw == 0 ? scene : perturbed(scene, {draws.runs, draws.scene, draws.seed}, draw);
}

double drawn_step(double dt, const Draws& draws, int draw) {
  if (draw == 0) return dt;
  const double place = (2.0 * draw - 1) / (draws.runs - 1) - 1;
  return dt * (1 + draws.steps * place);
}

}  // namespace rockstack
