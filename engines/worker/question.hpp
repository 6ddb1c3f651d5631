#pragma once

#include <functional>

#include "engines/worker/request.hpp"

namespace rockstack {

// Questions may be long: `cancelled` is asked now and then. @throws Stopped where it says so.

/// A run as a worker is asked for it.
std::string to_bytes(const RunRequest& run, Form form, const std::function<bool()>* cancelled);

/// A message as it is written, a piece at a time.
std::string to_bytes(Message message, const std::function<bool()>* cancelled);

}  // namespace rockstack
