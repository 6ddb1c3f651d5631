#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "analytic/scene/history.hpp"

namespace rockstack {

/// What one interface has seen under a law that leaves pivots, from samples and events.
struct InterfaceSummary {
  double final_slip = 0;    ///< at the last sample, to the right positive, m
  double largest_slip = 0;  ///< absolute, m
  double highest_lift = 0;  ///< largest finite gap, m
  int slips = 0;            ///< events after which it slides and did not before
  int lift_offs = 0;        ///< events after which it is apart and was not before
};

/// One an interface, from the ground up; none under laws of pivots.
std::vector<InterfaceSummary> contact_summary(const History& history);

/// An array of objects with the names above.
nlohmann::ordered_json contact_json(const History& history);

}  // namespace rockstack
