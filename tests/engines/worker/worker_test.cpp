// Whatever an engine does in its worker ends that run, with a status that says why, and nothing else.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "engines/worker/registry.hpp"
#include "tests/engines/linked_engines.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

using nlohmann::json;

Scene one_block(double duration) {
  Scene scene;
  scene.duration = duration;
  scene.blocks = {make_block(1, 1, 2500)};
  scene.initial = {{0}, {0}};
  return scene;
}

/// A worker program of that text.
std::filesystem::path script(const TemporaryFolder& folder, const std::string& text) {
  auto program = folder.write("worker", text);
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  return program;
}

const WorkerEngine& faulty(const std::string& solver) {
  static const std::vector<WorkerEngine> engines = engines_of(FAULTY_WORKER);
  return *std::find_if(engines.begin(), engines.end(),
                       [&](const WorkerEngine& engine) { return engine.solver() == solver; });
}

WorkerRun run(const std::string& solver, const Limits& limits = {}) {
  const WorkerEngine& engine = faulty(solver);
  return run_in_worker(engine, one_block(0.5), 0.125, engine.tuned_parameters(), 2, limits);
}

TEST(Workers, DescribeTheirEngines) {
  const WorkerEngine& engine = faulty("fine");
  EXPECT_EQ(engine.name(), "faulty");
  EXPECT_EQ(engine.version(), "1");
  EXPECT_EQ(engine.default_parameters(), (Parameters{{"strength", 1}}));
  EXPECT_EQ(engine.tuned_parameters(), (Parameters{{"strength", 2}}));
  EXPECT_EQ(engine.friction(1e3), 1e3);
}

TEST(Workers, ReturnHistoryTimesAndWhatTheyTook) {
  const WorkerRun made = run("fine");
  ASSERT_EQ(made.status, "done") << made.reason;
  EXPECT_EQ(made.run.history.times, (std::vector<double>{0, 0.125, 0.25, 0.375, 0.5}));
  EXPECT_EQ(made.run.history.angles, (std::vector<double>{0, 0.125, 0.25, 0.375, 0.5}));
  ASSERT_EQ(made.seconds.size(), 2U);
  for (const double seconds : made.seconds) EXPECT_GE(seconds, 0);
  EXPECT_GT(made.processor_time, 0);
  // No program with the C++ library fits into half a megabyte.
  EXPECT_GT(made.peak_memory, 5e5);
}

TEST(Workers, MemoryIsTheirOwnNotThatOfWhoStartsThem) {
  const std::vector<char> ballast(std::size_t{256} << 20, 1);
  EXPECT_LT(run("fine").peak_memory, static_cast<double>(ballast.size()));
}

TEST(Workers, EnginesOwnErrorIsTheReason) {
  const WorkerRun made = run("throw");
  EXPECT_EQ(made.status, "failed");
  EXPECT_EQ(made.reason, "broken on purpose");
}

TEST(Workers, WrongParameterIsTheReason) {
  const WorkerEngine& engine = faulty("fine");
  const WorkerRun made = run_in_worker(engine, one_block(0.5), 0.1, {{"strength", 4}}, 1, {});
  EXPECT_EQ(made.status, "failed");
  EXPECT_EQ(made.reason, "faulty: strength = 4: must be a number from 0 to 3");
}

TEST(Workers, LostAngleIsNotFinite) {
  const WorkerRun made = run("not-finite");
  EXPECT_EQ(made.status, "not finite");
  EXPECT_EQ(made.reason, "angle of block 1 is not finite at t = 0.125 s");
}

TEST(Workers, AssertionIsASignalWithItsLastWords) {
  const WorkerRun made = run("abort");
  EXPECT_EQ(made.status, "signal");
  EXPECT_EQ(made.reason, "ended by signal 6 (Aborted): assertion `depth > 0' failed");
}

TEST(Workers, SegmentationFaultIsASignal) {
  const WorkerRun made = run("segment");
  EXPECT_EQ(made.status, "signal");
  EXPECT_EQ(made.reason, "ended by signal 11 (Segmentation fault)");
}

TEST(Workers, BeingKilledIsASignal) {
  const WorkerRun made = run("killed");
  EXPECT_EQ(made.status, "signal");
  EXPECT_EQ(made.reason, "ended by signal 9 (Killed)");
}

TEST(Workers, SilentExitIsAFailure) {
  const WorkerRun made = run("exit");
  EXPECT_EQ(made.status, "failed");
  EXPECT_EQ(made.reason, "ended with exit code 7 and no result");
}

