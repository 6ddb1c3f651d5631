#pragma once

#include "analytic/scene/history.hpp"
#include "analytic/unilateral/contact/contact_model.hpp"
#include "analytic/unilateral/springs/spring_energy.hpp"

namespace rockstack {

/// One event with the motion on both sides of it. `interface` counts from 1; of topple it is the block.
template <class Real = double>
struct ContactEvent {
  Real time = 0;  ///< s
  EventKind kind{};
  int interface = 0;
  Joints<Real> from, to;
  Poses<Real> at, before, after;  ///< poses, and their rates
  /// What theory has to say: one motion; several, of which the one named by find_mode() follows; or none
  /// without an impulse, of which the limit of Moreau's time steps follows.
  Consistency consistency = Consistency::consistent;
};

/// The motion at one time.
template <class Real>
struct ContactSample {
  Real time = 0;  ///< s
  Bodies<Real> bodies;
  Joints<Real> joints;
  std::vector<Real> slips = {},
                    gaps = {};  ///< of each interface, m; where apart, the slip that it parted with
  // Of stacks with springs, else empty.
  std::vector<SpringState<Real>> springs = {};  ///< of each interface
  FreeVector<Real> spring_accelerations = {};   ///< what all springs make of the motion
};

/// A stack's motion under a law that leaves pivots.
template <class Real = double>
struct ContactHistory {
  using Sample = ContactSample<Real>;
  std::vector<Sample> samples;
  std::vector<ContactEvent<Real>> events;
  std::vector<Real> peaks;  ///< largest |θ| of each block at any time, rad; empty unless asked for
  /// Likewise the slip of each interface at the end, and its largest finite gap, m.
  std::vector<Real> slips_left, lifts;
  /// What acts at each interface, of the motion and of impacts; empty unless asked for. A least normal force
  /// of zero is that of blocks that part; nothing pulls, and nothing rubs more than its friction, so that
  /// first times are infinite. Of impulses that of chatter, less than a millionth of a fall's, is not told.
  std::vector<BasicDemand<Real>> forces, impulses;
  Bodies<Real> last;  ///< at the end
  Real end_time{};    ///< s
};

}  // namespace rockstack
