#pragma once

#include <set>

#include "engines/trajectory.hpp"
#include "engines/worker/message.hpp"

namespace rockstack {

/// One run that a worker is asked for.
struct RunRequest {
  std::string solver;
  Setup setup;
  Parameters parameters;
  std::size_t repeats = 0;  ///< timed runs after the one that gives the trajectory
  bool bodies = false;      ///< whether the trajectory is to tell bodies and contacts
  std::size_t warm_up = 0;  ///< steps to take before the first timed run, the trajectory's among them
  std::set<std::string> whole = {};  ///< names of parameters that are written as whole numbers
  std::size_t question = 0;          ///< its number in a process that takes several; 0: it takes one
  bool reactions = false;            ///< whether the trajectory is to tell what interfaces bear
};

/// A worker is asked for a run, or without one to describe its engines.
struct Request {
  std::optional<RunRequest> run;
};

/// What became of a run, by the worker's own account.
struct RunReply {
  std::string status;       ///< "done", "failed", "not finite" or "memory limit"
  std::string reason = {};  ///< why not done
  Trajectory trajectory = {};
  std::vector<double> seconds = {};  ///< wall time of stepping alone in each timed run, s
  double peak_memory = 0;            ///< of the worker, bytes; 0 where it does not say
  /// Steps that it took before the first timed run; empty where it does not say: those of the trajectory.
  std::optional<std::size_t> warm_up = {};
  std::optional<std::size_t> question = {};  ///< the number that it answers; empty where it does not say
  double processor_time = 0;                 ///< by the operating system's account, s; no message has it
  bool is_to_another = false;                ///< question of its process; no message has it
};

struct Reply {
  std::vector<EngineDescription> engines;  ///< empty where a run was asked for
  std::optional<RunReply> run;
};

// Between structs and bytes; engines/worker/README.md has every field. Reading throws std::runtime_error for
// bytes that are not a whole message, naming the field that is wrong.
// A run's may be long: `cancelled` is asked now and then. @throws Stopped where it says so.
std::string to_bytes(const RunRequest& run, Form form, const std::function<bool()>* cancelled);
std::string to_bytes(const Request& request, Form form);
std::string to_bytes(const Reply& reply, Form form);
Request read_request(const Message& message);
Reply read_reply(const Message& message);

}  // namespace rockstack