TEST(Workers, EndlessLoopMeetsTheTimeLimit) {
  Limits limits;
  limits.time = 0.3;
  const WorkerRun made = run("loop", limits);
  EXPECT_EQ(made.status, "time limit");
  EXPECT_EQ(made.reason, "not done after 0.3 s");
}

TEST(Workers, RunThatNobodyWantsAnyMoreIsStopped) {
  int asked = 0;
  const std::function<bool()> unwanted = [&] { return ++asked == 3; };
  Limits limits;
  limits.unwanted = &unwanted;
  EXPECT_EQ(run("loop", limits).status, "stopped");
  EXPECT_EQ(asked, 3);
}

TEST(Workers, TimeLimitHoldsForAWorkerThatHasClosedItsStandardError) {
  Limits limits;
  limits.time = 0.3;
  EXPECT_EQ(run("deaf", limits).status, "time limit");
}

TEST(Workers, TimeLimitMayBeBeyondAnyClock) {
  for (const double time : {1e300, std::numeric_limits<double>::infinity()}) {
    Limits limits;
    limits.time = time;
    EXPECT_EQ(run("fine", limits).status, "done");
  }
}

TEST(Workers, TimeInWhichAWorkerIsStoppedDoesNotCount) {
  Limits limits;
  limits.time = 1;
  EXPECT_EQ(run("stopped", limits).status, "done");
}

TEST(Workers, HalfAReplyIsAFailureThatNamesTheProgram) {
  const WorkerRun made = run("half");
  EXPECT_EQ(made.status, "failed");
  EXPECT_EQ(made.reason,
            std::string(FAULTY_WORKER) +
                " gave a reply that cannot be read: the message is no JSON, which begins with '{', and no "
                "MessagePack");
}

/// A worker that gives an answer that was written beforehand.
class Written {
 public:
  explicit Written(const json& run) {
    const auto program = script(folder_, fmt::format("#!/bin/sh\ncat >&3 <<'END'\n{}\nEND\n",
                                                     json{{"rockstack", 1}, {"run", run}}.dump()));
    EngineDescription description{"written", "step", "1", "none", {}, {}};
    engine_.emplace_back(program, description, Form::json);
  }
  /// Of one block in four steps.
  WorkerRun run(int repeats = 0, bool bodies = false) const {
    return run_in_worker(engine_[0], one_block(0.5), 0.125, {}, repeats, {}, bodies);
  }
  /// What is said of the answer.
  std::string complaint(int repeats = 0, bool bodies = false) const {
    const std::string start = engine_[0].program().string() + " gave a reply that cannot be read: ";
    const std::string reason = run(repeats, bodies).reason;
    return reason.starts_with(start) ? reason.substr(start.size()) : reason;
  }

 private:
  TemporaryFolder folder_;
  std::vector<WorkerEngine> engine_;
};

json answer(std::vector<double> angles) {
  json run{{"status", "done"}, {"velocities", angles}};
  run["angles"] = std::move(angles);
  return run;
}

TEST(Answers, HaveEverySampleOrEndWhereABlockTopples) {
  EXPECT_EQ(Written(answer({0, 0, 0, 0, 0})).run().status, "done");
  EXPECT_EQ(Written(answer({0, 0, -2})).run().status, "done");
  const std::string must =
      "must have 5, 1 in each of 5 samples; fewer samples only where a block of the last one is beyond its "
      "`toppling_angles`";
  EXPECT_EQ(Written(answer({0, 0, 0, 0})).complaint(), "`angles` has 4 numbers; " + must);
  EXPECT_EQ(Written(answer({0, -2, 0})).complaint(), "`angles` has 3 numbers; " + must);
  EXPECT_EQ(Written(answer({0, 0, 0, 0, 0, 0})).complaint(), "`angles` has 6 numbers; " + must);
  EXPECT_EQ(Written(answer({})).complaint(), "`angles` has 0 numbers; " + must);
}

