// The worker program of an engine: compiled for each, with the name of the function that makes its solvers.

#include "engines/worker/serve.hpp"

namespace rockstack {
std::vector<Engine> ROCKSTACK_MAKE_ENGINES();
}

int main() {
  return rockstack::serve(rockstack::ROCKSTACK_MAKE_ENGINES());
}
