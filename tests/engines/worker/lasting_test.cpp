// A process that takes several runs: each has its own answer, time and words, and what happens in one costs
// no other.

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <string>

#include "engines/worker/worker_engine.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

std::filesystem::path runnable(const TemporaryFolder& folder, const std::string& text) {
  auto program = folder.write("worker", text);
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  return program;
}

/// Answers words: `count` with how many it was given, the others as they say.
constexpr const char* word_by_word = R"(#!/bin/sh
while read -r word; do
  count=$((count + 1))
  case $word in
    count) echo $count >&3 ;;
    talk) echo 'Error: of this one' >&2; echo >&3 ;;
    exit) exit 7 ;;
    close) exec <&- 3>&-; sleep 600 ;;
    leave) sleep 600 & exit 7 ;;
    hang) sleep 600 ;;
    long) echo 0123456789 >&3 ;;
    twice) echo >&3; echo >&3 ;;
  esac
done
)";

class Lasting : public testing::Test {
 protected:
  ProcessEnd ask(const std::string& word) { return process_.ask(word, limits_); }

  TemporaryFolder folder_;
  Limits limits_{.time = 0.3, .reply = 10};
  LastingProcess process_{runnable(folder_, word_by_word), limits_};
};

TEST_F(Lasting, AnswersOneQuestionAfterTheOther) {
  for (const std::string count : {"1\n", "2\n", "3\n"}) {
    EXPECT_TRUE(process_.waits());
    EXPECT_EQ(ask("count").reply, count);
  }
}

TEST_F(Lasting, WordsAreThoseOfTheQuestionThatFails) {
  EXPECT_EQ(ask("talk").reply, "\n");
  const ProcessEnd end = ask("exit");
  EXPECT_EQ(end.reply, "");
  EXPECT_EQ(end.exit_code, 7);
  EXPECT_EQ(end.last_words, "");
  EXPECT_FALSE(process_.waits());
}

TEST_F(Lasting, EndIsSeenWhereSomethingIsLeftOfIt) {
  EXPECT_EQ(ask("leave").exit_code, 7);
}

TEST_F(Lasting, TimeLimitHoldsForOneThatHangsOrIsDeaf) {
  for (const char* word : {"hang", "close"}) {
    LastingProcess process(folder_.path() / "worker", limits_);
    const ProcessEnd end = process.ask(word, limits_);
    EXPECT_TRUE(end.timed_out) << word;
    EXPECT_FALSE(process.waits());
  }
}

TEST_F(Lasting, LongReplyEndsIt) {
  const ProcessEnd end = ask("long");
  EXPECT_EQ(end.signal, SIGXFSZ);
  EXPECT_FALSE(end.timed_out);
}

TEST_F(Lasting, WhatNobodyAskedIsNoAnswerToTheNext) {
  // What came at once is of the answer, and makes it none.
  const std::string reply = ask("twice").reply;
  while (reply == "\n" && process_.waits()) continue;
  EXPECT_TRUE(reply == "\n\n" || !process_.waits());
}

/// Tells as warnings how many runs the process has had. The solver's name says what the second of one does.
constexpr const char* counting_worker = R"(#!/usr/bin/env python3
import json, os, sys, time
for runs, line in enumerate(sys.stdin, 1):
    asked = json.loads(line)["run"]
    if asked["solver"] == "busy":
        start = time.process_time()
        while time.process_time() < start + 0.2:
            continue
    answer = {"status": "done", "angles": [0] * 5, "velocities": [0] * 5, "warnings": runs, "seconds": [1] * asked["repeats"]}
    if runs == 2 and asked["solver"] == "exits":
        os._exit(3)
    if runs == 2 and asked["solver"] == "hangs":
        time.sleep(600)
    if runs == 2 and asked["solver"] == "hungry":
        answer = {"status": "memory limit", "reason": "it has kept too much"}
    if asked["solver"] == "never":
        answer = {"status": "failed", "reason": f"run {runs}"}
    os.write(3, json.dumps({"rockstack": 1, "run": answer}).encode() + b"\n")
)";

class LastingWorker : public testing::Test {
 protected:
  WorkerRun run(const std::string& solver, int repeats = 0) const {
    Scene scene;
    scene.duration = 0.5;
    scene.blocks = {make_block(1, 1, 2500)};
    scene.initial = {{0}, {0}};
    const WorkerEngine engine{{.solver = solver, .runs_per_process = 3}, program_};
    return run_in_worker(engine, scene, 0.125, {}, repeats, {.time = 1});
  }

  TemporaryFolder folder_;
  std::filesystem::path program_ = runnable(folder_, counting_worker);
};

TEST_F(LastingWorker, TakesAsManyRunsAsItSays) {
  for (const std::size_t runs : {1, 2, 3, 1, 2}) EXPECT_EQ(run("fine").run.warnings, runs);
}

TEST_F(LastingWorker, TimedRunHasItsOwnProcess) {
  for (const std::size_t runs : {1, 2}) {
    EXPECT_EQ(run("fine", 1).run.warnings, 1U);
    EXPECT_EQ(run("fine").run.warnings, runs);
  }
}

TEST_F(LastingWorker, RunThatTheOnesBeforeItSpoilIsMadeAnew) {
  for (const std::string solver : {"exits", "hangs", "hungry"}) {
    for (int i = 0; i < 3; ++i) {
      const WorkerRun made = run(solver);
      EXPECT_EQ(made.status, "done") << made.reason;
      EXPECT_EQ(made.run.warnings, 1U);
    }
  }
}

TEST_F(LastingWorker, RunThatFailsCostsItselfAlone) {
  EXPECT_EQ(run("fine").run.warnings, 1U);
  const WorkerRun made = run("never");
  EXPECT_EQ(made.status, "failed");
  EXPECT_EQ(made.reason, "run 1");  // of a new process
  EXPECT_EQ(run("fine").run.warnings, 1U);
}

// What the first one takes to start is less than a run.
TEST_F(LastingWorker, ProcessorTimeIsThatOfTheRun) {
  for (int i = 0; i < 3; ++i) {
    const double taken = run("busy").processor_time;
    EXPECT_GE(taken, 0.2);
    EXPECT_LT(taken, 0.4);
  }
}

}  // namespace
}  // namespace rockstack
