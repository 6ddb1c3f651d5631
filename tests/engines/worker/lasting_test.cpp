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
    chatter) yes 'warning: a contact penetrates the ground' | head -n 9999 >&2; echo 'Error: no licence' >&2; exit 1 ;;
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
  Limits limits_{.reply = 10};
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

// Many times what a pipe holds.
TEST_F(Lasting, WordsBehindMuchTalkAreHeard) {
  EXPECT_EQ(ask("chatter").last_words, "Error: no licence");
}

TEST_F(Lasting, EndIsSeenWhereSomethingIsLeftOfIt) {
  EXPECT_EQ(ask("leave").exit_code, 7);
}

TEST_F(Lasting, TimeLimitHoldsForOneThatHangsOrIsDeaf) {
  const Limits limits{.time = 0.3};
  for (const char* word : {"hang", "close"}) {
    LastingProcess process(folder_.path() / "worker", limits);
    const ProcessEnd end = process.ask(word, limits);
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
constexpr const char* counting_worker = R"sh(#!/bin/sh
# field NAME: a number or a text of the question.
field() {
  value=${line#*\"$1\":}
  value=${value%%[,\}]*}
  echo "${value}"
}
answer() { echo "{\"rockstack\":1,\"run\":{$1}}" >&3; }
while read -r line || [ -n "$line" ]; do
  runs=$((runs + 1))
  a=$(field angle)
  seconds=1
  [ "$(field repeats)" != 0 ] || seconds=
  done="\"status\":\"done\",\"angles\":[$a,$a,$a,$a,$a],\"velocities\":[0,0,0,0,0],\"warnings\":$runs,\"seconds\":[$seconds]"
  case $runs$(field solver) in
    ?'"busy"') i=0; while [ $i -lt 100000 ]; do i=$((i + 1)); done ;;
    2'"exits"') exit 3 ;;
    2'"hangs"') sleep 600 ;;
    2'"hungry"') done='"status":"memory limit","reason":"it has kept too much"' ;;
    ?'"never"') done="\"status\":\"failed\",\"reason\":\"run $runs\"" ;;
    2'"lags"' | 3'"lags"') now=$done; done=$before; before=$now ;;
    ?'"numbers"') done="$done,\"question\":$(field question)" ;;
    ?'"miscounts"') done="$done,\"question\":1" ;;
  esac
  [ $runs != 1 ] || before=$done
  answer "$done"
done
)sh";

class LastingWorker : public testing::Test {
 protected:
  WorkerRun run(const std::string& solver, int repeats = 0, double angle = 0) const {
    Scene scene;
    scene.duration = 0.5;
    scene.blocks = {make_block(1, 1, 2500)};
    scene.initial = {{angle}, {0}};
    const WorkerEngine engine{{.solver = solver, .runs_per_process = 3}, program_};
    return run_in_worker(engine, scene, 0.125, {}, repeats, {.time = solver == "hangs" ? 5.0 : 600.0});
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
    for (int i = 0; i < 2; ++i) {
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

// A second run that does nothing is not charged with the first, which counts to 100,000.
TEST_F(LastingWorker, ProcessorTimeIsThatOfTheRun) {
  const double busy = run("busy").processor_time;
  const WorkerRun idle = run("fine");
  EXPECT_EQ(idle.run.warnings, 2U);
  EXPECT_LT(4 * idle.processor_time, busy);
}

// Starts that differ in the seventh digit, as those of replicates do.
TEST_F(LastingWorker, AnswerToTheQuestionBeforeIsRefused) {
  EXPECT_EQ(run("lags", 0, 0.1).status, "done");
  const WorkerRun made = run("lags", 0, 0.1 + 1e-7);
  EXPECT_EQ(made.status, "failed");
  EXPECT_EQ(made.reason, "its answer is to another question");
}

// Starts alike: the number alone tells.
TEST_F(LastingWorker, AnswerWithTheNumberOfAnotherQuestionIsRefused) {
  for (const std::size_t runs : {1, 2, 3, 1}) EXPECT_EQ(run("numbers").run.warnings, runs);
  run("never");  // ends that process
  EXPECT_EQ(run("miscounts").status, "done");
  EXPECT_EQ(run("miscounts").reason, "its answer is to another question");
}

}  // namespace
}  // namespace rockstack
