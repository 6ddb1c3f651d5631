// Whatever an engine does in its worker ends that run, with a status that says why, and nothing else.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "engines/worker/registry.hpp"
#include "tests/engines/linked_engines.hpp"

namespace rockstack {
namespace {

Scene one_block(double duration) {
  Scene scene;
  scene.duration = duration;
  scene.blocks = {make_block(1, 1, 2500)};
  scene.initial = {{0}, {0}};
  return scene;
}

const WorkerEngine& faulty(const std::string& solver) {
  static const std::vector<WorkerEngine> engines = engines_of(FAULTY_WORKER);
  return *std::find_if(engines.begin(), engines.end(),
                       [&](const WorkerEngine& engine) { return engine.solver == solver; });
}

WorkerRun run(const std::string& solver, const Limits& limits = {}) {
  const WorkerEngine& engine = faulty(solver);
  return run_in_worker(engine, one_block(0.5), 0.125, engine.tuned_parameters(), 2, limits);
}

TEST(Workers, DescribeTheirEngines) {
  const WorkerEngine& engine = faulty("fine");
  EXPECT_EQ(engine.name, "faulty");
  EXPECT_EQ(engine.version, "1");
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

TEST(Workers, RuntimesWarmUpBeforeTheyAreTimed) {
  WorkerEngine engine = faulty("fine");
  engine.warm_up = 1000;
  const WorkerRun made = run_in_worker(engine, one_block(0.5), 0.125, engine.tuned_parameters(), 2, {});
  ASSERT_EQ(made.status, "done") << made.reason;
  EXPECT_FALSE(made.cold);
  EXPECT_EQ(made.seconds.size(), 2U);
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

// Among others it gets half of a processor at the most. A quarter is for the last wait, which is counted when
// it ends.
TEST(Workers, WhatTheyWaitForABusyMachineIsNotOfTheirTime) {
  std::vector<std::jthread> others;
  const unsigned count = 4 * std::max(1U, std::thread::hardware_concurrency());
  others.reserve(count);
  for (unsigned i = 0; i < count; ++i) {
    others.emplace_back([](const std::stop_token& enough) {
      while (!enough.stop_requested()) continue;
    });
  }
  const WorkerRun made = run("loop", {.time = 1});
  EXPECT_EQ(made.status, "time limit");
  EXPECT_GT(made.processor_time, 0.75);
}

TEST(Workers, RunThatNobodyWantsAnyMoreIsStopped) {
  int asked = 0;
  const std::function<bool()> cancelled = [&] { return ++asked == 3; };
  Limits limits;
  limits.cancelled = &cancelled;
  EXPECT_EQ(run("loop", limits).status, "stopped");
  EXPECT_EQ(asked, 3);
}

TEST(Workers, QuestionThatNoWorkerCanHoldIsNotMade) {
  Scene scene = one_block(1);
  scene.horizontal.pulse = Pulse{.amplitude = 1, .period = 1};
  Limits limits;
  limits.memory = std::size_t{64} << 20U;
  const WorkerEngine& engine = faulty("fine");
  const WorkerRun made = run_in_worker(engine, scene, 5e-7, engine.tuned_parameters(), 0, limits);
  EXPECT_EQ(made.status, "memory limit");
  EXPECT_EQ(made.reason, "2e+06 steps of a shaken ground: a worker takes 0.128 GB to read them, of 0.0671");
}

// Where processors are scarce it is killed before it has a session of its own.
TEST(Workers, RunThatNobodyWantsFromTheStartIsStopped) {
  const std::function<bool()> cancelled = [] { return true; };
  Limits limits;
  limits.cancelled = &cancelled;
  std::vector<std::thread> threads;
  for (int i = 0; i < 16; ++i)
    threads.emplace_back([&] {
      for (int j = 0; j < 20; ++j) EXPECT_EQ(run("loop", limits).status, "stopped");
    });
  for (std::thread& thread : threads) thread.join();
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

// Nobody wakes it: without a limit that always runs this does not end.
TEST(Workers, TimeLimitHoldsForAWorkerThatIsStopped) {
  Limits limits;
  limits.time = 0.3;
  const WorkerRun made = run("stopped", limits);
  EXPECT_EQ(made.status, "time limit");
  EXPECT_EQ(made.reason, "not done after 0.3 s, in which a signal has stopped it");
}

// In a session of its own there is no terminal to ask, and none whose stop key reaches it.
TEST(Workers, HaveNoTerminal) {
  EXPECT_EQ(run("asks").reason, "no terminal");
  EXPECT_EQ(run("asleep").status, "done");
}

/// Whether a process is there and has not ended, whoever is to wait for it.
bool lives(const std::string& process) {
  std::ifstream stream("/proc/" + process + "/stat");
  std::string number, name, state;
  return stream >> number >> name >> state && state != "Z";
}

TEST(Workers, LeaveNothingOfTheirSession) {
  const WorkerRun made = run("leaves-a-child");
  ASSERT_EQ(made.status, "signal");
  const std::string child = made.reason.substr(made.reason.rfind(' ') + 1);
  for (int tries = 0; lives(child) && tries < 6000; ++tries) usleep(10'000);
  EXPECT_FALSE(lives(child));
}

TEST(Workers, HalfAReplyIsAFailureThatNamesTheProgram) {
  const WorkerRun made = run("half");
  EXPECT_EQ(made.status, "failed");
  EXPECT_EQ(
      made.reason,
      std::string(FAULTY_WORKER) +
          " gave a reply that cannot be read: the message is no JSON, which begins with '{', and no MessagePack");
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

// As runtimes do that reserve addresses for their heap: WebAssembly in V8 10 GB, Java and Go likewise.
TEST(Workers, MemoryThatIsOnlyReservedDoesNotCount) {
  Limits limits;
  limits.memory = std::uint64_t{256} << 20;
  const WorkerRun made = run("reserves", limits);
  EXPECT_EQ(made.status, "done") << made.reason;
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

TEST(Workers, GiveTheSameBitsAsTheEngineInThisProcess) {
  Scene scene = one_block(0.3);
  scene.initial.angles = {0.1};
  scene.horizontal = {0.1, {0, 1.5, -2.25, 0.3}, "", false, {}};
  for (const auto& engine : linked_engines()) {
    const WorkerEngine& worker = find_engine(engine->full_name());
    const Parameters parameters = engine->tuned_parameters();
    EXPECT_EQ(worker.tuned_parameters(), parameters);
    const EngineRun here = simulate(*engine, scene, 1e-3, parameters);
    const EngineRun there = simulate(worker, scene, 1e-3, parameters);
    EXPECT_FALSE(there.bodies);
    EXPECT_EQ(here.history.angles, there.history.angles) << engine->solver;
    EXPECT_EQ(here.history.velocities, there.history.velocities) << engine->solver;
  }
}

}  // namespace
}  // namespace rockstack
