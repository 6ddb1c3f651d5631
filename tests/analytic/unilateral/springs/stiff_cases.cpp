#include "tests/analytic/unilateral/springs/stiff_cases.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analytic/solve.hpp"
#include "tests/analytic/solver/stacks.hpp"

namespace rockstack::testing {
namespace {

/// m g times the height that a rocking block's centre gains at an angle, over m g R.
double rise(double angle, double slenderness) {
  return std::cos(slenderness - angle) - std::cos(slenderness);
}

const Event& first_impact(const History& history) {
  return *std::find_if(history.events.begin(), history.events.end(),
                       [](const Event& event) { return event.kind == EventKind::impact; });
}

double base_angle_at(Scene scene, Law law, double time) {
  scene.law = law;
  const History history = solve(scene, {.sample_times = {time}});
  return history.size() > 0 ? history.angles.front() : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

double rocking_ratio(double stiffness, double damping_ratio) {
  Scene scene = released({block(0.5, 1)}, {0.02}, 0.4);
  Block& one = scene.blocks.front();
  one.inertia *= 1000 / one.mass;
  one.mass = 1000;
  const double square = one.half_width * one.half_width;
  const double about_corner = one.inertia + one.mass * (square + one.half_height * one.half_height);
  const double met = 1 / (1 / one.mass + square / about_corner);
  scene.law = Law::compliant;
  scene.springs = {{stiffness}, {2 * damping_ratio * std::sqrt(stiffness * met)}};
  const History history = solve(scene, {.sample_times = regular_times(1e-4, scene.duration)});
  if (history.times.back() < scene.duration - 1e-3) return std::numeric_limits<double>::quiet_NaN();
  double peak = 0;
  for (std::size_t i = 0; i < history.size(); ++i) peak = std::max(peak, -history.angles_at(i)[0]);
  const double slenderness = std::atan2(one.half_width, one.half_height);
  return std::sqrt(rise(peak, slenderness) / rise(0.02, slenderness));
}

std::vector<StiffCase> stiff_cases() {
  return {{"squat top", released({block(1, 1), block(1, 0.8)}, {0, 0.2}, 1.5), 0.1},
          {"slender top", released({block(1.25, 1.25), block(1, 2.5)}, {0, 0.1}, 1.5), 0.1},
          {"both lean", released({block(1.25, 1.25), block(1, 2.5)}, {0.15, 0.15}, 1.5), 0.005}};
}

StiffAnswer answer_of(const StiffCase& one, double stiffness, double damping_ratio) {
  Scene scene = one.scene;
  scene.law = Law::consistent;
  const double time = first_impact(solve(scene)).time + one.time;
  scene.duration = time + 0.01;
  StiffAnswer answer{0, base_angle_at(scene, Law::paper, time), base_angle_at(scene, Law::consistent, time),
                     base_angle_at(scene, Law::unilateral, time)};
  const double damping = 2 * damping_ratio * std::sqrt(stiffness * scene.blocks.front().mass);
  scene.springs = {std::vector<double>(scene.blocks.size(), stiffness),
                   std::vector<double>(scene.blocks.size(), damping)};
  answer.springs = base_angle_at(scene, Law::compliant, time);
  return answer;
}

}  // namespace rockstack::testing
