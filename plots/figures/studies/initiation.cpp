#include "plots/figures/studies/initiation.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "plots/drawing/layout.hpp"

namespace rockstack::plots {
namespace {

/// From one acceleration to another, up to the largest friction.
template <class Friction>
std::string line(double from, double to, double largest_friction, const Friction& friction) {
  constexpr int pieces = 200;
  std::string text;
  for (int i = 0; i <= pieces; ++i) {
    const double acceleration = from + (to - from) * i / pieces;
    const double value = friction(acceleration);
    if (value <= largest_friction) text += fmt::format("{} {}\n", plain(acceleration), plain(value));
  }
  return text + "\n";
}

std::string upright(double acceleration, double from, double to) {
  return fmt::format("{0} {1}\n{0} {2}\n\n", plain(acceleration), plain(from), plain(to));
}

}  // namespace

double rocking_friction(double slenderness_ratio, double push) {
  const double r = slenderness_ratio;
  return (push * (4 + r * r) + 3 * r) / (1 + 4 * r * r + 3 * push * r);
}

std::string initiation_boundaries(const StruckBlock& block, double largest_acceleration,
                                  double largest_friction) {
  const double r = block.slenderness_ratio;
  const auto push = [&](double acceleration) {
    return acceleration / (block.gravity + block.vertical * acceleration);
  };
  const double flight = block.vertical < 0 ? -block.gravity / block.vertical : largest_acceleration;
  const double end = std::min(flight, largest_acceleration);
  const double tilts = block.gravity / (r - block.vertical);  // push = 1/r
  std::string text = line(0, std::min(tilts, end), largest_friction, push);
  if (tilts < end) {
    text += upright(tilts, 1 / r, largest_friction);
    text += line(tilts, end, largest_friction, [&](double) { return 1 / r; });
    // The push grows without bound towards flight.
    text += line(tilts, end - 1e-6 * (end - tilts), largest_friction,
                 [&](double acceleration) { return rocking_friction(r, push(acceleration)); });
  }
  if (flight < largest_acceleration) text += upright(flight, 0, largest_friction);
  return text;
}

}  // namespace rockstack::plots
