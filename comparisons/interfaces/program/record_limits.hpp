#pragma once

#include "analytic/scene/ground/records/record.hpp"
#include "comparisons/interfaces/program/commands.hpp"

namespace rockstack {

/// RecordLimits of a record that a command reads itself: none with --set limits=none.
/// @throws InputError where other keys are set.
inline RecordLimits record_limits(const Common& common) {
  if (common.overrides == std::vector<std::string>{"limits=none"}) return RecordLimits::none;
  refuse_overrides(common, "a record has no key but limits");
  return RecordLimits::usual;
}

/// RecordLimits of a record beside scenes, which have keys of their own: takes limits=none out of what is
/// set.
inline RecordLimits take_record_limits(Common& common) {
  return std::erase(common.overrides, "limits=none") > 0 ? RecordLimits::none : RecordLimits::usual;
}

}  // namespace rockstack
