#include "comparisons/studies/lessons/contact/contact_need.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analytic/solve.hpp"
#include "comparisons/studies/lessons/wording.hpp"

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

}  // namespace rockstack
