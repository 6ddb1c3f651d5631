#include "engines/mujoco/mujoco.hpp"
#include "engines/worker/serve.hpp"

int main() {
  return rockstack::serve(rockstack::make_mujoco());
}
