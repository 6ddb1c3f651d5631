#include "engines/chipmunk/chipmunk.hpp"
#include "engines/worker/serve.hpp"

int main() {
  return rockstack::serve(rockstack::make_chipmunk());
}
