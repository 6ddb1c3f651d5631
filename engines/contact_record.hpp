#pragma once

#include <limits>
#include <vector>

namespace rockstack {

/// An impact that contacts tell: an end of an interface that was off and bore nothing begins to bear while
/// the interface closes.
struct ContactImpact {
  double time = 0;    ///< at which both faces touch there, by gap and approach, within the run so far, s
  int interface = 0;  ///< from 1
  double speed = 0;   ///< relative angular speed of closing where the step starts, rad/s
  double after = 0;   ///< relative angular velocity where it ends, rad/s
};

/// What an engine's contacts tell over one run. SI units.
struct ContactRecord {
  /// ½kd² of all contacts that are springs which steps follow and overlap by d, at each sample, J.
  std::vector<double> elastic;
  /// Largest product of gap and force of a contact that pushes across a gap, J. Impulses count as forces that
  /// act for the whole step.
  double complementarity = 0;
  /// Impulse across the contacts' normals above what Coulomb's cone allows, over the whole run, as a share of
  /// all that they push; whatever law of friction the engine has.
  double friction_excess = 0;
  /// Of the spring that a contact point is, N/m: by it all impulses together overlap as much as by the
  /// points' own, the harmonic mean by impulse. Infinite where some are rigid.
  double stiffness = std::numeric_limits<double>::infinity();
  double damping = 0;                  ///< of the dashpot beside it, N s/m: the mean by impulse
  std::vector<ContactImpact> impacts;  ///< in order of steps
  double points = 1;                   ///< that push together at one end of an interface: the mean by impulse
};

}  // namespace rockstack
