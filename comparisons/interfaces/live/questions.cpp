#include "comparisons/interfaces/live/questions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "analytic/scene/input/json_reader.hpp"
#include "comparisons/interfaces/live/answers.hpp"
#include "comparisons/interfaces/live/live_state.hpp"
#include "comparisons/suites/perturbations.hpp"
#include "engines/worker/process.hpp"

namespace rockstack::live {
namespace {

using Json = nlohmann::ordered_json;
using Unwanted = std::function<bool()>;

constexpr double longest_run = 20;                             // s
constexpr std::uint64_t run_memory = std::uint64_t{2} << 30U;  // bytes
constexpr std::uint64_t longest_answer = std::uint64_t{64} << 20U;

/// A question as it was asked.
struct Question {
  Asker asker;
  int member = 0;
  Json state;
  LiveState read;
};

Kind kind_of(const std::string& name) {
  if (name == "exact") return Kind::exact;
  if (name == "engine") return Kind::engine;
  if (name == "cloud") return Kind::cloud;
  throw InputError(
      fmt::format("the page: kind = {}: must be exact, engine or cloud", rockstack::quoted(name)));
}

Question read_question(const std::string& text, const std::set<std::string>& records,
                       MotionLibrary& library) {
  Json json = parse_json(text, "the page: ");
  Question question{
      {json.at("page"), kind_of(json.at("kind")), json.at("sequence")}, json.value("member", 0), {}, {}};
  constexpr std::size_t longest_name = 64;
  constexpr int most_members = 100;
  if (question.asker.page.size() > longest_name) throw InputError("the page: page: must be a short name");
  if (question.member < 0 || question.member > most_members)
    throw InputError(fmt::format("the page: member = {}: must be 0 to {}", question.member, most_members));
  question.state = json.at("state");
  question.read = read_state(question.state, records, library);
  if (question.asker.kind == Kind::engine && question.read.series.engine == nullptr)
    throw InputError("the page: state.engine: missing, must be an engine");
  return question;
}

Json failure(const std::string& reason) {
  return {{"failure", reason}};
}

Json solved(const std::filesystem::path& solver, const Question& question, const Limits& limits) {
  const LiveState& state = question.read;
  const Json asked{{"scene", question.state.at("scene")},
                   {"interval", static_cast<double>(kept_stride(state)) * state.dt},
                   {"member", question.member},
                   {"spread", state.spread}};
  const ProcessEnd end = run_process(solver, asked.dump(), limits);
  if (end.unwanted) return {{"dropped", true}};
  if (end.timed_out) return failure(fmt::format("not done after {} s", limits.time));
  if (end.signal != 0 || end.exit_code != 0)
    return failure(end.last_words.empty() ? "more memory or time than a live page has" : end.last_words);
  return parse_json(end.reply, "the exact solver's answer ");
}

Json simulated(const Question& question, const Limits& limits) {
  const LiveState& state = question.read;
  const bool member = question.member > 0;
  const Scene scene =
      member ? perturbed(state.scene, {question.member, state.spread}, question.member) : state.scene;
  const WorkerRun run =
      run_in_worker(*state.series.engine, scene, state.dt, state.series.parameters, 0, limits, !member);
  if (run.status == "stopped") return {{"dropped", true}};
  if (run.status != "done") return failure(run.status + ": " + run.reason);
  const std::size_t stride = kept_stride(state);
  return member ? engine_member(run, stride) : engine_answer(state, run, stride);
}

}  // namespace

Questions::Questions(std::filesystem::path solver, std::set<std::string> records)
    : solver_(std::move(solver)),
      records_(std::move(records)),
      desk_(std::max<std::size_t>(2, std::thread::hardware_concurrency())) {}

std::string Questions::answer(const std::string& text, const Unwanted& gone) {
  const auto start = std::chrono::steady_clock::now();
  const Question question = read_question(text, records_, library_);
  desk_.note(question.asker);
  const Unwanted unwanted = [&] { return desk_.is_superseded(question.asker) || gone(); };
  const Limits limits{
      .time = longest_run, .memory = run_memory, .reply = longest_answer, .unwanted = &unwanted};
  Json answer{{"dropped", true}};
  desk_.serve(question.asker.kind, unwanted, [&] {
    const bool exact = question.asker.kind == Kind::exact || question.read.series.engine == nullptr;
    answer = exact ? solved(solver_, question, limits) : simulated(question, limits);
  });
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  answer["milliseconds"] = taken.count();
  return answer.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string Questions::files(const std::string& text) {
  const Json json = parse_json(text, "the page: ");
  const Json& state = json.at("state");
  const LiveState read = read_state(state, records_, library_);
  const Json files{{"scene", state_scene_text(state)},
                   {"suite", state_suite_text(state, read, json.at("name"), json.value("runs", 0))}};
  return files.dump();
}

}  // namespace rockstack::live
