#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engines/engine.hpp"
#include "engines/worker/request.hpp"

namespace rockstack {

/// The descriptor on which a worker finds its reply's file open.
inline constexpr int reply_descriptor = 3;

/// Does what is asked for. An engine's failure is part of the reply.
/// @throws std::runtime_error where no engine has the solver.
Reply answer(const std::vector<std::unique_ptr<Engine>>& engines, const Request& request);

/// The main function of a worker program: reads one request from standard input, answers it on
/// reply_descriptor. @return the exit code: 0, or 2 where there was no request to be read.
int serve(const std::vector<std::unique_ptr<Engine>>& engines);

}  // namespace rockstack
