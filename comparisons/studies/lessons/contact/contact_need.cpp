#include "comparisons/studies/lessons/contact/contact_need.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "analytic/solve.hpp"
#include "comparisons/studies/lessons/lesson.hpp"

namespace rockstack {

ContactNeed contact_need(Scene scene) {
  scene.law = Law::consistent;
  const std::vector<double> friction = friction_of(scene);
  const History history = solve(scene, {.events = EventsKept::summed, .validity = true});
  constexpr double never = std::numeric_limits<double>::infinity();
  ContactNeed need{.least_normal = never,
                   .friction = *std::min_element(friction.begin(), friction.end()),
                   .first_pull = never,
                   .first_force_slip = never,
                   .first_impulse_slip = never};
  for (const Demand& force : history.forces) {
    need.least_normal = std::min(need.least_normal, force.least_normal);
    need.force_friction = std::max(need.force_friction, force.friction);
    need.first_pull = std::min(need.first_pull, force.first_pull_time);
    need.first_force_slip = std::min(need.first_force_slip, force.first_slip_time);
  }
  for (const Demand& impulse : history.impulses) {
    need.impulse_friction = std::max(need.impulse_friction, impulse.friction);
    need.first_pull = std::min(need.first_pull, impulse.first_pull_time);
    need.first_impulse_slip = std::min(need.first_impulse_slip, impulse.first_slip_time);
  }
  return need;
}

Law law_for(const ContactNeed& need) {
  const double first = std::min({need.first_pull, need.first_force_slip, need.first_impulse_slip});
  return std::isfinite(first) ? Law::unilateral : Law::consistent;
}

std::string first_failure(const ContactNeed& need) {
  const double first = std::min({need.first_pull, need.first_force_slip, need.first_impulse_slip});
  if (!std::isfinite(first)) return "nothing";
  const char* what = first == need.first_pull         ? "would pull"
                     : first == need.first_force_slip ? "would slip"
                                                      : "would slip at an impact";
  return std::string(what) + " at " + fixed(first, 3) + " s";
}

double impact_friction(double r) {
  return 3 * r / (1 + 4 * r * r);
}

double impact_ratio(double r, double friction) {
  return friction >= impact_friction(r) ? 1 - 1.5 / (1 + r * r)
                                        : (r * r - 2 + 3 * friction * r) / (4 + r * r - 3 * friction * r);
}

Throw thrown_by_sine(double amplitude, double period, double gravity) {
  if (!(amplitude > gravity)) throw std::domain_error("a pulse of at most gravity throws no block");
  const double frequency = 2 * std::numbers::pi / period;
  Throw result;
  result.lift_off = period / 2 + std::asin(gravity / amplitude) / frequency;
  const double phase = frequency * result.lift_off;
  result.lift_off_rate = amplitude / frequency * (1 - std::cos(phase));
  result.lift_off_rise = amplitude / frequency * (result.lift_off - std::sin(phase) / frequency);
  if (result.lift_off + result.lift_off_rate / gravity < period)
    throw std::domain_error("the block is at its highest before the pulse ends");
  const double ground = amplitude / frequency * period;
  const double rate = result.lift_off_rate;
  result.highest = result.lift_off_rise + rate * rate / (2 * gravity) - ground;
  result.landing_rate = std::sqrt(2 * gravity * result.highest);
  result.landing = result.lift_off + (rate + result.landing_rate) / gravity;
  return result;
}

Slide slide_through(const Throw& thrown, double speed, double friction, double gravity) {
  const double slowing = friction * gravity;
  const double parts = thrown.lift_off;
  const double in_flight = speed - slowing * parts - friction * thrown.lift_off_rate;
  Slide slide{.after_landing = speed - slowing * thrown.landing, .stop = speed / slowing};
  slide.distance = speed * parts - slowing * parts * parts / 2 - friction * thrown.lift_off_rise +
                   in_flight * (thrown.landing - parts) +
                   slide.after_landing * slide.after_landing / (2 * slowing);
  return slide;
}

}  // namespace rockstack
