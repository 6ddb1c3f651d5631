#pragma once

#include "engines/engine.hpp"

namespace rockstack {

/// The descriptor on which a worker finds its reply's file open.
inline constexpr int reply_descriptor = 3;

/// The main function of a worker program: reads one request from standard input, answers it on
/// reply_descriptor; an engine's failure is part of the reply. @return the exit code, 2 without request.
int serve(const std::vector<Engine>& engines);

}  // namespace rockstack
