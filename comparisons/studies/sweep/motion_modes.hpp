#pragma once

#include <array>
#include <string>

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

/// What a stack does: the response modes of a rigid block on shaken ground, H. W. Shenton 1996, "Criteria for
/// initiation of slide, rock, and slide-rock rigid-body modes", Journal of Engineering Mechanics 122,
/// 690–693; and the two ends.
enum class MotionMode {
  rest,         ///< every interface closed and without slip
  slide,        ///< some interface slips, none opens
  rock,         ///< some interface opens, none slips
  slide_rock,   ///< both
  free_flight,  ///< at some interface blocks are apart
  topple,       ///< a block passes its toppling angle
  fall,         ///< a block leaves what it was over
};

inline constexpr std::array motion_modes{MotionMode::rest,       MotionMode::slide,       MotionMode::rock,
                                         MotionMode::slide_rock, MotionMode::free_flight, MotionMode::topple,
                                         MotionMode::fall};

/// "rest", "slide", "rock", "slide-rock", "free flight", "topple" or "fall".
std::string name(MotionMode mode);

/// The first mode that is not rest, up to free flight.
MotionMode onset_mode(const Scene& scene, const History& history);

/// All of a motion in one word: how it ends where a block topples or falls; else what it ever comes to, free
/// flight before all others, and slide-rock where it slips at one time and rocks at another.
MotionMode whole_mode(const Scene& scene, const History& history);

}  // namespace rockstack
