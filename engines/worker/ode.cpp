#include "engines/ode/ode.hpp"
#include "engines/worker/serve.hpp"

int main() {
  return rockstack::serve(rockstack::make_ode());
}
