#pragma once

#include <cstddef>
#include <memory>

#include "comparisons/runs/execution/executor.hpp"

namespace rockstack {

/// The ranks that mpirun has started, or that many threads.
std::unique_ptr<Executor> make_executor(std::size_t threads);

/// How many threads the machine runs at once, ≥ 1.
std::size_t all_cores();

}  // namespace rockstack
