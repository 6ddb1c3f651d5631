#pragma once

#include <vector>

#include "analytic/unilateral/mode_series.hpp"

namespace rockstack {

/// What happens where a course becomes negative.
enum class Change : std::uint8_t {
  force,    ///< a force leaves its range: opening, lift-off, or slip
  halt,     ///< sliding comes to a halt
  closing,  ///< a pivot's angle returns to zero
  landing,  ///< a corner meets a face
  corner,   ///< a corner comes to the end of a face
  topple,
  fall,
};

/// Something that stays positive for as long as a mode lasts.
struct Course {
  Series series;
  Change change{};
  int interface = 0;    ///< from 0; of topple the block
  int side = 0;         ///< of landing: which corner, −1 or 1
  bool below = false;   ///< of landing: a corner of the block below
  Series within;        ///< of landing: how far the corner is inside the face's end on its side, m
  Series within_other;  ///< on the other side
  double rounding = 0;  ///< of landing: of these distances, m
};

/// All courses of a mode, along a step.
std::vector<Course> courses_of(const FrictionStack& stack, const std::vector<Joint>& joints,
                               const std::vector<double>& toppling_angles, const ModeSeries& series);

}  // namespace rockstack
