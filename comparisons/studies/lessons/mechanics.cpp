#include "comparisons/studies/lessons/mechanics.hpp"

#include <numbers>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/bodies.hpp"
#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/studies/lessons/lesson.hpp"

namespace rockstack {
namespace {

/// Velocities of centres and rotations in a pattern, at absolute angles.
Motion<double> motion_of(const Stack<double>& stack, const Pattern& pattern,
                         const std::vector<double>& angles, const std::vector<double>& velocities) {
  const Vector<double> rates = vector_of(velocities);
  return {centre_velocities(make_chain(stack, pattern, vector_of(angles)), rates), rates};
}

double kinetic_energy(const Stack<double>& stack, const Motion<double>& motion) {
  double sum = 0;
  for (int k = 0; k < stack.size(); ++k)
    sum += (stack.mass[k] * motion.centre.col(k).squaredNorm() +
            stack.inertia[k] * motion.rotation[k] * motion.rotation[k]) /
           2;
  return sum;
}

double about_corner(const Block& block) {
  return block.inertia +
         block.mass * (block.half_width * block.half_width + block.half_height * block.half_height);
}

/// Kinetic energy in pattern 1b with the stack upright, J.
double energy_after(const Scene& scene, double base, double top) {
  const Stack<double> stack = make_stack<double>(scene);
  Pattern pattern = closed_pattern(2);
  pattern[0] = pattern[1] = Contact::left;
  return kinetic_energy(stack, motion_of(stack, pattern, {0, 0}, {base, top}));
}

/// The centre of a uniform block that leans to the right, from the corner that it leans on, m.
std::pair<double, double> from_right_corner(const Block& block, double angle) {
  const double b = block.half_width, h = block.half_height;
  return {h * std::sin(angle) - b * std::cos(angle), b * std::sin(angle) + h * std::cos(angle)};
}

/// Time of the first of all ways in which pivots fail, s.
double first_failure_time(const ContactNeed& need) {
  return std::min({need.first_pull(), need.force.first_slip_time, need.impulse.first_slip_time});
}

}  // namespace

ImpactEnergies impact_energies(const Scene& scene, const Event& impact) {
  const Stack<double> stack = make_stack<double>(scene);
  const Motion<double> before = motion_of(stack, impact.from, impact.angles, impact.before);
  const Motion<double> after = motion_of(stack, impact.to, impact.angles, impact.after);
  const Motion<double> jump{after.centre - before.centre, after.rotation - before.rotation};
  return {kinetic_energy(stack, before), kinetic_energy(stack, after), kinetic_energy(stack, jump)};
}

Impact<double> impact_of(const Event& event) {
  Impact<double> impact{{event.from, relative(vector_of(event.angles)), relative(vector_of(event.before))},
                        {}};
  impact.impacting.set(static_cast<std::size_t>(event.interface) - 1);
  for (int k = 0; k < event.from.size; ++k)
    if (event.from[k] == Contact::closed) impact.before.angles[k] = impact.before.velocities[k] = 0;
  impact.before.angles[event.interface - 1] = 0;
  return impact;
}

Landing land(const Scene& scene, const Misprints& misprints) {
  // The paper's symbols; that with an underscore is primed there.
  const Block &lower = scene.blocks[0], &upper = scene.blocks[1];
  const double b1 = lower.half_width, h1 = lower.half_height, b2 = upper.half_width, h2 = upper.half_height;
  const double m2 = upper.mass, M = lower.mass + upper.mass, height = 2 * h1 + h2;  // of the upper centre
  const double I_G1 = lower.inertia, I_G2 = upper.inertia;
  const double I_O1 = about_corner(lower), I_O2 = about_corner(upper);
  const double I_O = I_O1 + I_G2 + m2 * (b1 * b1 + height * height);
  // Products that Eqs. (136)–(140) share, m².
  const double arm = b1 * b2 + height * h2;           // r2 (b1 sin θc2 + (2h1+h2) cos θc2)
  const double link = 2 * h1 * h2 + (b1 - b2) * b2;   // l (h2 cos β + b2 sin β)
  const double link_ = 2 * h1 * h2 - (b1 + b2) * b2;  // l' (h2 cos β' − b2 sin β')
  const double C1 = I_O - 2 * M * b1 * b1;
  const double C2 = (misprints.eq137 ? I_G1 : I_G2) + m2 * arm;
  const double C3 = (misprints.eq138 ? I_O1 : I_O2) + m2 * link_;
  const double C4 = I_O1 + m2 * (2 * h1 * (2 * h1 + h2) + (b1 - b2) * b1);
  const double C5 = m2 * link;
  const double base = (I_O2 * C1 - C2 * C3) / (C4 * I_O2 - C2 * C5);
  const double top = (C5 * C1 - C4 * C3) / (C2 * C5 - C4 * I_O2);
  return {base, top, energy_after(scene, base, top) / (I_O / 2)};
}

Block welded(const Scene& scene) {
  const Block& base = scene.blocks[0];
  const Block& top = scene.blocks[1];
  const double mass = base.mass + top.mass;
  const double height =
      (base.mass * base.half_height + top.mass * (2 * base.half_height + top.half_height)) / mass;
  const double below = height - base.half_height;
  const double above = 2 * base.half_height + top.half_height - height;
  return {base.half_width, height, mass,
          base.inertia + top.inertia + base.mass * below * below + top.mass * above * above};
}

ContactNeed contact_need(Scene scene) {
  scene.law = Law::consistent;
  const std::vector<double> friction = friction_of(scene);
  const History history = solve(scene, {.events = EventsKept::summed, .validity = true});
  return {worst_of(history.forces), worst_of(history.impulses), *std::ranges::min_element(friction)};
}

Law law_for(const ContactNeed& need) {
  return std::isfinite(first_failure_time(need)) ? Law::unilateral : Law::consistent;
}

std::string first_failure(const ContactNeed& need) {
  const double first = first_failure_time(need);
  if (!std::isfinite(first)) return "nothing";
  const char* what = first == need.first_pull()            ? "would pull"
                     : first == need.force.first_slip_time ? "would slip"
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

double impacts_to_share(double share, double ratio) {
  return std::ceil(std::log(share) / (2 * std::log(ratio)));
}

std::vector<double> SlidingCorner::forces() const {
  std::vector<double> list;
  if (free >= 0) list.push_back(0);
  if (const double holding = -free / slope; holding > 0) list.push_back(holding);
  return list;
}

SlidingCorner sliding_corner(const Scene& scene) {
  const Block& block = scene.blocks.front();
  const double rate = scene.initial.velocities.empty() ? 0 : scene.initial.velocities.front();
  const auto [x, y] = from_right_corner(block, scene.initial.angles.front());
  return {rate * rate * y - scene.gravity,
          1 / block.mass + x * (x + scene.friction.front() * y) / block.inertia};
}

double jamming_friction(const Block& block, double angle) {
  const auto [x, y] = from_right_corner(block, angle);
  return (block.inertia / block.mass + x * x) / (-x * y);
}

double rate_once_stuck(const Scene& scene) {
  const Block& block = scene.blocks.front();
  const auto [x, y] = from_right_corner(block, scene.initial.angles.front());
  const double rate = scene.initial.velocities.empty() ? 0 : scene.initial.velocities.front();
  return rate + scene.initial.slip_velocities.front() * y / (block.inertia / block.mass + x * x + y * y);
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
