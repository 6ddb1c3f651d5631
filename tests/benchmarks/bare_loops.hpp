#pragma once

namespace rockstack {

/// Seconds that an engine takes for so many steps of the paper's free-rocking example in a loop written
/// straight against its library, with the tuned parameters and nothing read.
double bare_bullet_seconds(double dt, int steps);
double bare_ode_seconds(double dt, int steps);

}  // namespace rockstack
