#pragma once

#include "analytic/scene/scene.hpp"

namespace rockstack {

/// The paper's free-rocking example, for `duration` s.
inline Scene free_rocking(double duration) {
  Scene scene;
  scene.law = Law::paper;
  scene.duration = duration;
  scene.blocks = {make_block(1.25, 1.25, 2500), make_block(1.0, 2.5, 2500)};
  scene.initial = {{0.15, 0.15}, {0, 0}};
  return scene;
}

}  // namespace rockstack
