#include "tests/analytic/reference/example_scenes.hpp"

#include "analytic/scene/ground/synthetic.hpp"

namespace rockstack::testing {

Scene two_blocks_free() {
  Scene scene;
  scene.title = "two blocks free";
  scene.duration = 5;
  scene.blocks = {make_block(1.25, 1.25, 2500), make_block(1.0, 2.5, 2500)};
  scene.initial = {{0.15, 0.15}, {0, 0}};
  return scene;
}

Scene two_blocks_recorded() {
  Scene scene = two_blocks_free();
  scene.title = "two blocks record";
  scene.duration = 20;
  scene.initial.angles = {0, 0};
  scene.horizontal = make_synthetic({.seed = 1, .peak = 0.71 * scene.gravity});
  return scene;
}

Scene one_block_free() {
  Scene scene;
  scene.title = "one block free";
  scene.duration = 10;
  scene.blocks = {make_block(0.5, 2.5, 2500)};
  scene.initial = {{0.15}, {0}};
  return scene;
}

Scene one_block_pulse() {
  Scene scene = one_block_free();
  scene.title = "one block pulse";
  scene.initial.angles = {0};
  scene.horizontal.pulse = Pulse{.shape = PulseShape::sine, .amplitude = 4, .period = 0.5};
  return scene;
}

}  // namespace rockstack::testing
