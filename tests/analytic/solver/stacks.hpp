#pragma once

#include <random>
#include <string>

#include "analytic/mechanics/dynamics.hpp"
#include "analytic/solve.hpp"

namespace rockstack::testing {

/// Seeded draws.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : generator_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }
  int below(int count) { return static_cast<int>(generator_() % static_cast<std::uint64_t>(count)); }
  bool coin() { return below(2) == 1; }

 private:
  std::mt19937_64 generator_;
};

/// A uniform block of full width and height in m, 2500 kg/m³ and 1 m deep.
Block block(double width, double height);

/// A scene with these blocks, released at rest at these angles, for `duration` s.
Scene released(std::vector<Block> blocks, std::vector<double> angles, double duration);

/// The free rocking example of Spanos et al. 2001, Fig. 18.
Scene paper_example();

/// Blocks of half-height e^±1, b/h in 0.1 … 1.2 and mass 10^±1.5, so mass ratios up to 10³; no motion.
Scene random_stack(Draw& draw, int size);

/// A random stack that moves: initial angles (some equal, so closed), velocities, law, and if `shaken` ground
/// motion of 0.1 … 2 g, on both axes or one.
Scene random_scene(Draw& draw, int size, bool shaken);

/// Replaces the ground motion by one of 0.1 … 2 g along each axis (a third of that vertically): none, samples
/// or any pulse.
void shake(Draw& draw, Scene& scene);

/// A random stack of one to four blocks, by its seed: for one seed in four it moves freely, else its ground
/// moves.
Scene seeded_scene(std::uint64_t seed);

/// A state of random contacts: closed, or open by up to 0.4 rad at up to 1 rad/s.
template <class Real>
State<Real> random_state(Draw& draw, int size) {
  State<Real> state{closed_pattern(size), Vector<Real>::Zero(size), Vector<Real>::Zero(size)};
  for (int k = 0; k < size; ++k) {
    state.pattern[k] = contact_of(draw.below(3) - 1);
    state.angles[k] = sign(state.pattern[k]) * draw.between(0.001, 0.4);
    if (state.pattern[k] != Contact::closed) state.velocities[k] = draw.between(-1, 1);
  }
  return state;
}

/// Energy above that of the stack at rest, J, on one side of an event.
template <class Real>
Real energy_above_rest(const Scene& scene, const Pattern& pattern, const std::vector<Real>& angles,
                       const std::vector<Real>& velocities) {
  const auto model = make_model<Real>(scene);
  State<Real> state{pattern, model.stack.mass, model.stack.mass};
  for (int k = 0; k < pattern.size; ++k) {
    state.angles[k] = angles[static_cast<std::size_t>(k)];
    state.velocities[k] = velocities[static_cast<std::size_t>(k)];
  }
  state.angles = relative(state.angles);
  state.velocities = relative(state.velocities);
  const Vector<Real> still = 0 * model.stack.mass;
  return energy(model, state) - energy(model, State<Real>{closed_pattern(pattern.size), still, still});
}

/// One line an event, for messages.
std::string listing(const History& history);

}  // namespace rockstack::testing
