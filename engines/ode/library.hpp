#pragma once

#include <cstddef>

namespace rockstack {

/// Makes ODE ready on this thread: its errors throw std::runtime_error, its messages are counted.
/// @throws std::runtime_error where that fails.
void initialise_ode();

/// How many messages ODE has given on this thread.
std::size_t ode_messages();

}  // namespace rockstack
