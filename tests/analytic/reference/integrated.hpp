#pragma once

#include "tests/analytic/reference/quad.hpp"

namespace rockstack::testing {

/// The first events of a scene by a method that has neither series nor polynomials: Fehlberg's Runge–Kutta
/// pair of order 8 (Boost.odeint) at 113 bits from the general rule (dynamics.hpp), at a fixed step in s, and
/// bisection on the length of the last step. What is shared with the solver is the model: accelerations,
/// reactions and what follows an impact. The interval of a record must be a multiple of the step; chatter is
/// not ended.
QuadHistory integrate(const Scene& scene, double step, std::size_t events);

}  // namespace rockstack::testing
