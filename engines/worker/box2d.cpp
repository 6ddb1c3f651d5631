#include "engines/box2d/box2d.hpp"
#include "engines/worker/serve.hpp"

int main() {
  return rockstack::serve(rockstack::make_box2d());
}
