#pragma once

#include <ctime>
#include <functional>

namespace rockstack::benchmarks {

/// Processor time of a piece of work, s, which is repeated until 5 ms have passed.
inline double processor_seconds(const std::function<void()>& work) {
  constexpr double shortest = 5e-3;
  for (int repeats = 1;; repeats *= 4) {
    const std::clock_t start = std::clock();
    for (int i = 0; i < repeats; ++i) work();
    const double elapsed = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    if (elapsed >= shortest) return elapsed / repeats;
  }
}

}  // namespace rockstack::benchmarks
