#pragma once

#include "analytic/scene/ground/ground_motion.hpp"
#include "analytic/scene/ground/motion_library.hpp"
#include "analytic/scene/input/document.hpp"

namespace rockstack {

/// The motion that a table [ground.horizontal] or [ground.vertical] describes: a record or samples, then
/// scaled by a factor or to a peak, or a pulse, or a synthetic motion. Paths of records are relative to
/// `folder`; records and synthetic motions come from `library`.
/// @throws InputError with place, key, value and what is allowed; FieldError for a number out of range.
GroundMotion read_ground_motion(const Node& table, const std::filesystem::path& folder,
                                MotionLibrary& library);

}  // namespace rockstack
