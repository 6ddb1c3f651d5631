#include "engines/siconos/siconos.hpp"
#include "engines/worker/serve.hpp"

int main() {
  return rockstack::serve(rockstack::make_siconos());
}
