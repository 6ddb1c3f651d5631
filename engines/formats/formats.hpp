#pragma once

#include <string>

#include "analytic/scene/scene.hpp"
#include "engines/setup.hpp"

namespace rockstack {

// Scenes as files that other simulators read. Their axes: x to the right, z up, y into the picture, so that a
// clockwise angle is a positive turn about y. SI units; numbers read back to the same double.

/// A scene as any of these formats is told it.
struct ModelScene {
  std::string name;                     ///< of the scene: letters, digits, - and _
  std::string title;                    ///< in words
  Setup setup;                          ///< with the accelerations of a shaken one
  std::vector<GroundStep> ground = {};  ///< motion of its ground, of each step; empty where it rests
  double restitution = 0;               ///< of contact points
  std::string file;                     ///< that the text is written to
  std::string table = {};               ///< the file beside it with the ground's motion; empty: none
};

/// A file's text, and what it cannot hold, in words; the text says so itself.
struct ModelFile {
  std::string text;
  std::vector<std::string> left_out = {};
};

/// Makes what the writers are given. @throws as set_up().
ModelScene model_scene(const Scene& scene, const std::string& name, double dt, const std::string& file);

/// MuJoCo's own format: bodies on two slides and a hinge, a pair for each interface, a keyframe for the
/// start.
ModelFile mjcf_of(const ModelScene& scene);
/// Simulation Description Format 1.9, as Gazebo and Drake read it: a world of free bodies.
ModelFile sdf_of(const ModelScene& scene);
/// Unified Robot Description Format: links on planar joints, whose zero is the start.
ModelFile urdf_of(const ModelScene& scene);

/// The ground's motion as a table: what gravity each step has where the ground rests, or where a ground that
/// moves starts a step, and the velocity that it has all through it.
std::string ground_table(const ModelScene& scene);

}  // namespace rockstack
