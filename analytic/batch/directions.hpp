#pragma once

#include <array>
#include <cmath>

#include "analytic/batch/pack.hpp"
#include "analytic/scene/direction.hpp"

namespace rockstack {

/// As direction_of(), of each angle of a pack.
template <class Set>
PlaneDirection<Pack<Set>> direction_of_each(const Pack<Set>& angle) {
  using Real = Pack<Set>;
  PlaneDirection<Real> result = near_upright(angle);
  if (!any(!is_near_upright(angle))) return result;
  struct alignas(64) Numbers {
    std::array<double, Real::size> lanes;
  } angles, cosines, sines;
  angle.store(angles.lanes.data());
  result.cosine.store(cosines.lanes.data());
  result.sine.store(sines.lanes.data());
  for (std::size_t lane = 0; lane < Real::size; ++lane) {
    if (std::abs(angles.lanes[lane]) <= 1) continue;
    cosines.lanes[lane] = std::cos(angles.lanes[lane]);
    sines.lanes[lane] = std::sin(angles.lanes[lane]);
  }
  return {Real::load(cosines.lanes.data()), Real::load(sines.lanes.data())};
}

}  // namespace rockstack
