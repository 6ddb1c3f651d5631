#include "comparisons/studies/lessons/contact/closed_forms.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace rockstack {

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
