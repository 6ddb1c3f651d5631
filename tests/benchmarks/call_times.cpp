// call_times SCENE COUNT: wall time of solving a scene from C++, s, the median of so many calls; one line.
#include <chrono>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "analytic/scene/input/scene_file.hpp"
#include "analytic/solve.hpp"
#include "comparisons/measures/statistics/samples.hpp"

namespace {

double median_time(const rockstack::Scene& scene, int count) {
  using Clock = std::chrono::steady_clock;
  const rockstack::SolveOptions options{.validity = true, .peaks = true};
  std::vector<double> times;
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const auto start = Clock::now();
    sum += rockstack::solve(scene, options).peaks[0];
    times.push_back(std::chrono::duration<double>(Clock::now() - start).count());
  }
  return sum < 0 ? sum : rockstack::median(times);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 3) return 2;
    std::printf("%.9f\n", median_time(rockstack::read_scene(argv[1]), std::stoi(argv[2])));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