TEST(Answers, HaveWhatIsAskedForAndSayWhatIsNot) {
  json run = answer({0, 0, 0, 0, 0});
  EXPECT_EQ(Written(run).complaint(2), "`seconds` has 0 numbers; must have 2, one for each of `repeats`");
  EXPECT_EQ(Written(run).complaint(0, true), "`bodies` must be there, they are asked for");
  run["seconds"] = {1, -1};
  EXPECT_EQ(Written(run).complaint(2), "`seconds` must be finite and not below zero");
  run.erase("seconds");
  run["velocities"] = {0, 0};
  EXPECT_EQ(Written(run).complaint(), "`velocities` has 2 numbers; must have 5, as many as `angles`");
  run["angles"] = {{0}, {0}};
  EXPECT_EQ(Written(run).complaint(), "each of `angles` must be a number, \"inf\", \"-inf\" or \"nan\"");
  EXPECT_EQ(Written(json{{"status", "failed"}}).run().reason, "no `reason` is given");
}

TEST(Answers, MayHaveFieldsThatNobodyKnows) {
  json run = answer({0, 0, 0, 0, 0});
  run["colour"] = "red";
  EXPECT_EQ(Written(run).run().status, "done");
}

TEST(Workers, HungerMeetsTheMemoryLimit) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "address sanitizer reserves terabytes, so workers run without a memory limit";
#endif
  Limits limits;
  limits.time = 60;
  limits.memory = std::uint64_t{256} << 20;
  const WorkerRun made = run("memory", limits);
  EXPECT_EQ(made.status, "memory limit");
  EXPECT_LT(made.peak_memory, static_cast<double>(limits.memory));
}

TEST(Workers, TalkDoesNotHoldThemUp) {
  EXPECT_EQ(run("talk").status, "done");
}

TEST(Workers, SimulateThrowsTheStatusAndItsReason) {
  const WorkerEngine& engine = faulty("exit");
  try {
    simulate(engine, one_block(0.5), 0.1, engine.tuned_parameters());
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "failed: ended with exit code 7 and no result");
  }
}

/// Why a program is no worker.
std::string refusal(const std::filesystem::path& program) {
  try {
    engines_of(program);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Workers, ProgramThatCannotBeStartedIsNamedWithTheReason) {
  EXPECT_EQ(refusal("/nowhere/rockstack-newton"),
            "/nowhere/rockstack-newton: cannot be started as a worker: No such file or directory");
  const TemporaryFolder folder;
  const auto plain = folder.write("plain", "");
  EXPECT_EQ(refusal(plain), plain.string() + ": cannot be started as a worker: Permission denied");
  const auto program = script(folder, "words\n");
  EXPECT_EQ(refusal(program), program.string() + ": cannot be started as a worker: Exec format error");
  script(folder, "#!/nowhere/python\n");
  EXPECT_EQ(refusal(program), program.string() +
                                  ": cannot be started as a worker: No such file or directory, the "
                                  "interpreter that its first line names");
}

TEST(Workers, ProgramThatEndsBeforeItDescribesItsEnginesSaysHow) {
  const TemporaryFolder folder;
  const auto program = script(folder, "#!/bin/sh\necho no licence >&2\nexit 127\n");
  const std::string start = program.string() + ": does not say which engines it has: ";
  EXPECT_EQ(refusal(program), start + "ended with exit code 127 and no result: no licence");
  script(folder, "#!/bin/sh\necho '{}'\n");
  EXPECT_EQ(refusal(program), start + "nothing came on descriptor 3; standard output is thrown away");
}

TEST(Workers, ProgramThatDoesNotAnswerIsNamedInTime) {
  const TemporaryFolder folder;
  const auto silent = script(folder, "#!/bin/sh\nexec sleep 600\n");
  try {
    engines_of(silent, 0.25);
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), silent.string() + ": does not say which engines it has within 0.25 s");
  }
}

TEST(Workers, GiveTheSameBitsAsTheEngineInThisProcess) {
  Scene scene = one_block(0.3);
  scene.initial.angles = {0.1};
  scene.horizontal = {0.1, {0, 1.5, -2.25, 0.3}, "", false, {}};
  for (const auto& engine : linked_engines()) {
    const WorkerEngine& worker = find_engine(engine->name() + ":" + engine->solver());
    const Parameters parameters = engine->tuned_parameters();
    EXPECT_EQ(worker.tuned_parameters(), parameters);
    const EngineRun here = simulate(*engine, scene, 1e-3, parameters);
    const EngineRun there = simulate(worker, scene, 1e-3, parameters);
    EXPECT_FALSE(there.bodies);
    EXPECT_EQ(here.history.angles, there.history.angles) << engine->solver();
    EXPECT_EQ(here.history.velocities, there.history.velocities) << engine->solver();
  }
}

}  // namespace
}  // namespace rockstack
