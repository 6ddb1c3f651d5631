#pragma once

#include <optional>
#include <vector>

namespace rockstack {

/// An impact that contacts tell: an end of an interface that was off and bore nothing begins to bear while
/// the interface closes.
struct ContactImpact {
  double time = 0;    ///< at which both faces touch there, by gap and approach, s
  int interface = 0;  ///< from 1
  double speed = 0;   ///< relative angular speed of closing where the step starts, rad/s
  double after = 0;   ///< relative angular velocity where it ends, rad/s
};

/// What the bodies of an engine did that angles alone do not tell, over one run. SI units, in the ground's
/// frame.
struct BodyRecord {
  /// At each sample: kinetic and potential, zero where the stack rests upright, J.
  std::vector<double> energy;
  /// Work that the ground's motion has done on the blocks by then, J.
  std::vector<double> input;
  /// Largest depth of a block in the block or ground under it at each sample, m.
  std::vector<double> penetration;
  /// ½kd² of all contacts that are springs which steps follow and overlap by d, at each sample, J; 0 where
  /// the engine tells no contacts.
  std::vector<double> elastic;
  /// Largest product of gap and force of a contact that pushes across a gap, J; nothing where the engine
  /// tells no contacts. Impulses count as forces that act for the whole step.
  std::optional<double> complementarity;
  /// Impulse across the contacts' normals above what Coulomb's cone allows, over the whole run, as a share of
  /// all that they push; whatever law of friction the engine has. Nothing where it tells no contacts.
  std::optional<double> friction_excess;
  std::vector<ContactImpact> impacts;  ///< in order of steps
  double gap = 0;                      ///< largest height of a block over what it stands on, m
  double slip = 0;                     ///< largest way of a pivot along the face that it stands on, m
  double out_of_plane = 0;             ///< largest |z| of a block's centre, m
  double out_of_plane_tilt = 0;        ///< largest sine of a block's angle out of the plane
};

}  // namespace rockstack
