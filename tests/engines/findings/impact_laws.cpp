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

}  // namespace rockstack
