#pragma once

#include <optional>

#include "analytic/unilateral/springs/spring_contacts.hpp"

namespace rockstack {

/// What a change at a soft interface is called; nothing where histories do not tell it. `passes`: a slider
/// has come to the end of a face.
template <class Real>
std::optional<EventKind> change_of(const BasicJoint<Real>& before, const BasicJoint<Real>& after,
                                   bool passes) {
  const auto ends = [](const BasicJoint<Real>& joint) {
    return joint.touch == Touch::flat ? 2 : joint.pivots() ? 1 : 0;
  };
  if (passes) return EventKind::corner;
  if (before.touch != after.touch) return ends(after) < ends(before) ? EventKind::part : EventKind::touch;
  if (before.slip == after.slip) return std::nullopt;
  return before.slip == 0 ? EventKind::slip : EventKind::stick;
}

}  // namespace rockstack
