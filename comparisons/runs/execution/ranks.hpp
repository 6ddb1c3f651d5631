#pragma once

#include <memory>

#include "comparisons/runs/execution/executor.hpp"

namespace rockstack {

/// The processes that mpirun has started together: the first leads, each of the others computes a task at a
/// time. Nothing where this process was started alone. To be called once in a process.
/// @throws std::runtime_error where MPI cannot start.
std::unique_ptr<Executor> find_ranks();

}  // namespace rockstack
