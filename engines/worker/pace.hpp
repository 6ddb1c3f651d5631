#pragma once

#include "engines/worker/worker_engine.hpp"

namespace rockstack {

/// What a worker takes, in processor time, s.
struct WorkerPace {
  double start = 0;  ///< of a process, until it steps
  double step = 0;   ///< of one step of one block

  /// Time of so many runs that step so many blocks together.
  double of(double runs, double block_steps) const { return runs * start + block_steps * step; }
};

/// Measured on a block at rest; none where the worker does not answer.
WorkerPace pace_of(const WorkerEngine& engine, const Parameters& parameters, const Limits& limits);

}  // namespace rockstack
