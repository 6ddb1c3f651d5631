// What a worker says of its engines, and in words wherever it says them.

#include "engines/worker/answer_check.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "analytic/scene/messages/one_line.hpp"
#include "engines/worker/worker_engine.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

using nlohmann::json;
using std::string_literals::operator""s;

Scene one_block() {
  Scene scene;
  scene.duration = 0.5;
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

/// What a program of that text says of itself where it does not answer.
std::string last_words(const std::string& text) {
  const TemporaryFolder folder;
  const std::string told = refusal(script(folder, "#!/bin/sh\ncat >&2 <<'END'\n" + text + "\nEND\nexit 1\n"));
  const std::string before = "no result: ";
  return told.substr(told.find(before) + before.size());
}

// As node 20, Python 3.11, Java 17, Go 1.19, Rust 1.63 and the C++ library write it.
TEST(Workers, LineOfStandardErrorThatTellsMostIsTold) {
  EXPECT_EQ(last_words(
                "/tmp/w.js:2\nthrow new RangeError('no world: 3');\n^\n\nRangeError: no world: 3\n"
                "    at new TypeError: (/tmp/w.js:2:7)\n    at node:internal/main:30:12\n\nNode.js v20.11.0"),
            "RangeError: no world: 3");
  EXPECT_EQ(last_words("Traceback (most recent call last):\n  File \"w.py\", line 1\n    x(\"error: y\")\n"
                       "ValueError: no world: 3\n"),
            "ValueError: no world: 3");
  EXPECT_EQ(
      last_words("Exception in thread \"main\" java.lang.RuntimeException: no world\n\tat W.main(W.java:3)\n"
                 "\tat error: W.main(W.java:3)"),
      "Exception in thread \"main\" java.lang.RuntimeException: no world");
  EXPECT_EQ(last_words(
                "panic: no world\n\ngoroutine 1 [running]:\nmain.main()\n\t/tmp/w.go:4 +0x27\nexit status 2"),
            "panic: no world");
  EXPECT_EQ(
      last_words("thread 'main' panicked at 'no world', src/main.rs:2:5\nnote: run with `RUST_BACKTRACE=1`"),
      "thread 'main' panicked at 'no world', src/main.rs:2:5");
  EXPECT_EQ(
      last_words("terminate called after throwing an instance of 'std::runtime_error'\n  what():  no world"),
      "what():  no world");
  EXPECT_EQ(last_words("first words\nno licence\n \n"), "no licence");
}

// ESC, NUL, ends of lines, bytes that are no UTF-8 and ever more of them.
TEST(Workers, WordsAreOneShortLineWhereverTheyAreTold) {
  const std::string words = "\x1b[2J\x00\xff\u2028"s + std::string(100'000, 'w');
  const auto is_fit = [](const std::string& told, bool with_words = true) {
    constexpr std::size_t most = 200 + 300;  // and what it stands in: the path of a worker
    EXPECT_EQ(told, one_line(told));
    EXPECT_LE(told.size(), most);
    EXPECT_EQ(told.find("\\x1b[2J") != std::string::npos, with_words) << told;
  };
  const TemporaryFolder folder;
  const std::string file = folder.write("words", words).string();
  is_fit(refusal(script(folder, "#!/bin/sh\ncat " + file + " >&2\nexit 1\n")));
  const auto answers = [&](const json& message) {
    const std::vector<std::uint8_t> bytes = json::to_msgpack(message);
    const std::string reply = folder.write("reply", std::string(bytes.begin(), bytes.end())).string();
    return script(folder, "#!/bin/sh\ncat " + reply + " >&3\n");
  };
  json engine{
      {"name", "x"}, {"solver", "y"}, {"version", "1"}, {"licence", "z"}, {"settings", json::array()}};
  for (const char* field : {"name", "solver", "version", "licence"}) {
    json wrong = engine;
    wrong[field] = words;
    const bool named = std::string(field) == "name" || std::string(field) == "solver";
    is_fit(refusal(answers({{"rockstack", 1}, {"engines", json::array({wrong})}})), named);
  }
  is_fit(refusal(answers({{"rockstack", words}})), false);
  const WorkerEngine other{{},
                           answers({{"rockstack", 1}, {"run", {{"status", "failed"}, {"reason", words}}}})};
  is_fit(run_in_worker(other, one_block(), 0.125, {}, 0, {}).reason);
}

// Five samples: the fourth step is not the thousandth.
TEST(Workers, TimesOfARuntimeThatHasNotWarmedUpAreCold) {
  const TemporaryFolder folder;
  const auto is_cold = [&](const json& more) {
    json answer{
        {"status", "done"}, {"angles", {0, 0, 0, 0, 0}}, {"velocities", {0, 0, 0, 0, 0}}, {"seconds", {1}}};
    answer.update(more);
    const std::string reply = folder.write("reply", json{{"rockstack", 1}, {"run", answer}}.dump()).string();
    WorkerEngine engine{{}, script(folder, "#!/bin/sh\ncat " + reply + " >&3\n")};
    engine.warm_up = 1000;
    const WorkerRun made = run_in_worker(engine, one_block(), 0.125, {}, 1, {});
    EXPECT_EQ(made.status, "done") << made.reason;
    return made.cold;
  };
  EXPECT_TRUE(is_cold(json::object()));
  EXPECT_TRUE(is_cold({{"warm_up", 999}}));
  EXPECT_FALSE(is_cold({{"warm_up", 1000}}));
}

/// A worker's description with a change.
std::string refusal_of(const std::function<void(EngineDescription&)>& change) {
  EngineDescription engine{
      .name = "x", .solver = "y", .version = "1", .licence = "z", .settings = {shaking_setting()}};
  change(engine);
  try {
    check_descriptions({engine});
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Descriptions, HaveNoNameThatMeansSomethingHere) {
  EXPECT_EQ(refusal_of([](EngineDescription&) {}), "");
  for (const std::string name :
       {"exact", "linear", "nonlinear", "paper", "consistent", "unilateral", "compliant", "rk4"})
    EXPECT_TRUE(refusal_of([&](EngineDescription& engine) {
                  engine.name = name;
                }).starts_with("name = " + name + ": must be another one than exact, "));
  EXPECT_EQ(refusal_of([](EngineDescription& engine) {
              engine.settings[0].choices = {"no", "yes"};
            }),
            "setting name = shaking: must be of another one, or of the choices force and ground");
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

}  // namespace
}  // namespace rockstack
