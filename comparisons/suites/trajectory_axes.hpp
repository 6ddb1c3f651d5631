#pragma once

#include <Eigen/Geometry>

#include "engines/setup.hpp"
#include "engines/simulation.hpp"

namespace rockstack {

/// A body as a simulator in space has it, in the simulator's own axes. SI units.
struct SpatialBody {
  Eigen::Vector3d place = Eigen::Vector3d::Zero(), velocity = Eigen::Vector3d::Zero();
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();  ///< from the upright block's axes
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();
};

/// How a plane of motion lies in a simulator's axes.
struct TrajectoryAxes {
  Eigen::Vector3d right, up;

  /// What lies in the plane, and how far the body has left it: its way along the third axis, and its tilt.
  BodyState seen(const SpatialBody& body) const;
};

/// The axes, with y or z up, by which bodies start most nearly where a scene has its blocks and leave the
/// plane least. `bodies`: samples of all blocks, one after the other, row by row; at least one.
TrajectoryAxes find_axes(const std::vector<SpatialBody>& bodies, const std::vector<Placement>& blocks);

}  // namespace rockstack
