#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"
#include "engines/body_record.hpp"
#include "engines/parameters.hpp"

namespace rockstack {

/// What a worker program says of an engine with one of its solvers.
struct EngineDescription {
  std::string name, solver, version;
  double largest_friction = 0;  ///< the coefficient that acts where a scene asks for more; may be infinite
  std::vector<Setting> settings;
};

/// One run that a worker is asked for.
struct RunRequest {
  std::string solver;
  Scene scene;
  double dt = 0;  ///< s
  Parameters parameters;
  int repeats = 0;      ///< timed runs after the one that gives the history
  bool bodies = false;  ///< whether to keep a BodyRecord
};

/// A worker is asked for a run, or without one to describe its engines.
struct Request {
  std::optional<RunRequest> run;
};

/// What became of a run, by the worker's own account.
struct RunReply {
  std::string status;  ///< "done", "failed", "not finite" or "memory limit"
  std::string reason;  ///< why not done
  History history;     ///< samples alone
  std::size_t warnings = 0;
  std::vector<double> seconds;       ///< wall time of stepping alone in each timed run, s
  double peak_memory = 0;            ///< of the worker, bytes
  std::optional<BodyRecord> bodies;  ///< where asked for
};

struct Reply {
  std::vector<EngineDescription> engines;  ///< empty where a run was asked for
  std::optional<RunReply> run;
};

// Between structs and bytes, see message.hpp. Reading throws std::runtime_error for bytes that are not a
// whole message of this version of the program.
std::string to_bytes(const Request& request);
std::string to_bytes(const Reply& reply);
Request read_request(std::string_view bytes);
Reply read_reply(std::string_view bytes);

}  // namespace rockstack
