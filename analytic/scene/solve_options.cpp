#include "analytic/scene/solve_options.hpp"

#include <limits>
#include <stdexcept>
#include <string>

namespace rockstack {
namespace {

void require(bool in_range, const char* name, double value, const char* range) {
  if (!in_range)
    throw std::invalid_argument(std::string(name) + " = " + std::to_string(value) + ": must be " + range);
}

}  // namespace

void validate(const SolveOptions& options) {
  require(options.resolution >= 0, "resolution", options.resolution, "≥ 0 rad");
  require(options.tolerance >= 0, "tolerance", options.tolerance, "≥ 0");
  require(options.step > 0, "step", options.step, "> 0 s");
  validate_sample_times(options.sample_times);
}

void validate_sample_times(const std::vector<double>& times) {
  double earlier = 0;
  for (const double time : times) {
    require(time >= earlier && time <= std::numeric_limits<double>::max(), "sample time", time,
            "finite, ≥ 0 and no earlier than the one before, s");
    earlier = time;
  }
}

}  // namespace rockstack
