#include "comparisons/interfaces/live/requests.hpp"

#include <fmt/format.h>

#include "analytic/scene/input/json_reader.hpp"
#include "comparisons/interfaces/live/exact_answers.hpp"
#include "comparisons/interfaces/live/live_state.hpp"
#include "comparisons/measures/metrics/motion_verdict.hpp"
#include "comparisons/runs/execution/executor.hpp"
#include "engines/worker/installation.hpp"
#include "plots/pages/player_data.hpp"

namespace rockstack::live {
namespace {

constexpr double longest_run = 20;                             // s
constexpr std::uint64_t run_memory = std::uint64_t{2} << 30U;  // bytes
constexpr std::uint64_t longest_answer = std::uint64_t{64} << 20U;

/// Limit of exact runs, and as many of engines.
constexpr std::ptrdiff_t most_waiting = 16;
std::ptrdiff_t places() {
  return std::max(2, static_cast<int>(all_cores()));
}

/// A request as it was read.
struct LiveRequest {
  Client client;
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

LiveRequest read_request(const std::string& text, const std::set<std::string>& records,
                         MotionLibrary& library) {
  Json json = parse_json(text, "the page: ");
  LiveRequest request{
      {json.at("page"), kind_of(json.at("kind")), json.at("sequence")}, json.value("member", 0), {}, {}};
  constexpr std::size_t longest_name = 64;
  constexpr int most_members = 100;
  if (request.client.page.size() > longest_name) throw InputError("the page: page: must be a short name");
  if (request.member < 0 || request.member > most_members)
    throw InputError(fmt::format("the page: member = {}: must be 0 to {}", request.member, most_members));
  request.state = json.at("state");
  request.read = read_state(request.state, records, library);
  if (request.client.kind == Kind::engine && request.read.series.engine == nullptr)
    throw InputError("the page: state.engine: missing, must be an engine");
  return request;
}

/// `whole`, and what is wrong with each value alone that a state has in the place of a sound one's.
std::vector<std::string> faults_of(const Json& asked, const Json* sound, const std::string& whole,
                                   const std::set<std::string>& records, MotionLibrary& library) {
  constexpr std::size_t most_changes = 64;
  std::vector<std::string> lines{whole};
  const Json changes = sound == nullptr ? Json::array() : Json(Json::diff(*sound, asked));
  for (std::size_t i = 0; i < std::min(most_changes, changes.size()); ++i) {
    if (changes[i].at("op") != "replace") continue;
    try {
      read_state(sound->patch(Json::array({changes[i]})), records, library);
    } catch (const std::invalid_argument& error) {
      if (std::ranges::find(lines, error.what()) == lines.end()) lines.emplace_back(error.what());
    } catch (const nlohmann::json::exception&) {
      continue;  // a value that needs others
    }
  }
  return lines;
}

/// @throws Faults as faults_of().
LiveRequest read_request(const std::string& text, const std::set<std::string>& records,
                         MotionLibrary& library, SoundState& sound) {
  try {
    LiveRequest request = read_request(text, records, library);
    const std::lock_guard lock(sound.mutex);
    sound.state = std::make_shared<const Json>(request.state);
    return request;
  } catch (const std::invalid_argument& error) {
    const Json asked = parse_json(text, "the page: ").value("state", Json());
    std::unique_lock lock(sound.mutex);
    const std::shared_ptr<const Json> before = sound.state;
    lock.unlock();
    throw Faults(faults_of(asked, before.get(), error.what(), records, library));
  }
}

/// An engine's run as exact_answers.hpp has a motion, of `stride` samples one; of a member of a cloud times
/// and angles alone.
Json told(const LiveState& state, const WorkerRun& run, std::size_t stride, bool member) {
  const History& history = run.run.history;
  if (member) return {{"track", plots::player_track(history, stride)}};
  Json answer;
  add_track(answer,
            plots::player_track(history, stride,
                                {state.series.engine->full_name(), "#0072b2", "(8,3)", true, false}),
            observed_impacts(state.scene, history, chatter_speed(state.scene)));
  const auto& bodies = run.run.bodies;
  if (bodies) add_energies(answer, state.scene, history.times, bodies->energy, stride);
  answer["verdict"] =
      motion_verdict(state.scene, history,
                     bodies ? support_of(bodies->penetration, bodies->unsupported_since) : SupportLoss{});
  answer["warnings"] = run.run.warnings;
  return answer;
}

Json solved(const LiveRequest& request, const Limits& limits) {
  const LiveState& state = request.read;
  const Json asked{{"scene", request.state.at("scene")},
                   {"interval", static_cast<double>(kept_stride(state)) * state.dt},
                   {"member", request.member},
                   {"spread", state.spread}};
  const ProcessEnd end = run_process(worker_folder() / "rockstack_exact", asked.dump(), limits);
  if (end.cancelled) return {{"dropped", true}};
  if (end.timed_out) return {{"failure", fmt::format("not done after {} s", limits.time)}};
  if (end.signal != 0 || end.exit_code != 0)
    return {
        {"failure", end.last_words.empty() ? "more memory or time than a live page has" : end.last_words}};
  return parse_json(end.reply, "the exact solver's answer ");
}

Json simulated(const LiveRequest& request, const Limits& limits) {
  const LiveState& state = request.read;
  const bool member = request.member > 0;
  const Scene scene =
      member ? perturbed(state.scene, {request.member, state.spread}, request.member) : state.scene;
  const WorkerRun run =
      run_in_worker(*state.series.engine, scene, state.dt, state.series.parameters, 0, limits, !member);
  if (run.status == "stopped") return {{"dropped", true}};
  if (run.status != "done") return {{"failure", run.status + ": " + run.reason}};
  return told(state, run, kept_stride(state), member);
}

}  // namespace

void Scheduler::note(const Client& client) {
  constexpr std::size_t most_pages = 64;
  const std::lock_guard lock(mutex_);
  const auto [entry, fresh] = newest_.try_emplace(client.page);
  if (fresh) pages_.push_back(client.page);
  std::uint64_t& newest = entry->second[static_cast<std::size_t>(client.kind)];
  newest = std::max(newest, client.sequence);
  if (pages_.size() <= most_pages) return;
  newest_.erase(pages_.front());
  pages_.pop_front();
}

bool Scheduler::is_superseded(const Client& client) const {
  const std::lock_guard lock(mutex_);
  const auto found = newest_.find(client.page);
  return found != newest_.end() && found->second[static_cast<std::size_t>(client.kind)] > client.sequence;
}

void Scheduler::serve(Kind kind, const std::function<bool()>& cancelled, const std::function<void()>& run) {
  constexpr std::chrono::milliseconds tick{5};
  constexpr std::chrono::seconds longest_wait{10};
  const auto held = [](std::counting_semaphore<>& semaphore) {
    const auto release = [](std::counting_semaphore<>* one) { one->release(); };
    return std::unique_ptr<std::counting_semaphore<>, decltype(release)>(&semaphore, release);
  };
  Queue& queue = kind == Kind::exact ? exact_ : engines_;
  const auto end = std::chrono::steady_clock::now() + longest_wait;
  if (!queue.places.try_acquire()) {
    if (!queue.waiting.try_acquire()) throw Busy();
    const auto waits = held(queue.waiting);
    while (!queue.places.try_acquire_for(tick)) {
      if (cancelled()) return;
      if (std::chrono::steady_clock::now() > end) throw Busy();
    }
  }
  const auto place = held(queue.places);
  run();
}

Requests::Requests(std::set<std::string> records)
    : records_(std::move(records)), scheduler_(places(), most_waiting) {}

std::size_t Requests::most_at_once() const {
  return static_cast<std::size_t>(2 * (places() + most_waiting));
}

std::string Requests::answer(const std::string& text, const std::function<bool()>& gone) {
  const auto start = std::chrono::steady_clock::now();
  const LiveRequest request = read_request(text, records_, library_, sound_);
  scheduler_.note(request.client);
  const std::function<bool()> cancelled = [&] { return scheduler_.is_superseded(request.client) || gone(); };
  const Limits limits{
      .time = longest_run, .memory = run_memory, .reply = longest_answer, .cancelled = &cancelled};
  Json answer{{"dropped", true}};
  scheduler_.serve(request.client.kind, cancelled, [&] {
    const bool exact = request.client.kind == Kind::exact || request.read.series.engine == nullptr;
    answer = exact ? solved(request, limits) : simulated(request, limits);
  });
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  answer["milliseconds"] = taken.count();
  return answer.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string Requests::files(const std::string& text) {
  const Json json = parse_json(text, "the page: ");
  const Json& state = json.at("state");
  const LiveState read = read_state(state, records_, library_);
  const Json files{{"scene", state_scene_text(state)},
                   {"suite", state_suite_text(state, read, json.at("name"), json.value("runs", 0))}};
  return files.dump();
}

}  // namespace rockstack::live
