#include "engines/worker/serve.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <new>
#include <stdexcept>
#include <utility>

namespace rockstack {
namespace {

/// The largest resident size so far, in bytes. Linux also passes the parent's size at the fork on to the
/// child's resource usage; this is the program's own.
double peak_memory() {
  std::ifstream stream("/proc/self/status");
  for (std::string word; stream >> word;) {
    double kibibytes = 0;
    if (word == "VmHWM:" && stream >> kibibytes) return 1024 * kibibytes;
  }
  return 0;
}

EngineDescription describe(const Engine& engine) {
  return {engine.name(), engine.solver(), engine.version(),
          engine.friction(std::numeric_limits<double>::infinity()), engine.settings()};
}

const Engine& find(const std::vector<std::unique_ptr<Engine>>& engines, const std::string& solver) {
  for (const auto& engine : engines) {
    if (engine->solver() == solver) return *engine;
  }
  throw std::runtime_error("no such solver: " + solver);
}

RunReply run(const Engine& engine, const RunRequest& request) {
  RunReply reply{"done", {}, {}, 0, {}, 0, {}};
  try {
    EngineRun made = simulate(engine, request.scene, request.dt, request.parameters, request.bodies);
    const std::size_t steps = made.history.size() - 1;
    reply.history = std::move(made.history);
    reply.warnings = made.warnings;
    reply.bodies = std::move(made.bodies);
    reply.seconds =
        time_stepping(engine, request.scene, request.dt, request.parameters, steps, request.repeats);
  } catch (const NotFinite& failure) {
    reply = {"not finite", failure.what(), {}, 0, {}, 0, {}};
  } catch (const std::bad_alloc&) {
    reply = {"memory limit", "the engine asked for more memory than there is", {}, 0, {}, 0, {}};
  } catch (const std::exception& failure) {
    reply = {"failed", failure.what(), {}, 0, {}, 0, {}};
  }
  reply.peak_memory = peak_memory();
  return reply;
}

void write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written <= 0) throw std::runtime_error("the reply cannot be written");
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace

Reply answer(const std::vector<std::unique_ptr<Engine>>& engines, const Request& request) {
  Reply reply;
  if (request.run) {
    reply.run = run(find(engines, request.run->solver), *request.run);
  } else {
    for (const auto& engine : engines) reply.engines.push_back(describe(*engine));
  }
  return reply;
}

int serve(const std::vector<std::unique_ptr<Engine>>& engines) {
  try {
    const std::string bytes{std::istreambuf_iterator<char>(std::cin), {}};
    write_all(reply_descriptor, to_bytes(answer(engines, read_request(bytes))));
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "a worker of rockstack, not to be started by hand: {}\n", error.what());
    return 2;
  }
}

}  // namespace rockstack
