#pragma once

#include "analytic/scene/history.hpp"
#include "analytic/unilateral/solve_unilateral.hpp"

namespace rockstack {

/// The motion as other laws tell theirs, with slips, gaps, places and reactions of its samples.
History history_of(const Scene& scene, const ContactHistory& motion);

}  // namespace rockstack
