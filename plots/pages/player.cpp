#include "plots/pages/player.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "comparisons/measures/results/csv.hpp"
#include "plots/data/contacts.hpp"
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

/// The columns that say how blocks lie, each group as the history has it: angles, slips, and x and y of each
/// block in turn.
std::vector<std::string> motion_columns(const Run& run, int blocks) {
  std::vector<std::string> names = numbered("theta_", blocks);
  if (has_column(run, "slip_1"))
    for (const std::string& name : numbered("slip_", blocks)) names.push_back(name);
  if (has_column(run, "x_1"))
    for (int k = 1; k <= blocks; ++k)
      names.insert(names.end(), {fmt::format("x_{}", k), fmt::format("y_{}", k)});
  names.insert(names.begin(), "time");
  return names;
}

/// A motion with its events, whose exact times lie between samples, among the samples. What events do not say
/// is on the straight line between samples.
Columns with_events(const Columns& motion, const Run& run, int blocks) {
  const Columns events = read_samples(run.folder / "events.csv", {"theta_"}, blocks);
  Columns merged(motion.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < motion[0].size(); ++i) {
    for (; next < events[0].size() && events[0][next] < motion[0][i]; ++next) {
      const double time = events[0][next];
      if (i == 0 || time <= merged[0].back()) continue;
      const double part = (time - motion[0][i - 1]) / (motion[0][i] - motion[0][i - 1]);
      for (std::size_t c = 0; c < merged.size(); ++c)
        merged[c].push_back(c < events.size() ? events[c][next]
                                              : motion[c][i - 1] * (1 - part) + motion[c][i] * part);
    }
    for (std::size_t c = 0; c < merged.size(); ++c) merged[c].push_back(motion[c][i]);
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

/// Each group of a motion's columns under its own name.
void add_motion(Json& track, const Columns& motion, int blocks, bool slips,
                const std::vector<std::size_t>& kept) {
  const auto width = static_cast<std::ptrdiff_t>(blocks);
  auto from = motion.begin() + 1;
  const auto add = [&](const char* name, std::ptrdiff_t count) {
    track[name] = packed_rows(Columns(from, from + count), 0, kept);
    from += count;
  };
  add("angles", width);
  if (slips) add("slips", width);
  if (from != motion.end()) add("places", 2 * width);
}

Json track(const Run& run, int blocks, const Style& style, std::size_t samples, bool shown) {
  Columns motion = read_columns(run.folder / "history.csv", motion_columns(run, blocks));
  if (run.exact()) motion = with_events(motion, run, blocks);
  const std::vector<std::size_t> kept = kept_samples(motion[0].size(), samples);
  Json json{{"label", run_label(run)},    {"colour", style.colour},
            {"dash", style.dash},         {"shown", shown},
            {"exact", run.exact()},       {"times", packed_rows({motion[0]}, 0, kept)},
            {"impacts", own_impacts(run)}};
  add_motion(json, motion, blocks, has_column(run, "slip_1"), kept);
  if (run.exact() && std::filesystem::exists(run.folder / "reactions.csv"))
    add_reactions(json, run, blocks, samples);
  return json;
}

Json spans_of(const std::vector<PatternSpan>& spans, int blocks) {
  Json list = Json::array();
  for (const PatternSpan& span : spans) {
    Json sides = Json::array(), slides = Json::array();
    for (const NamedContact& contact : contacts_in(span.pattern, blocks)) {
      sides.push_back(contact.side);
      slides.push_back(contact.slide);
    }
    list.push_back({span.from, shown_pattern(span.pattern), sides, slides});
  }
  return list;
}

/// What chatter is made of, each of its bounces first.
constexpr std::array bounces{"impact", "touch"};
constexpr std::array followers{"slip", "stick", "part"};

template <class Kinds>
bool is_among(const Kinds& kinds, const std::string& kind) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

/// Events by time, with 1 for chatter: slow bounces, and the starts and ends of sliding and touching that
/// follow them; a landing is none. Chatter beyond what a page can hold is left out.
Json stops_of(const std::vector<PatternChange>& changes, double chatter_speed, int blocks) {
  constexpr std::size_t most = 4000;
  Json list = Json::array();
  bool chatter = false;
  for (const PatternChange& change : changes) {
    const auto interface = static_cast<std::size_t>(change.interface) - 1;
    const bool bounce = is_among(bounces, change.kind);
    if (bounce)
      chatter = change.approach < chatter_speed && contacts_in(change.from, blocks)[interface].side != 2;
    const bool slow = chatter && (bounce || is_among(followers, change.kind));
    if (list.size() < most || !slow)
      list.push_back({change.time, change.interface, shown_pattern(change.from), shown_pattern(change.to),
                      slow ? 1 : 0, change.kind});
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

std::size_t samples_for(std::size_t tracks, int blocks, bool slips, std::size_t players) {
  constexpr std::size_t numbers = 400'000, most = 20'000, fewest = 500;  // 400,000 numbers are 2.1 MB
  const std::size_t columns = tracks * (1 + (slips ? 4 : 1) * static_cast<std::size_t>(blocks)) + 1 +
                              3 * static_cast<std::size_t>(blocks);
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
    list.push_back(
        {{"width", block.width}, {"height", block.height}, {"offset", {block.offset_x, block.offset_y}}});
  return list;
}

double weight_of(const ComparedScene& scene) {
  double mass = 0;
  for (const StackBlock& block : scene.stack) mass += block.mass;
  return mass * scene.gravity;
}

Json events_of(const Run& run, const ComparedScene& scene) {
  if (!run.exact()) return player_events({}, {}, 0, scene.blocks);
  const std::vector<double> times = read_columns(run.folder / "history.csv", {"time"})[0];
  const double end = times.empty() ? 0 : times.back();
  return player_events(read_events(run, scene.blocks, end, starting_pattern(run)).spans,
                       read_changes(run, scene.blocks), scene.chatter_speed, scene.blocks);
}

/// The exact motion's impacts above the chatter speed are its row in the strip.
void add_exact_impacts(Json& track, const Json& events) {
  for (const Json& stop : events["stops"])
    if (stop[4] == 0 && stop[5] == "impact") track["impacts"].push_back(stop[0]);
}

Json data_of(const Comparison& comparison, const ComparedScene& scene, std::size_t players) {
  const Shown shown = shown_runs(comparison, scene.name);
  std::vector<Run> runs = shown.exact;
  runs.insert(runs.end(), shown.engines.begin(), shown.engines.end());
  const std::set<std::string> first = shown_at_first(runs);
  const std::size_t samples = samples_for(runs.size(), scene.blocks, scene.slips, players);
  Json data{{"title", scene.title},
            {"blocks", stack_of(scene)},
            {"weight", weight_of(scene)},
            {"events", events_of(runs.front(), scene)},
            {"tracks", Json::array()}};
  for (const Run& run : runs)
    data["tracks"].push_back(track(run, scene.blocks, style_of(run), samples, first.contains(run.name)));
  add_exact_impacts(data["tracks"][0], data["events"]);
  if (has_column(runs.front(), "slip_1")) data["friction"] = scene.friction;
  if (!scene.ground_motion.empty()) data["ground"] = ground_of(scene);
  return data;
}

}  // namespace

Json player_events(const std::vector<PatternSpan>& spans, const std::vector<PatternChange>& changes,
                   double chatter_speed, int blocks) {
  return {{"spans", spans_of(spans, blocks)}, {"stops", stops_of(changes, chatter_speed, blocks)}};
}

std::string for_script(const Json& data) {
  std::string text;
  for (const char c : data.dump()) text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

std::string player(const Comparison& comparison, const ComparedScene& scene, std::size_t players,
                   const std::string& id, const Json& start) {
  Json data = data_of(comparison, scene, players);
  if (!start.is_null()) data["start"] = start;
  return filled_in(player_html, {{"id", id}, {"title", escaped(scene.title)}, {"data", for_script(data)}});
}

}  // namespace rockstack::plots
