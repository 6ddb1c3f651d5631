#include "comparisons/studies/lessons/energies.hpp"

namespace rockstack {
namespace {

Vector<double> vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// Velocities of centres and rotations in a pattern, at absolute angles.
Motion<double> motion_of(const Stack<double>& stack, const Pattern& pattern, const Event& event,
                         const std::vector<double>& velocities) {
  const Vector<double> rates = vector_of(velocities);
  return {centre_velocities(make_chain(stack, pattern, vector_of(event.angles)), rates), rates};
}

double kinetic_energy(const Stack<double>& stack, const Motion<double>& motion) {
  double sum = 0;
  for (int k = 0; k < stack.size(); ++k)
    sum += (stack.mass[k] * motion.centre.col(k).squaredNorm() +
            stack.inertia[k] * motion.rotation[k] * motion.rotation[k]) /
           2;
  return sum;
}

State<double> state_of(const Pattern& pattern, const std::vector<double>& angles,
                       const std::vector<double>& velocities) {
  return {pattern, relative(vector_of(angles)), relative(vector_of(velocities))};
}

}  // namespace

ImpactEnergies impact_energies(const Scene& scene, const Event& impact) {
  const Stack<double> stack = make_stack<double>(scene);
  const Motion<double> before = motion_of(stack, impact.from, impact, impact.before);
  const Motion<double> after = motion_of(stack, impact.to, impact, impact.after);
  const Motion<double> jump{after.centre - before.centre, after.rotation - before.rotation};
  return {kinetic_energy(stack, before), kinetic_energy(stack, after), kinetic_energy(stack, jump)};
}

Impact<double> impact_of(const Event& event) {
  const auto index = static_cast<std::size_t>(event.interface) - 1;
  Impact<double> impact{state_of(event.from, event.angles, event.before), {}};
  impact.impacting.set(index);
  for (int k = 0; k < event.from.size; ++k)
    if (event.from[k] == Contact::closed) impact.before.angles[k] = impact.before.velocities[k] = 0;
  impact.before.angles[event.interface - 1] = 0;
  return impact;
}

double energy_above_rest(const Scene& scene, const Pattern& pattern, const std::vector<double>& angles,
                         const std::vector<double>& velocities) {
  const Model<double> model = make_model<double>(scene);
  const std::vector<double> none(angles.size(), 0);
  return energy(model, state_of(pattern, angles, velocities)) -
         energy(model, state_of(closed_pattern(pattern.size), none, none));
}

}  // namespace rockstack
