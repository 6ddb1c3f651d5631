#include "engines/simbody/simbody.hpp"
#include "engines/worker/serve.hpp"

int main() {
  return rockstack::serve(rockstack::make_simbody());
}
