#include "comparisons/measures/metrics/energy.hpp"

#include <algorithm>

#include "comparisons/measures/metrics/centres.hpp"

namespace rockstack {

std::vector<double> energies(const Scene& scene, const History& history) {
  const Stack<double> stack = make_stack<double>(scene);
  const Gravity gravity = gravity_of(scene);
  double at_rest = 0, height = 0;
  for (const Block& block : scene.blocks) {
    at_rest += block.mass * (gravity.across * (height + block.half_height + block.offset_y) -
                             gravity.along * block.offset_x);
    height += 2 * block.half_height;
  }
  std::vector<double> list;
  list.reserve(history.size());
  for (std::size_t i = 0; i < history.size(); ++i) {
    const Vector<double> velocities = Vector<double>::Map(history.velocities_at(i).data(), stack.size());
    const auto [places, speeds] = centres_at(stack, history, i);
    double energy = -at_rest;
    for (int k = 0; k < stack.size(); ++k) {
      energy += 0.5 * stack.mass[k] * speeds.col(k).squaredNorm() +
                0.5 * stack.inertia[k] * velocities[k] * velocities[k] +
                stack.mass[k] * gravity.across * places(1, k) - stack.mass[k] * gravity.along * places(0, k);
    }
    list.push_back(energy);
  }
  return list;
}

double energy_scale(const Scene& scene) {
  double sum = 0, height = 0;
  for (const Block& block : scene.blocks) {
    sum += block.mass * scene.gravity * (height + block.half_height + block.offset_y);
    height += 2 * block.half_height;
  }
  return sum;
}

std::vector<double> energy_balance(const std::vector<double>& energy, const std::vector<double>& input,
                                   const std::vector<double>& elastic) {
  std::vector<double> balance;
  balance.reserve(energy.size());
  for (std::size_t i = 0; i < energy.size(); ++i) balance.push_back(energy[i] - input[i] + elastic[i]);
  return balance;
}

double largest_gain(const std::vector<double>& energy) {
  double gain = 0, least = energy.front();
  for (const double now : energy) {
    least = std::min(least, now);
    gain = std::max(gain, now - least);
  }
  return gain;
}

}  // namespace rockstack
