#pragma once

#include <cstddef>
#include <limits>

namespace rockstack {

/// A point at which an engine lets two bodies touch, as it was used in the last step. SI units.
struct ContactPoint {
  std::size_t interface = 0;  ///< of the upper of both bodies, from 0, bottom to top
  double along = 0;           ///< place along the upper body's lower face, from its middle to the right, m
  double gap_before = 0;      ///< where the step starts and the engine finds the point, m; negative: overlap
  double gap = 0;             ///< where the step ends: the bodies' points moved on, along the same normal, m
  double normal = 0;          ///< impulse of the step that pushes the bodies apart, N·s
  double tangential = 0;      ///< magnitude of the impulse across that, N·s
  double stiffness = std::numeric_limits<double>::infinity();  ///< N/m where it is a spring, else infinite
  double damping = 0;  ///< N s/m where a dashpot is beside the spring; without meaning where there is none
};

/// Stiffness of a contact that takes away the share `erp` of its overlap in a step of `dt` s and gives way by
/// `cfm` m/s for a force of 1 N: a spring and a dashpot, integrated by the implicit Euler method (ODE's
/// manual, section 3.8.2). N/m; infinite for cfm = 0.
inline double contact_stiffness(double erp, double cfm, double dt) {
  return cfm > 0 ? erp / (dt * cfm) : std::numeric_limits<double>::infinity();
}

/// The damping of the dashpot beside that spring, N s/m; infinite for cfm = 0.
inline double contact_damping(double erp, double cfm) {
  return cfm > 0 ? (1 - erp) / cfm : std::numeric_limits<double>::infinity();
}

}  // namespace rockstack
