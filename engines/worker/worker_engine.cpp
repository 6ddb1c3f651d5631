#include "engines/worker/worker_engine.hpp"

#include <fmt/format.h>

#include <csignal>
#include <cstring>

#include "analytic/scene/messages/one_line.hpp"
#include "analytic/scene/solve_options.hpp"
#include "engines/scene_setup.hpp"
#include "engines/worker/answer_check.hpp"

namespace rockstack {
namespace {

/// What a worker says in words goes into messages, tables and pages through here.
std::string heard(const std::string& words) {
  return one_line(words, 200);
}

std::string with_last_words(const std::string& reason, const ProcessEnd& end) {
  return end.last_words.empty() ? reason : reason + ": " + heard(end.last_words);
}

/// What becomes of a run that is cancelled.
RunReply stopped() {
  return {"stopped", "nobody wants it any more"};
}

/// Why there is no reply.
RunReply explain(const ProcessEnd& end, const Limits& limits) {
  if (end.cancelled) return stopped();
  if (end.signal == SIGXFSZ && !end.timed_out)
    return {"failed", fmt::format("its reply is longer than {} bytes", limits.reply)};
  const char* status = end.timed_out ? "time limit" : end.signal != 0 ? "signal" : "failed";
  const char* stopped = end.stopped ? ", in which a signal has stopped it" : "";
  const std::string reason = end.timed_out ? fmt::format("not done after {} s{}", limits.time, stopped)
                             : end.signal != 0
                                 ? fmt::format("ended by signal {} ({})", end.signal, strsignal(end.signal))
                                 : fmt::format("ended with exit code {} and no result", end.exit_code);
  return {status, with_last_words(reason, end)};
}

/// As capabilities have it, of the set that these parameters are, but for a scene's restitution.
double lead_of(const EngineDescription& engine, const Parameters& given) {
  const bool tuned = std::ranges::all_of(engine.settings, [&](const Setting& setting) {
    const auto value = given.find(setting.name);
    return setting.role != SettingRole::own || value == given.end() || value->second == setting.tuned;
  });
  return tuned ? engine.capabilities.tuned_lead : engine.capabilities.lead;
}

/// The memory in which a worker can read a question, bytes: the numbers of a shaken ground and of pushes as
/// they are written, as fields, as the list that it takes, and as a list that grows.
double question_memory(const WorkerEngine& engine, const Scene& scene, double dt,
                       const Parameters& parameters) {
  const double shaken = is_shaken(scene) ? (moves_ground(parameters) ? 4 : 2) : 0;
  const double numbers = shaken + static_cast<double>(scene.pushes.size());
  const double bytes = engine.form == Form::messagepack ? 8 : 20;
  return 4 * bytes * numbers * step_count(scene.duration, dt);
}

/// The most bytes of a reply: numbers of up to 25 characters; no more impacts than steps of each interface.
std::uint64_t reply_limit(const RunRequest& asked) {
  const std::uint64_t numbers = (asked.setup.steps + 1) * asked.setup.blocks.size();
  const std::uint64_t each = (asked.bodies ? 8 * 27 + 160 : 2 * 27) + (asked.reactions ? 3 * 27 : 0);
  return (std::uint64_t{1} << 20) + numbers * each;
}

RunRequest request(const WorkerEngine& engine, const Parameters& parameters, std::size_t repeats,
                   bool bodies) {
  RunRequest asked{engine.solver, {}, parameters, repeats, bodies};
  if (repeats > 0) asked.warm_up = engine.warm_up;
  for (const Setting& setting : engine.settings)
    if (setting.whole) asked.whole.insert(setting.name);
  return asked;
}

/// @throws std::runtime_error where it is none.
Message read_answer(const std::string& bytes) {
  if (bytes.empty()) throw std::runtime_error("nothing came on descriptor 3; standard output is thrown away");
  return read_message(bytes);
}

/// Two questions of one process: the one that is asked, and the one before it, none for the first.
struct Questions {
  const RunRequest& asked;
  const Setup* before = nullptr;
};

bool is_to_another(const RunReply& reply, const Questions& questions) {
  if (reply.question && questions.asked.question > 0) return *reply.question != questions.asked.question;
  return questions.before != nullptr && reply.status == "done" &&
         answers_rather(reply.trajectory, *questions.before, questions.asked.setup);
}

/// A whole reply to what was asked. @throws std::runtime_error where it is not that.
RunReply read_run(const std::string& bytes, const Questions& questions) {
  const RunRequest& asked = questions.asked;
  Reply reply = read_reply(read_answer(bytes));
  if (!reply.run) throw std::runtime_error("`run` must be there");
  if (is_to_another(*reply.run, questions))
    return {.status = "failed", .reason = "its answer is to another question", .is_to_another = true};
  try {
    require_answer(*reply.run, asked);
  } catch (const NotFinite& failure) {
    return {.status = "not finite", .reason = failure.what(), .peak_memory = reply.run->peak_memory};
  }
  if (reply.run->status != "done")
    reply.run->reason = reply.run->reason.empty() ? "no `reason` is given" : heard(reply.run->reason);
  return *std::move(reply.run);
}

/// What a worker answered, or why it did not.
RunReply answer_of(const ProcessEnd& end, const WorkerEngine& engine, const Questions& questions,
                   const Limits& limits) {
  RunReply answer;
  try {
    const bool silent = end.cancelled || end.timed_out || end.signal != 0 || end.exit_code != 0;
    answer = silent ? explain(end, limits) : read_run(end.reply, questions);
  } catch (const std::exception& error) {
    const std::string reason =
        fmt::format("{} gave a reply that cannot be read: {}", engine.program.string(), heard(error.what()));
    answer = {"failed", with_last_words(reason, end)};
  }
  answer.processor_time = end.processor_time;
  return answer;
}

/// A process that may take further runs of a thread.
struct Kept {
  std::filesystem::path program = {};
  std::uint64_t memory = 0;  ///< its limit, bytes
  std::size_t runs = 0;      ///< that it has taken
  Setup before = {};         ///< the last of them, without the ground's motion
  std::unique_ptr<LastingProcess> process = {};
};

/// Process of this thread. One: runs of an engine come after each other, and a process holds its memory.
thread_local Kept kept;

/// True for a run that need not have a process of its own: nobody takes its time, and nobody may stop it.
bool may_share(const WorkerEngine& engine, const RunRequest& asked, const Limits& limits) {
  return engine.runs_per_process > 1 && engine.form == Form::json && asked.repeats == 0 &&
         limits.cancelled == nullptr;
}

RunReply ask_kept(const WorkerEngine& engine, RunRequest& asked, const Limits& limits) {
  asked.question = ++kept.runs;
  const std::string question = to_bytes(asked, engine.form, nullptr);
  const Questions questions{asked, kept.runs > 1 ? &kept.before : nullptr};
  RunReply answer = answer_of(kept.process->ask(question, limits), engine, questions, limits);
  if (answer.status != "done" || kept.runs >= engine.runs_per_process) {
    kept = {};
  } else {
    kept.before.blocks = asked.setup.blocks;
    kept.before.toppling_angles = asked.setup.toppling_angles;
    kept.before.steps = asked.setup.steps;
  }
  return answer;
}

RunReply ask(const WorkerEngine& engine, RunRequest& asked, Limits limits) {
  limits.reply = reply_limit(asked);
  if (!may_share(engine, asked, limits)) {
    const std::string question = to_bytes(asked, engine.form, limits.cancelled);
    return answer_of(run_process(engine.program, question, limits), engine, {asked}, limits);
  }
  double spent = 0;
  const bool there = kept.process && kept.program == engine.program && kept.memory == limits.memory;
  if (there && kept.process->waits()) {
    RunReply answer = ask_kept(engine, asked, limits);
    if (answer.status == "done" || answer.is_to_another) return answer;
    spent = answer.processor_time;  // the runs before it may be why: a new process tells
  }
  kept = {};
  kept = {.program = engine.program,
          .memory = limits.memory,
          .process = std::make_unique<LastingProcess>(engine.program, limits)};
  RunReply answer = ask_kept(engine, asked, limits);
  answer.processor_time += spent;
  return answer;
}

/// Tells the worker the scene first. What cannot be asked fails with its reason.
RunReply ask(const WorkerEngine& engine, const Scene& scene, double dt, const Parameters& parameters,
             const Limits& limits, RunRequest& asked) {
  try {
    require_able(engine, scene);
    require_wall(engine, scene);
    check_step(dt, scene.duration);
    const double memory = question_memory(engine, scene, dt, parameters);
    if (const auto most = static_cast<double>(limits.memory); memory > most)
      return {"memory limit",
              fmt::format("{:.4g} steps of {}: a worker takes {:.3g} GB to read them, of {:.3g}",
                          step_count(scene.duration, dt), is_shaken(scene) ? "a shaken ground" : "pushes",
                          memory * 1e-9, most * 1e-9)};
    asked.setup = set_up(scene, dt, parameters, limits.cancelled);
    asked.setup.lookahead = lookahead(dt, lead_of(engine, parameters));
    return ask(engine, asked, limits);
  } catch (const Stopped&) {
    return stopped();
  } catch (const std::exception& error) {
    return {"failed", error.what()};
  }
}

}  // namespace

std::vector<WorkerEngine> engines_of(const std::filesystem::path& program, double answering_time) {
  const Limits limits{.time = answering_time};
  const ProcessEnd end = run_process(program, to_bytes(Request{}, Form::json), limits);
  const auto refuse = [&](const std::string& why) {
    return std::runtime_error(fmt::format("{}: does not say which engines it has{}", program.string(), why));
  };
  if (end.timed_out) throw refuse(with_last_words(fmt::format(" within {} s", answering_time), end));
  if (end.signal != 0 || end.exit_code != 0) throw refuse(": " + explain(end, limits).reason);
  try {
    std::vector<WorkerEngine> engines;
    const Message message = read_answer(end.reply);
    const Reply reply = read_reply(message);
    check_descriptions(reply.engines);
    for (const EngineDescription& engine : reply.engines) engines.push_back({engine, program, message.form});
    return engines;
  } catch (const std::exception& error) {
    throw refuse(with_last_words(": " + heard(error.what()), end));
  }
}

WorkerRun run_in_worker(const WorkerEngine& engine, const Scene& scene, double dt,
                        const Parameters& parameters, int repeats, const Limits& limits, bool bodies,
                        bool reactions) {
  WorkerRun result;
  RunRequest asked = request(engine, with_restitution(engine, scene, parameters),
                             static_cast<std::size_t>(repeats), needs_bodies(scene, bodies));
  asked.reactions = reactions;
  RunReply run = ask(engine, scene, dt, parameters, limits, asked);
  result.status = std::move(run.status);
  result.reason = std::move(run.reason);
  result.processor_time = run.processor_time;
  result.peak_memory = run.peak_memory;
  if (result.status != "done") return result;
  const std::size_t steps = run.trajectory.angles.size() / scene.blocks.size() - 1;
  result.cold = run.warm_up.value_or(steps) < asked.warm_up;
  result.run = engine_run_of(scene, asked.setup, std::move(run.trajectory), bodies);
  result.seconds = std::move(run.seconds);
  return result;
}

Trajectory run(const WorkerEngine& engine, const Setup& setup, const Parameters& parameters, bool bodies,
               const Limits& limits, std::size_t repeats, bool reactions) {
  RunRequest asked = request(engine, parameters, repeats, bodies);
  asked.setup = setup;
  asked.reactions = reactions;
  RunReply answer = ask(engine, asked, limits);
  if (answer.status != "done") throw std::runtime_error(answer.status + ": " + answer.reason);
  return std::move(answer.trajectory);
}

EngineRun simulate(const WorkerEngine& engine, const Scene& scene, double dt, const Parameters& parameters,
                   const Limits& limits, bool bodies, bool reactions) {
  WorkerRun result = run_in_worker(engine, scene, dt, parameters, 0, limits, bodies, reactions);
  if (result.status != "done") throw std::runtime_error(result.status + ": " + result.reason);
  return std::move(result.run);
}

}  // namespace rockstack
