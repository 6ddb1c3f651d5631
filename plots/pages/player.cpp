#include "plots/pages/player.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "comparisons/results/csv.hpp"
#include "plots/data/events.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/style.hpp"
#include "plots/pages/base64.hpp"
#include "plots/pages/html.hpp"
#include "plots/pages/template.hpp"

namespace rockstack::plots {
namespace {

using Columns = std::vector<std::vector<double>>;

/// Every n-th sample and the last, so that no more than `most` and one are left.
std::vector<std::size_t> kept_samples(std::size_t size, std::size_t most) {
  std::vector<std::size_t> kept;
  const std::size_t stride = std::max<std::size_t>(1, (size + most - 1) / most);
  for (std::size_t i = 0; i < size; i += stride) kept.push_back(i);
  if (size > 0 && kept.back() + 1 != size) kept.push_back(size - 1);
  return kept;
}

/// The kept samples row by row, from the columns `first` to the last.
std::string packed_rows(const Columns& columns, std::size_t first, const std::vector<std::size_t>& kept) {
  std::vector<float> numbers;
  for (const std::size_t sample : kept)
    for (std::size_t c = first; c < columns.size(); ++c)
      numbers.push_back(static_cast<float>(columns[c][sample]));
  return base64(numbers);
}

Columns read_samples(const std::filesystem::path& file, const std::vector<std::string>& stems, int blocks) {
  std::vector<std::string> names{"time"};
  for (const std::string& stem : stems)
    for (const std::string& name : numbered(stem, blocks)) names.push_back(name);
  return read_columns(file, names);
}

/// Times of an engine's own impacts, matched or extra, s.
std::vector<double> own_impacts(const Run& run) {
  const std::filesystem::path file = run.folder / "impacts.csv";
  if (!std::filesystem::exists(file)) return {};
  std::vector<double> times = read_columns(file, {"engine_time"})[0];
  std::erase_if(times, [](double time) { return std::isnan(time); });
  return times;
}

/// A motion with its events, whose exact times lie between samples, among the samples.
Columns with_events(Columns motion, const Run& run, int blocks) {
  const Columns events = read_samples(run.folder / "events.csv", {"theta_"}, blocks);
  Columns merged(motion.size());
  std::size_t next = 0;
  const auto add = [&](const Columns& from, std::size_t row) {
    for (std::size_t c = 0; c < merged.size(); ++c) merged[c].push_back(from[c][row]);
  };
  for (std::size_t i = 0; i < motion[0].size(); ++i) {
    for (; next < events[0].size() && events[0][next] < motion[0][i]; ++next)
      if (i > 0 && events[0][next] > merged[0].back()) add(events, next);
    add(motion, i);
  }
  return merged;
}

void add_reactions(Json& track, const Run& run, int blocks, std::size_t samples) {
  const Columns reactions =
      read_samples(run.folder / "reactions.csv", {"normal_", "tangential_", "centre_"}, blocks);
  const std::vector<std::size_t> kept = kept_samples(reactions[0].size(), samples);
  track["reaction_times"] = packed_rows({reactions[0]}, 0, kept);
  track["reactions"] = packed_rows(reactions, 1, kept);
}

Json track(const Run& run, int blocks, const Style& style, std::size_t samples, bool shown) {
  Columns motion = read_samples(run.folder / "history.csv", {"theta_"}, blocks);
  if (run.exact()) motion = with_events(std::move(motion), run, blocks);
  const std::vector<std::size_t> kept = kept_samples(motion[0].size(), samples);
  Json json{{"label", run_label(run)},
            {"colour", style.colour},
            {"dash", style.dash},
            {"shown", shown},
            {"times", packed_rows({motion[0]}, 0, kept)},
            {"angles", packed_rows(motion, 1, kept)},
            {"impacts", own_impacts(run)}};
  if (run.exact() && std::filesystem::exists(run.folder / "reactions.csv"))
    add_reactions(json, run, blocks, samples);
  return json;
}

/// −1, 0 or 1 an interface.
std::vector<int> sides_of(const std::string& pattern, int blocks) {
  for (const auto& [name, sides] : two_block_patterns())
    if (blocks == 2 && pattern == name) return {sides[0], sides[1]};
  std::vector<int> sides;
  for (const char letter : pattern) sides.push_back(letter == 'L' ? -1 : letter == 'R' ? 1 : 0);
  sides.resize(static_cast<std::size_t>(blocks), 0);
  return sides;
}

Json spans_of(const std::vector<PatternSpan>& spans, int blocks) {
  Json list = Json::array();
  for (const PatternSpan& span : spans)
    list.push_back({span.from, span.pattern, sides_of(span.pattern, blocks)});
  return list;
}

/// Impacts by time; chatter beyond what a page can hold is left out.
Json impacts_of(const std::vector<PatternChange>& changes, double chatter_speed) {
  constexpr std::size_t most = 4000;
  Json list = Json::array();
  for (const PatternChange& change : changes) {
    const bool chatter = change.approach < chatter_speed;
    if (list.size() < most || !chatter)
      list.push_back({change.time, change.interface, change.from, change.to, chatter ? 1 : 0});
  }
  return list;
}

/// The exact run, and two engines that differ from it and from each other.
std::set<std::string> shown_at_first(const std::vector<Run>& runs) {
  std::set<std::string> engines, names;
  for (const Run& run : runs)
    if (run.exact() || (!std::isnan(run.dt) && engines.size() < 2 && engines.insert(run.engine).second))
      names.insert(run.name);
  if (engines.empty() && runs.size() > 1) names.insert(runs[1].name);
  return names;
}

std::size_t samples_for(std::size_t tracks, int blocks, std::size_t players) {
  constexpr std::size_t numbers = 400'000, most = 20'000, fewest = 500;  // 400,000 numbers are 2.1 MB
  const std::size_t columns =
      tracks * (1 + static_cast<std::size_t>(blocks)) + 1 + 3 * static_cast<std::size_t>(blocks);
  return std::clamp(numbers / (players * columns), fewest, most);
}

Json ground_of(const ComparedScene& scene) {
  const Columns columns = read_columns(scene.ground_motion, {"time", "horizontal"});
  constexpr std::size_t most = 5000;
  const std::vector<std::size_t> kept = kept_samples(columns[0].size(), most);
  return {{"times", packed_rows({columns[0]}, 0, kept)}, {"values", packed_rows(columns, 1, kept)}};
}

Json stack_of(const ComparedScene& scene) {
  Json list = Json::array();
  for (const StackBlock& block : scene.stack)
    list.push_back({{"width", block.width}, {"height", block.height}});
  return list;
}

double weight_of(const ComparedScene& scene) {
  double mass = 0;
  for (const StackBlock& block : scene.stack) mass += block.mass;
  return mass * scene.gravity;
}

Json events_of(const Run& run, const ComparedScene& scene) {
  Json events{{"spans", Json::array()}, {"impacts", Json::array()}};
  if (!run.exact()) return events;
  const std::vector<double> times = read_columns(run.folder / "history.csv", {"time"})[0];
  const double end = times.empty() ? 0 : times.back();
  events["spans"] = spans_of(read_events(run, scene.blocks, end, starting_pattern(run)).spans, scene.blocks);
  events["impacts"] = impacts_of(read_impact_changes(run, scene.blocks), scene.chatter_speed);
  return events;
}

/// The exact motion's impacts above the chatter speed are its row in the strip.
void add_exact_impacts(Json& track, const Json& events) {
  for (const Json& impact : events["impacts"])
    if (impact[4] == 0) track["impacts"].push_back(impact[0]);
}

Json data_of(const Comparison& comparison, const ComparedScene& scene, std::size_t players) {
  const Shown shown = shown_runs(comparison, scene.name);
  std::vector<Run> runs = shown.exact;
  runs.insert(runs.end(), shown.engines.begin(), shown.engines.end());
  const std::set<std::string> first = shown_at_first(runs);
  const std::size_t samples = samples_for(runs.size(), scene.blocks, players);
  Json data{{"title", scene.title},
            {"blocks", stack_of(scene)},
            {"weight", weight_of(scene)},
            {"events", events_of(runs.front(), scene)},
            {"tracks", Json::array()}};
  for (const Run& run : runs)
    data["tracks"].push_back(track(run, scene.blocks, style_of(run), samples, first.contains(run.name)));
  add_exact_impacts(data["tracks"][0], data["events"]);
  if (!scene.ground_motion.empty()) data["ground"] = ground_of(scene);
  return data;
}

/// Text that ends no element, whatever it holds.
std::string for_script(const Json& data) {
  std::string text;
  for (const char c : data.dump()) text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

}  // namespace

std::string player(const Comparison& comparison, const ComparedScene& scene, std::size_t players,
                   const std::string& id, const Json& start) {
  Json data = data_of(comparison, scene, players);
  if (!start.is_null()) data["start"] = start;
  return filled_in(player_html, {{"id", id}, {"title", escaped(scene.title)}, {"data", for_script(data)}});
}

}  // namespace rockstack::plots
