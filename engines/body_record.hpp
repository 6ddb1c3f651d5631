#pragma once

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"
#include "engines/trajectory.hpp"

namespace rockstack {

/// Where a block is: its centre of mass in m and its angle in rad, clockwise positive.
struct BlockPose {
  double x = 0, y = 0;
  double angle = 0;
};

/// How a block stands on what is under it.
struct InterfaceState {
  /// How deep a corner lies below the other body's face that it is over, m, negative above it; −∞: over none.
  double depth = 0;
  /// How far the block has slipped to the right along what is under it, m: by its pivot on the side to which
  /// it leans, along the face. The pivot is the end of the faces' overlap there: a corner of the block, or of
  /// the body below where that corner is past the end of its face.
  double slip = 0;
};

/// State of the lowest block on the ground, whose face is y = 0.
InterfaceState on_ground(const Block& block, const BlockPose& pose);

/// State of a block on another.
InterfaceState on_block(const Block& lower, const BlockPose& lower_pose, const Block& upper,
                        const BlockPose& upper_pose);

/// What an engine's bodies did over one run that angles do not tell. SI units, in the ground's frame.
struct BodyRecord {
  /// At each sample: kinetic and potential, zero where the stack rests upright, J.
  std::vector<double> energy;
  /// Work that the ground's motion, pushes and restraints have done on the blocks by then, J.
  std::vector<double> input;
  /// Largest depth of a block in the block or ground under it at each sample, m.
  std::vector<double> penetration;
  /// Centres of mass at each sample, x and y in turn, from the middle of the ground's interface, m.
  std::vector<double> centres;
  /// Since when each block has had nothing of what it stood on below it, or has lain on the ground beside it,
  /// s; infinite where neither is so at the end.
  std::vector<double> unsupported_since;
  std::optional<ContactRecord> contacts;  ///< where the engine tells them
  /// Largest height of a block over what it stands on at each sample, m.
  std::vector<double> gaps;
  double slip = 0;          ///< largest way of a pivot from its start along the face that it stands on, m
  double out_of_plane = 0;  ///< largest |z| of a block's centre, m
  double out_of_plane_tilt = 0;  ///< largest sine of a block's angle out of the plane
};

/// What contacts that are springs hold at each sample, J; zeros where the engine tells no contacts.
std::vector<double> elastic_energy(const BodyRecord& record);

/// What an engine made of a scene, as the exact solver would tell it.
struct EngineRun {
  /// The state at t = 0 and after every step; ends early where a block has toppled. Of laws that leave pivots
  /// with slips, gaps (negative: overlap) and places, whether or not the blocks touch. Reactions, where they
  /// are asked for and told, are means over the step before each sample; no numbers at the start.
  History history;
  std::size_t warnings = 0;          ///< as of a Trajectory
  std::optional<BodyRecord> bodies;  ///< where asked for
};

/// True where a run has to tell its bodies: where they are asked for, and under a law by which blocks slip.
inline bool needs_bodies(const Scene& scene, bool bodies) {
  return bodies || leaves_pivots(scene.law);
}

/// A trajectory of the scene of `setup`. Precondition: it tells bodies where needs_bodies(scene, bodies).
EngineRun engine_run_of(const Scene& scene, const Setup& setup, Trajectory trajectory, bool bodies);

}  // namespace rockstack
