#include "engines/worker/serve.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <new>

#include "engines/worker/request.hpp"

namespace rockstack {
namespace {

/// The largest resident size so far, bytes, of this program alone: usage has that of its parent at the fork.
double peak_memory() {
  std::ifstream stream("/proc/self/status");
  for (std::string word; stream >> word;) {
    double kibibytes = 0;
    if (word == "VmHWM:" && stream >> kibibytes) return 1024 * kibibytes;
  }
  return 0;
}

RunReply answer_run(const Engine& engine, const RunRequest& request) {
  RunReply reply{"done"};
  try {
    reply.trajectory = run(engine, request.setup, request.parameters, request.bodies, request.reactions);
    const std::size_t steps = reply.trajectory.angles.size() / request.setup.blocks.size() - 1;
    if (request.warm_up > steps) {  // those of the trajectory are among them
      const std::size_t runs = (request.warm_up - 1) / steps;
      time_stepping(engine, request.setup, request.parameters, steps, static_cast<int>(runs));
      reply.warm_up = (runs + 1) * steps;
    }
    reply.seconds =
        time_stepping(engine, request.setup, request.parameters, steps, static_cast<int>(request.repeats));
  } catch (const NotFinite& failure) {
    reply = {"not finite", failure.what()};
  } catch (const std::bad_alloc&) {
    reply = {"memory limit", "the engine asked for more memory than there is"};
  } catch (const std::exception& failure) {
    reply = {"failed", failure.what()};
  }
  reply.peak_memory = peak_memory();
  return reply;
}

}  // namespace

int serve(const std::vector<Engine>& engines) {
  std::ios::sync_with_stdio(false);  // a record of a minute has megabytes
  try {
    const std::string bytes{std::istreambuf_iterator<char>(std::cin), {}};
    const Request request = read_request(read_message(bytes));
    Reply reply;
    if (request.run) {
      const auto engine = std::ranges::find(engines, request.run->solver, &Engine::solver);
      if (engine == engines.end()) throw std::runtime_error("no such solver: " + request.run->solver);
      reply.run = answer_run(*engine, *request.run);
    } else {
      reply.engines.assign(engines.begin(), engines.end());
    }
    const std::string answer = to_bytes(reply, Form::messagepack);
    for (std::string_view left = answer; !left.empty();) {
      const ssize_t written = ::write(reply_descriptor, left.data(), left.size());
      if (written <= 0) throw std::runtime_error("the reply cannot be written");
      left.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "a worker of rockstack: {}\n", error.what());
    return 2;
  }
}

}  // namespace rockstack
