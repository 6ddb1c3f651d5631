#include "engines/bullet/bullet.hpp"
#include "engines/worker/serve.hpp"

int main() {
  return rockstack::serve(rockstack::make_bullet());
}
