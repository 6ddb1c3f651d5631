#include "tests/analytic/extremes/laws.hpp"

#include <algorithm>
#include <cmath>

#include "tests/analytic/reference/quad.hpp"
#include "tests/analytic/solver/stacks.hpp"

namespace rockstack::testing {
namespace {

using Values = Vector<Quad>;

Values relative_values(const std::vector<double>& absolute_values, const Pattern& pattern) {
  Values values(static_cast<Eigen::Index>(absolute_values.size()));
  std::copy(absolute_values.begin(), absolute_values.end(), values.begin());
  values = relative(values);
  for (int k = 0; k < pattern.size; ++k)
    if (pattern[k] == Contact::closed) values[k] = 0;
  return values;
}

/// The energies of one side of an event, J, above the stack at rest.
struct Energies {
  Quad kinetic, potential;
  Quad rounding;  ///< what 113 bits leave of the whole stack's energies when one is taken from another
};

Energies energies(const Model<Quad>& model, const Pattern& pattern, const std::vector<double>& angles,
                  const std::vector<double>& velocities) {
  const State<Quad> state{pattern, relative_values(angles, pattern), relative_values(velocities, pattern)};
  const Values still = Values::Zero(pattern.size);
  const Quad standing = energy(model, {pattern, state.angles, still});
  return {energy(model, state) - standing,
          standing - energy(model, {closed_pattern(pattern.size), still, still}),
          std::numeric_limits<Quad>::epsilon() * abs(standing)};
}

/// The least share of a diagonal entry of the mass matrix that elimination leaves.
Quad least_share(const Model<Quad>& model, const Pattern& pattern, const std::vector<double>& angles) {
  const auto chain = make_chain(model.stack, pattern, directions_at(model, relative_values(angles, pattern)));
  Matrix<Quad> mass = mass_matrix(model.stack, chain);
  const Values entries = mass.diagonal();
  Quad least = 1;
  for (Eigen::Index k = 0; k < mass.rows(); ++k) {
    if (pattern[static_cast<int>(k)] == Contact::closed) continue;
    least = std::min<Quad>(least, mass(k, k) / entries[k]);
    for (Eigen::Index i = k + 1; i < mass.rows(); ++i) {
      const Quad factor = mass(i, k) / mass(k, k);
      for (Eigen::Index j = k + 1; j < mass.rows(); ++j) mass(i, j) -= factor * mass(k, j);
    }
  }
  return least;
}

/// Two in fifty of thousands of events are looked at.
bool passed_over(std::size_t event) {
  return event >= 400 && event % 50 > 1;
}

bool all_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

std::string broken(const Scene& scene, const History& history) {
  double time = 0;
  for (const Event& event : history.events) {
    if (!std::isfinite(event.time) || !all_finite(event.angles) || !all_finite(event.before) ||
        !all_finite(event.after))
      return "an event holds a number that is none";
    if (event.time < time) return "an event lies before the one it follows";
    time = event.time;
  }
  if (time > scene.duration * (1 + 1e-12)) return "an event lies after the end";
  if (!all_finite(history.angles) || !all_finite(history.velocities)) return "a sample is no number";
  const bool toppled = !history.events.empty() && history.events.back().kind == EventKind::topple;
  if (!toppled && (history.times.empty() || history.times.back() < scene.duration * (1 - 1e-12)))
    return "the motion ends before its duration";
  for (std::size_t i = 0; i < history.size(); ++i) {
    const auto angles = history.angles_at(i);
    for (int k = 0; k < history.blocks; ++k) {
      const auto block = static_cast<std::size_t>(k);
      const double below = k > 0 ? angles[block - 1] : 0;
      const double relative_angle = angles[block] - below;
      const double rounding = 4e-16 * std::max({std::abs(angles[block]), std::abs(below), 1.0});
      const bool inside = history.patterns[i][k] == Contact::closed
                              ? std::abs(relative_angle) > rounding
                              : sign(history.patterns[i][k]) * relative_angle < -rounding;
      if (inside) return "a block lies in the one below, or a closed interface is open";
    }
  }
  return {};
}

Quad least_share(const Model<Quad>& model, const Event& event) {
  return std::min(least_share(model, event.from, event.angles), least_share(model, event.to, event.angles));
}

}  // namespace

Breaches breaches(const Scene& scene, const History& history) {
  Breaches found;
  found.fault = broken(scene, history);
  found.events = history.events.size();
  if (!found.fault.empty()) return found;
  const auto model = make_model<Quad>(scene);
  const bool free =
      scene.horizontal.empty() && scene.vertical.empty() && scene.equations == Equations::nonlinear;
  Quad left{};  // total energy after the last event
  bool flying = false;
  for (std::size_t i = 0; i < history.events.size(); ++i) {
    if (passed_over(i)) {
      flying = false;
      continue;
    }
    const Event& event = history.events[i];
    const Energies before = energies(model, event.from, event.angles, event.before);
    const Energies after = energies(model, event.to, event.angles, event.after);
    const Quad rounding = std::numeric_limits<double>::epsilon() / least_share(model, event);
    const Quad gain = after.kinetic - before.kinetic;
    if (gain > 0)
      found.impact_gain = std::max(found.impact_gain,
                                   static_cast<double>(gain / (before.kinetic * rounding + before.rounding)));
    const Quad drift = abs(before.kinetic + before.potential - left);
    const Quad scale = (before.kinetic + abs(before.potential) + abs(left)) * rounding + before.rounding;
    if (free && flying && drift > 0)
      found.flight_drift = std::max(found.flight_drift, static_cast<double>(drift / scale));
    left = after.kinetic + after.potential;
    flying = true;
  }
  return found;
}

double weight_of_rounding(const Scene& scene, const History& history) {
  double height = 0;
  double radius = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    height += 2 * scene.blocks[k].half_height;
    radius = std::min(
        radius, std::hypot(interface_half_width(scene, static_cast<int>(k)), scene.blocks[k].half_height));
  }
  const auto model = make_model<Quad>(scene);
  Quad share = 1;
  for (const Event& event : history.events) share = std::min(share, least_share(model, event));
  const double digits = share < least_diagonal_share<double> ? std::ldexp(1.0, -11) : 1.0;
  return height / radius / static_cast<double>(share) * digits;
}

}  // namespace rockstack::testing
