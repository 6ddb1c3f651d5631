#pragma once

#include <optional>
#include <vector>

#include "analytic/scene/history.hpp"
#include "comparisons/measures/metrics/impacts.hpp"
#include "engines/body_record.hpp"

namespace rockstack {

/// Another answer to a scene than the exact one.
struct OtherAnswer {
  const History& history;
  double interval = 0;                ///< between its samples, s
  std::vector<ImpactTime> impacts;    ///< at the chatter speed or more
  bool topples = false;               ///< within the scene
  std::optional<BodyRecord> bodies;   ///< of an engine
  std::vector<double> friction = {};  ///< that acts in an engine, of each interface
};

}  // namespace rockstack
