#include "tests/engines/findings/impact_laws.hpp"

#include <algorithm>

namespace rockstack {
namespace {

/// Housner's ratio, where nothing slips.
double sticking(double r) {
  return 1 - 1.5 / (1 + r * r);
}

bool sticks(double r, double friction) {
  return friction >= 3 * r / (1 + 4 * r * r);
}

}  // namespace

double left_by_coulomb(double r, double friction) {
  if (sticks(r, friction)) return sticking(r);
  return (r * r - 2 + 3 * friction * r) / (4 + r * r - 3 * friction * r);
}

double left_by_frictionless(double r, double friction) {
  const double without = (r * r - 2) / (4 + r * r);
  const double threshold = 3 * r * (4 + r * r) / (4 * (1 + r * r) * (1 + r * r));
  return std::min(sticking(r), without + (sticking(r) - without) * friction / threshold);
}

/// A half width, a mass and an angular velocity of one. The normal impulse N turns the block by −N(1 − μr)/I;
/// the corner comes down at 2, then rises at N[1 + (1 − μr)/I] − 2 and slides at N[r(1 − μr)/I − μ].
double left_by_convex_cone(double r, double friction) {
  if (sticks(r, friction)) return sticking(r);
  const double inertia = (1 + r * r) / 3, arm = 1 - friction * r;
  const double impulse = 2 / (1 + friction * friction + arm * arm / inertia);
  return 1 - impulse * arm / inertia;
}

/// As above: until the corner stops, friction pushes it back and the block down, then the other way.
double left_by_routh(double r, double friction, double slip) {
  const double inertia = (1 + r * r) / 3, turn = r / inertia;
  const double first = slip / (friction * (1 + r * turn) + turn);
  const double lifted = first * (1 + 1 / inertia + friction * turn);
  const double second = (2 - lifted) / (1 + 1 / inertia - friction * turn);
  return 1 - (first * (1 + friction * r) + second * (1 - friction * r)) / inertia;
}

}  // namespace rockstack
