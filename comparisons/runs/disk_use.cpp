#include "comparisons/runs/disk_use.hpp"

#include <algorithm>

#include "comparisons/runs/measure.hpp"
#include "comparisons/runs/parts.hpp"

namespace rockstack {
namespace {

double samples_of(const Job& job) {
  const double interval = job.series != nullptr ? job.dt : sample_interval;
  return job.scene.scene.duration / std::max(interval, job.suite.history_interval);
}

/// Of all files with a line a sample.
double columns_of(const Job& job) {
  const auto blocks = static_cast<double>(job.scene.scene.blocks.size());
  const double history = 1 + 2 * blocks, difference = 1 + blocks, energy = 7, reactions = 1 + 3 * blocks;
  if (job.series == nullptr && job.variant == nullptr) return history + reactions;
  if (!job.suite.wanted.histories) return 0;
  const bool engine = job.series != nullptr;
  return history + difference + (engine && job.suite.wanted.bodies ? energy : 0) +
         (engine && job.suite.softness ? 1 + 3 * blocks : 0);
}

}  // namespace

double history_bytes(const std::vector<Suite>& suites) {
  constexpr double number_length = 14;  // on average: 20 of an angle, few of a time or a zero
  double bytes = 0;
  for (const Job& job : jobs_of(suites)) bytes += number_length * samples_of(job) * columns_of(job);
  return bytes;
}

}  // namespace rockstack
