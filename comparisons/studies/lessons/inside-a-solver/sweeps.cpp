#include "comparisons/studies/lessons/inside-a-solver/sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rockstack {
namespace {

/// Velocity by which the blocks of a contact part.
double parting(const SweptStack& stack, std::size_t contact) {
  return stack.velocities[contact] - (contact > 0 ? stack.velocities[contact - 1] : 0);
}

void push(SweptStack& stack, std::size_t contact, double impulse) {
  stack.velocities[contact] += impulse / stack.masses[contact];
  if (contact > 0) stack.velocities[contact - 1] -= impulse / stack.masses[contact - 1];
}

void visit(SweptStack& stack, std::size_t contact) {
  const double below = contact > 0 ? 1 / stack.masses[contact - 1] : 0;
  const double mass = 1 / (1 / stack.masses[contact] + below);
  double& impulse = stack.impulses[contact];
  const double wanted = std::max(0.0, impulse - mass * parting(stack, contact));
  push(stack, contact, wanted - impulse);
  impulse = wanted;
}

}  // namespace

SweptStack equal_blocks(std::size_t count) {
  return {std::vector<double>(count, 1), std::vector<double>(count), std::vector<double>(count)};
}

std::vector<double> carrying_impulses(const SweptStack& stack, double fall) {
  std::vector<double> impulses(stack.masses.size());
  double above = 0;
  for (std::size_t i = impulses.size(); i-- > 0;) impulses[i] = fall * (above += stack.masses[i]);
  return impulses;
}

void begin_step(SweptStack& stack, double fall, double kept) {
  for (double& velocity : stack.velocities) velocity -= fall;
  for (std::size_t i = 0; i < stack.masses.size(); ++i) push(stack, i, stack.impulses[i] *= kept);
}

void sweep(SweptStack& stack, bool from_below) {
  const std::size_t count = stack.masses.size();
  for (std::size_t i = 0; i < count; ++i) visit(stack, from_below ? i : count - 1 - i);
}

double left_by_sweep(std::size_t blocks) {
  return std::pow(std::cos(std::numbers::pi / (2 * static_cast<double>(blocks))), 2);
}

int sweeps_until(SweptStack stack, double share) {
  const std::vector<double> exact = carrying_impulses(stack, 1);
  const auto carries = [&](double impulse, double whole) { return impulse >= (1 - share) * whole; };
  begin_step(stack, 1, 0);
  int sweeps = 0;
  for (; !std::ranges::equal(stack.impulses, exact, carries); ++sweeps) sweep(stack, true);
  return sweeps;
}

double sinking(SweptStack stack, int sweeps, double kept, double step, double time, double gravity) {
  double sunk = 0;
  for (long i = std::lround(time / step); i > 0; --i) {
    begin_step(stack, gravity * step, kept);
    for (int done = 0; done < sweeps; ++done) sweep(stack, true);
    sunk -= step * stack.velocities.back();
  }
  return sunk;
}

}  // namespace rockstack
