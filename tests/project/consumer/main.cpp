#include <cstdio>
#include <rockstack/analytic/solve.hpp>

int main() {
  rockstack::Scene scene;
  scene.duration = 1.0;  // s
  scene.blocks = {rockstack::make_block(1.25, 1.25, 2500), rockstack::make_block(1.0, 2.5, 2500)};
  scene.initial.angles = {0.15, 0.15};  // rad, clockwise positive
  scene.initial.velocities = {0, 0};
  for (const rockstack::Event& event : rockstack::solve(scene).events) {
    std::printf("%.6f s  %s at interface %d: %s -> %s\n", event.time, name(event.kind).c_str(),
                event.interface, name(event.from).c_str(), name(event.to).c_str());
  }
}
