#include "comparisons/interfaces/live/live_state.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/bodies.hpp"
#include "comparisons/measures/metrics/impacts.hpp"
#include "comparisons/measures/metrics/motion_verdict.hpp"
#include "plots/pages/motion_data.hpp"

namespace rockstack::live {
namespace {

using Json = nlohmann::ordered_json;
using plots::packed;

/// Adds a track and its impacts, which it has the times of.
void add_track(Json& answer, Json track, const std::vector<ImpactTime>& impacts) {
  constexpr std::size_t most = 400;
  answer["impacts"] = track["impacts"] = Json::array();
  for (const ImpactTime& impact : std::span(impacts).first(std::min(most, impacts.size()))) {
    answer["impacts"].push_back({impact.time, impact.interface, sign(impact.side)});
    track["impacts"].push_back(impact.time);
  }
  answer["track"] = std::move(track);
}

/// Of the bodies, with what springs of law `compliant` hold.
std::vector<double> exact_energies(const Scene& scene, const History& history) {
  std::vector<double> values = energies(scene, history);
  const auto blocks = static_cast<std::size_t>(history.blocks);
  for (std::size_t i = 0; i < history.spring_energies.size(); ++i)
    values[i / blocks] += history.spring_energies[i].elastic;
  return values;
}

void add_energies(Json& answer, const Scene& scene, const std::vector<double>& times,
                  std::vector<double> values, std::size_t stride) {
  const double scale = energy_scale(scene);
  for (double& value : values) value /= scale;
  answer["energy_times"] = packed(times, 1, stride);
  answer["energy"] = packed(values, 1, stride);
}

/// The motion as far as it can be followed, and why no further.
std::pair<History, std::string> followed(const Scene& scene, const SolveOptions& options) {
  try {
    return {solve(scene, options), ""};
  } catch (const Unfinished& error) {
    return {error.history, error.what()};
  }
}

SolveOptions options_for(const Scene& scene, double interval) {
  SolveOptions options;
  options.sample_times = regular_times(interval, scene.duration);
  return options;
}

}  // namespace

Json exact_answer(const Scene& scene, double interval) {
  SolveOptions options = options_for(scene, interval);
  options.validity = options.peaks = true;
  const auto [history, failure] = followed(scene, options);
  Json answer;
  if (!failure.empty()) answer["failure"] = failure;
  if (history.size() == 0) return answer;
  answer["stage"] = plots::stage_of(scene, history);
  add_track(answer,
            plots::player_track(plots::with_events(history), 1, {"exact", "#1a1a1a", "solid", true, true}),
            reported_impacts(history, chatter_speed(scene)));
  plots::add_forces(plots::forces_of(scene, history), history.blocks, 1, answer["track"]);
  add_energies(answer, scene, history.times, exact_energies(scene, history), 1);
  answer["verdict"] = motion_verdict(scene, history);
  return answer;
}

Json exact_member(const Scene& scene, double interval) {
  SolveOptions options = options_for(scene, interval);
  options.events = EventsKept::summed;
  return {{"track", plots::player_track(followed(scene, options).first, 1)}};
}

Json engine_answer(const LiveState& state, const WorkerRun& run, std::size_t stride) {
  const History& history = run.run.history;
  Json answer;
  add_track(answer,
            plots::player_track(history, stride,
                                {state.series.engine->full_name(), "#0072b2", "(8,3)", true, false}),
            observed_impacts(history, chatter_speed(state.scene)));
  const auto& bodies = run.run.bodies;
  if (bodies) add_energies(answer, state.scene, history.times, bodies->energy, stride);
  answer["verdict"] = motion_verdict(
      state.scene, history, bodies ? support_of(bodies->penetration, bodies->unsupported_since) : Support{});
  answer["warnings"] = run.run.warnings;
  return answer;
}

Json engine_member(const WorkerRun& run, std::size_t stride) {
  return {{"track", plots::player_track(run.run.history, stride)}};
}

}  // namespace rockstack::live
