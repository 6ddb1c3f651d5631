#include "comparisons/interfaces/live/answers.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/energy.hpp"
#include "comparisons/measures/metrics/impacts.hpp"
#include "comparisons/measures/metrics/motion_verdict.hpp"
#include "comparisons/measures/results/reactions.hpp"
#include "plots/data/contacts.hpp"
#include "plots/pages/base64.hpp"
#include "plots/pages/player.hpp"

namespace rockstack::live {
namespace {

using Json = nlohmann::ordered_json;
using plots::base64;

/// Rows of `width` numbers of the samples 0, stride, 2 stride, … and the last.
std::vector<double> kept_rows(const std::vector<double>& values, std::size_t width, std::size_t stride) {
  const std::size_t size = values.size() / width;
  std::vector<double> kept;
  for (std::size_t i = 0; i < size; i += stride)
    kept.insert(kept.end(), values.begin() + static_cast<std::ptrdiff_t>(i * width),
                values.begin() + static_cast<std::ptrdiff_t>((i + 1) * width));
  if (size > 0 && (size - 1) % stride != 0)
    kept.insert(kept.end(), values.end() - static_cast<std::ptrdiff_t>(width), values.end());
  return kept;
}

std::string packed(const std::vector<double>& values) {
  return base64({values.begin(), values.end()});
}

/// The history with its events among its samples, of which each tells its angles; what else a sample tells
/// is that of the sample before.
History with_events(const History& history) {
  if (history.size() == 0) return history;
  const auto blocks = static_cast<std::size_t>(history.blocks);
  History merged;
  merged.blocks = history.blocks;
  const auto add = [&](double time, std::span<const double> angles, std::size_t sample) {
    merged.times.push_back(time);
    merged.angles.insert(merged.angles.end(), angles.begin(), angles.end());
    const auto copy = [&](const std::vector<double>& from, std::vector<double>& to, std::size_t width) {
      if (from.empty()) return;
      const auto row = from.begin() + static_cast<std::ptrdiff_t>(sample * width);
      to.insert(to.end(), row, row + static_cast<std::ptrdiff_t>(width));
    };
    copy(history.slips, merged.slips, blocks);
    copy(history.places, merged.places, 2 * blocks);
  };
  auto event = history.events.begin();
  for (std::size_t i = 0; i < history.size(); ++i) {
    for (; event != history.events.end() && event->time < history.times[i]; ++event)
      if (merged.times.empty() || event->time > merged.times.back())
        add(event->time, event->angles, i > 0 ? i - 1 : 0);
    add(history.times[i], history.angles_at(i), i);
  }
  return merged;
}

/// Motion as the player reads it.
Json track_of(const History& history, std::size_t stride) {
  const auto blocks = static_cast<std::size_t>(history.blocks);
  Json track{{"times", packed(kept_rows(history.times, 1, stride))},
             {"angles", packed(kept_rows(history.angles, blocks, stride))}};
  if (!history.slips.empty()) track["slips"] = packed(kept_rows(history.slips, blocks, stride));
  if (!history.places.empty()) track["places"] = packed(kept_rows(history.places, 2 * blocks, stride));
  return track;
}

Json impacts_of(const std::vector<ImpactTime>& impacts) {
  constexpr std::size_t most = 400;
  Json list = Json::array();
  for (const ImpactTime& impact : impacts)
    if (list.size() < most) list.push_back({impact.time, impact.interface, sign(impact.side)});
  return list;
}

Json times_of(const Json& impacts) {
  Json times = Json::array();
  for (const Json& impact : impacts) times.push_back(impact[0]);
  return times;
}

void add_reactions(Json& track, const Scene& scene, const History& history) {
  std::vector<double> rows;
  const auto blocks = static_cast<std::size_t>(history.blocks);
  const std::vector<Reaction> reactions = reactions_of(scene, history);
  rows.reserve(3 * reactions.size());
  for (std::size_t from = 0; from < reactions.size(); from += blocks) {
    const std::span<const Reaction> row(reactions.data() + from, blocks);
    for (const Reaction& reaction : row) rows.push_back(reaction.normal);
    for (const Reaction& reaction : row) rows.push_back(reaction.tangential);
    for (const Reaction& reaction : row) rows.push_back(reaction.centre);
  }
  track["reaction_times"] = packed(history.times);
  track["reactions"] = packed(rows);
}

Json events_of(const Scene& scene, const History& history) {
  std::vector<plots::PatternSpan> spans;
  if (history.size() > 0)
    spans.push_back({history.times.front(), history.times.back(), name(history.patterns[0])});
  std::vector<plots::PatternChange> changes;
  changes.reserve(history.events.size());
  for (const Event& event : history.events) {
    const auto interface = static_cast<std::size_t>(event.interface) - 1;
    const double approach = std::abs(relative_at(event.before, interface));
    changes.push_back(
        {event.time, name(event.kind), event.interface, name(event.from), name(event.to), approach});
    if (!spans.empty() && changes.back().to == spans.back().pattern) continue;
    if (!spans.empty()) spans.back().to = event.time;
    spans.push_back(
        {event.time, history.times.empty() ? event.time : history.times.back(), changes.back().to});
  }
  return plots::player_events(spans, changes, chatter_speed(scene), history.blocks);
}

Json ground_of(const Scene& scene, const History& history) {
  std::vector<double> values;
  values.reserve(history.size());
  for (const double time : history.times) values.push_back(acceleration(scene.horizontal, time));
  return {{"times", packed(history.times)}, {"values", packed(values)}};
}

/// What the player needs of a scene besides its tracks.
Json stage_of(const Scene& scene, const History& history) {
  double mass = 0;
  Json blocks = Json::array();
  for (const Block& block : scene.blocks) {
    mass += block.mass;
    blocks.push_back({{"width", 2 * block.half_width},
                      {"height", 2 * block.half_height},
                      {"offset", {block.offset_x, block.offset_y}}});
  }
  Json stage{{"title", scene.title},
             {"blocks", std::move(blocks)},
             {"weight", mass * scene.gravity},
             {"events", events_of(scene, history)}};
  if (leaves_pivots(scene.law)) stage["friction"] = friction_of(scene);
  if (!scene.horizontal.empty()) stage["ground"] = ground_of(scene, history);
  return stage;
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
                  std::vector<double> values) {
  const double scale = energy_scale(scene);
  for (double& value : values) value /= scale;
  answer["energy_times"] = packed(times);
  answer["energy"] = packed(values);
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
  answer["stage"] = stage_of(scene, history);
  answer["impacts"] = impacts_of(reported_impacts(history, chatter_speed(scene)));
  Json track = track_of(with_events(history), 1);
  track.update(
      {{"label", "exact"}, {"colour", "#1a1a1a"}, {"dash", "solid"}, {"shown", true}, {"exact", true}});
  track["impacts"] = times_of(answer["impacts"]);
  add_reactions(track, scene, history);
  answer["track"] = std::move(track);
  add_energies(answer, scene, history.times, exact_energies(scene, history));
  answer["verdict"] = motion_verdict(scene, history);
  return answer;
}

Json exact_member(const Scene& scene, double interval) {
  SolveOptions options = options_for(scene, interval);
  options.events = EventsKept::summed;
  return {{"track", track_of(followed(scene, options).first, 1)}};
}

Json engine_answer(const LiveState& state, const WorkerRun& run, std::size_t stride) {
  const History& history = run.run.history;
  Json answer;
  answer["impacts"] = impacts_of(observed_impacts(history, chatter_speed(state.scene)));
  Json track = track_of(history, stride);
  const WorkerEngine& engine = *state.series.engine;
  track.update({{"label", engine.full_name()},
                {"colour", "#0072b2"},
                {"dash", "(8,3)"},
                {"shown", true},
                {"exact", false}});
  track["impacts"] = times_of(answer["impacts"]);
  answer["track"] = std::move(track);
  if (run.run.bodies)
    add_energies(answer, state.scene, kept_rows(history.times, 1, stride),
                 kept_rows(run.run.bodies->energy, 1, stride));
  const auto& bodies = run.run.bodies;
  answer["verdict"] = motion_verdict(
      state.scene, history, bodies ? support_of(bodies->penetration, bodies->unsupported_since) : Support{});
  answer["warnings"] = run.run.warnings;
  return answer;
}

Json engine_member(const WorkerRun& run, std::size_t stride) {
  return {{"track", track_of(run.run.history, stride)}};
}

}  // namespace rockstack::live
