#include "engines/worker/worker_engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace rockstack {
namespace {

std::string with_last_words(const std::string& reason, const ProcessEnd& end) {
  return end.last_words.empty() ? reason : reason + ": " + end.last_words;
}

/// Why there is no reply.
void explain(const ProcessEnd& end, const Limits& limits, WorkerRun& result) {
  if (end.timed_out) {
    result.status = "time limit";
    result.reason = fmt::format("not done after {} s", limits.time);
  } else if (end.signal != 0) {
    result.status = "signal";
    result.reason =
        with_last_words(fmt::format("ended by signal {} ({})", end.signal, strsignal(end.signal)), end);
  } else {
    result.status = "failed";
    result.reason = with_last_words(fmt::format("ended with exit code {} and no result", end.exit_code), end);
  }
}

/// True where slips, gaps and places are of that many samples.
bool tells_places(const History& history, std::size_t samples) {
  const std::size_t values = samples * static_cast<std::size_t>(history.blocks);
  return history.slips.size() == values && history.gaps.size() == values &&
         history.places.size() == 2 * values;
}

/// @throws std::runtime_error where a run that is said to be done has no history of the scene, or not all
/// times.
void require_whole(const RunReply& run, const Scene& scene, int repeats) {
  if (run.status != "done") return;
  const std::size_t blocks = scene.blocks.size();
  const std::size_t samples = run.history.times.size();
  const auto fits = [&](const std::vector<double>& values) { return values.size() == samples * blocks; };
  const auto samples_of = [&](const BodyRecord& bodies) {
    return bodies.energy.size() == samples && bodies.input.size() == samples &&
           bodies.penetration.size() == samples && bodies.elastic.size() == samples;
  };
  const bool whole = run.seconds.size() == static_cast<std::size_t>(repeats) && samples > 0 &&
                     run.history.blocks == static_cast<int>(blocks) && fits(run.history.angles) &&
                     fits(run.history.velocities) &&
                     tells_places(run.history, scene.law == Law::unilateral ? samples : 0) &&
                     (!run.bodies || samples_of(*run.bodies));
  if (!whole) throw std::runtime_error("the message is not about this run");
}

}  // namespace

WorkerEngine::WorkerEngine(std::filesystem::path program, EngineDescription description)
    : program_(std::move(program)), description_(std::move(description)) {}

double WorkerEngine::friction(double asked) const {
  return std::min(asked, description_.largest_friction);
}

std::vector<WorkerEngine> engines_of(const std::filesystem::path& program, double answering_time) {
  const ProcessEnd end = run_process(program, to_bytes(Request{}), {.time = answering_time});
  const auto refuse = [&](const std::string& why) {
    return std::runtime_error(
        with_last_words(fmt::format("{}: does not say which engines it has{}", program.string(), why), end));
  };
  if (end.timed_out) throw refuse(fmt::format(" within {} s", answering_time));
  if (end.signal != 0 || end.exit_code != 0) throw refuse("");
  try {
    std::vector<WorkerEngine> engines;
    for (EngineDescription& engine : read_reply(end.reply).engines) {
      engines.emplace_back(program, std::move(engine));
    }
    return engines;
  } catch (const std::exception& error) {
    throw refuse(fmt::format(": {}", error.what()));
  }
}

WorkerRun run_in_worker(const WorkerEngine& engine, const Scene& scene, double dt,
                        const Parameters& parameters, int repeats, const Limits& limits, bool bodies) {
  const std::string request =
      to_bytes(Request{RunRequest{engine.solver(), scene, dt, parameters, repeats, bodies}});
  const ProcessEnd end = run_process(engine.program(), request, limits);
  WorkerRun result;
  result.processor_time = end.processor_time;
  if (end.timed_out || end.signal != 0 || end.exit_code != 0) {
    explain(end, limits, result);
    return result;
  }
  RunReply run;
  try {
    run = read_reply(end.reply).run.value();
    require_whole(run, scene, repeats);
  } catch (const std::exception& error) {
    result.status = "failed";
    result.reason =
        fmt::format("{} gave a reply that cannot be read: {}", engine.program().string(), error.what());
    return result;
  }
  result.status = std::move(run.status);
  result.reason = std::move(run.reason);
  result.run = {std::move(run.history), run.warnings, std::move(run.bodies)};
  result.seconds = std::move(run.seconds);
  result.peak_memory = run.peak_memory;
  return result;
}

EngineRun simulate(const WorkerEngine& engine, const Scene& scene, double dt, const Parameters& parameters,
                   const Limits& limits) {
  WorkerRun result = run_in_worker(engine, scene, dt, parameters, 0, limits);
  if (result.status != "done") throw std::runtime_error(result.status + ": " + result.reason);
  return std::move(result.run);
}

}  // namespace rockstack
