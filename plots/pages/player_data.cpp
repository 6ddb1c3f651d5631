#include "plots/pages/player_data.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>

#include "comparisons/measures/metrics/impacts.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "plots/data/run_files.hpp"
#include "plots/drawing/style.hpp"
#include "plots/pages/sections.hpp"

namespace rockstack::plots {
namespace {

using Rows = std::vector<double>;

constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Numbers as text for a page: 32-bit floating point, lowest byte first, in base 64.
std::string base64(const std::vector<float>& numbers) {
  std::vector<unsigned char> bytes;
  bytes.reserve(4 * numbers.size());
  for (const float number : numbers)
    for (unsigned shift = 0; shift < 32; shift += 8)
      bytes.push_back(static_cast<unsigned char>((std::bit_cast<std::uint32_t>(number) >> shift) & 0xFFU));
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j) group = group << 8U | (j < count ? bytes[i + j] : 0U);
    for (std::size_t j = 0; j < 4; ++j)
      text += j <= count ? digits[(group >> (18U - 6U * static_cast<unsigned>(j))) & 63U] : '=';
  }
  return text;
}

void append(const Rows& rows, std::size_t width, std::size_t row, Rows& to) {
  const auto from = rows.begin() + static_cast<std::ptrdiff_t>(row * width);
  if (!rows.empty()) to.insert(to.end(), from, from + static_cast<std::ptrdiff_t>(width));
}

/// Between two rows, on a straight line.
void append_between(const Rows& rows, std::size_t width, std::size_t after, double part, Rows& to) {
  for (std::size_t at = after * width; !rows.empty() && at < (after + 1) * width; ++at)
    to.push_back(rows[at - width] * (1 - part) + rows[at] * part);
}

Json spans_of(const History& history) {
  Json list = Json::array();
  for (const PatternSpan& span : pattern_spans(history)) {
    Json sides = Json::array(), slides = Json::array();
    for (int k = 0; k < span.pattern.size; ++k) {
      sides.push_back(sign(span.pattern[k]));
      slides.push_back(span.pattern.slides[static_cast<std::size_t>(k)]);
    }
    list.push_back({span.from, shown_pattern(span.pattern), sides, slides});
  }
  return list;
}

/// What chatter is made of, each of its bounces first.
constexpr std::array bounces{EventKind::impact, EventKind::touch};
constexpr std::array followers{EventKind::slip, EventKind::stick, EventKind::part};

template <class Kinds>
bool is_among(const Kinds& kinds, EventKind kind) {
  return std::ranges::find(kinds, kind) != kinds.end();
}

/// Events by time, with 1 for chatter: slow bounces, and the starts and ends of sliding and touching that
/// follow them; a landing is none. Chatter beyond what a page can hold is left out.
Json stops_of(const History& history, double chatter_speed) {
  constexpr std::size_t most = 4000;
  Json list = Json::array();
  bool chatter = false;
  for (const Event& event : history.events) {
    const bool bounce = is_among(bounces, event.kind);
    if (bounce) {
      const auto interface = static_cast<std::size_t>(event.interface) - 1;
      chatter = std::abs(relative_at(event.before, interface)) < chatter_speed &&
                event.from.contacts[interface] != Contact::apart;
    }
    const bool slow = chatter && (bounce || is_among(followers, event.kind));
    if (list.size() < most || !slow)
      list.push_back({event.time, event.interface, shown_pattern(event.from), shown_pattern(event.to),
                      slow ? 1 : 0, name(event.kind)});
  }
  return list;
}

}  // namespace

std::size_t stride_for(std::size_t size, std::size_t most) {
  return std::max<std::size_t>(1, (size + most - 1) / most);
}

std::string packed(const std::vector<double>& rows, std::size_t width, std::size_t stride) {
  const std::size_t size = rows.size() / width;
  std::vector<float> numbers;
  const auto keep = [&](std::size_t row) {
    for (std::size_t at = row * width; at < (row + 1) * width; ++at)
      numbers.push_back(static_cast<float>(rows[at]));
  };
  for (std::size_t row = 0; row < size; row += stride) keep(row);
  if (size > 0 && (size - 1) % stride != 0) keep(size - 1);
  return base64(numbers);
}

Json player_track(const History& history, std::size_t stride) {
  const auto blocks = static_cast<std::size_t>(history.blocks);
  Json track{{"times", packed(history.times, 1, stride)}, {"angles", packed(history.angles, blocks, stride)}};
  if (!history.slips.empty()) track["slips"] = packed(history.slips, blocks, stride);
  if (!history.centres.empty()) track["places"] = packed(history.centres, 2 * blocks, stride);
  return track;
}

Json player_track(const History& history, std::size_t stride, const TrackLook& look) {
  Json track{{"label", look.label},
             {"colour", look.colour},
             {"dash", look.dash},
             {"shown", look.shown},
             {"exact", look.exact}};
  track.update(player_track(history, stride));
  return track;
}

History with_events(const History& history) {
  const auto blocks = static_cast<std::size_t>(history.blocks);
  History merged;
  merged.blocks = history.blocks;
  auto event = history.events.begin();
  for (std::size_t i = 0; i < history.size(); ++i) {
    for (; event != history.events.end() && event->time < history.times[i]; ++event) {
      if (i == 0 || event->time <= merged.times.back()) continue;
      const double before = history.times[i - 1], part = (event->time - before) / (history.times[i] - before);
      merged.times.push_back(event->time);
      append(event->angles, blocks, 0, merged.angles);
      append_between(history.slips, blocks, i, part, merged.slips);
      append_between(history.centres, 2 * blocks, i, part, merged.centres);
    }
    merged.times.push_back(history.times[i]);
    append(history.angles, blocks, i, merged.angles);
    append(history.slips, blocks, i, merged.slips);
    append(history.centres, 2 * blocks, i, merged.centres);
  }
  return merged;
}

void add_forces(const InterfaceForces& forces, int blocks, std::size_t stride, Json& track) {
  track["reaction_times"] = packed(forces.times, 1, stride);
  track["reactions"] = packed(forces.rows, 3 * static_cast<std::size_t>(blocks), stride);
}

Json player_events(const History& history, double chatter_speed) {
  return {{"spans", spans_of(history)}, {"stops", stops_of(history, chatter_speed)}};
}

Json player_scene(const PlayerScene& scene, const Json& events) {
  double mass = 0;
  Json blocks = Json::array();
  for (const Block& block : scene.blocks) {
    mass += block.mass;
    blocks.push_back({{"width", 2 * block.half_width},
                      {"height", 2 * block.half_height},
                      {"offset", {block.offset_x, block.offset_y}}});
  }
  Json json{{"title", scene.title},
            {"blocks", std::move(blocks)},
            {"weight", mass * scene.gravity},
            {"events", events}};
  if (!scene.friction.empty()) json["friction"] = scene.friction;
  constexpr std::size_t most = 5000;
  const std::size_t stride = stride_for(scene.ground_times.size(), most);
  if (!scene.ground_times.empty())
    json["ground"] = {{"times", packed(scene.ground_times, 1, stride)},
                      {"values", packed(scene.ground, 1, stride)}};
  return json;
}

std::string for_script(const Json& data) {
  std::string text;
  for (const char c : data.dump()) text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

namespace {

/// Times of an engine's own impacts, matched or extra, s.
Json own_impacts(const Run& run) {
  Json times = Json::array();
  for (const AlignedImpact& impact : *impacts_of(run))
    if (impact.engine) times.push_back(*impact.engine);
  return times;
}

/// The exact motion's impacts above the chatter speed are its row in the strip.
Json exact_impacts(const Json& events) {
  Json times = Json::array();
  for (const Json& stop : events["stops"])
    if (stop[4] == 0 && stop[5] == "impact") times.push_back(stop[0]);
  return times;
}

InterfaceForces read_forces(const std::filesystem::path& file, int blocks) {
  std::vector<std::string> names{"time"};
  for (const char* stem : {"normal_", "tangential_", "centre_"})
    for (const std::string& name : numbered(stem, blocks)) names.push_back(name);
  const auto columns = read_columns(file, names);
  InterfaceForces forces{columns.front(), {}};
  for (std::size_t i = 0; i < forces.times.size(); ++i)
    for (std::size_t c = 1; c < columns.size(); ++c) forces.rows.push_back(columns[c][i]);
  return forces;
}

/// `coarse`: another step of the same line has a track too.
Json track_of(const Run& run, const Json& events, std::size_t samples, bool shown, bool coarse) {
  const auto history = history_of(run);
  const History merged = run.exact() ? with_events(*history) : History{};
  const History& motion = run.exact() ? merged : *history;
  const Style style = style_of(run);
  Json track =
      player_track(motion, stride_for(motion.size(), samples),
                   {run_label(run), style.colour, coarse ? "(5,5)" : style.dash, shown, run.exact()});
  track["impacts"] = run.exact() ? exact_impacts(events) : own_impacts(run);
  if (const auto file = run.folder / "reactions.csv"; run.exact() && std::filesystem::exists(file)) {
    const InterfaceForces forces = read_forces(file, history->blocks);
    add_forces(forces, history->blocks, stride_for(forces.times.size(), samples), track);
  }
  return track;
}

/// The exact run, and two engines that differ from it and from each other, at their coarsest steps.
std::set<std::string> shown_at_first(const std::vector<Run>& runs) {
  std::set<std::string> engines, names;
  for (const Run& run : runs)
    if (run.exact() || (run.dt && engines.size() < 2 && engines.insert(run.engine).second))
      names.insert(run.run);
  if (engines.empty() && runs.size() > 1) names.insert(runs[1].run);
  return names;
}

std::size_t samples_for(std::size_t tracks, int blocks, bool slips, std::size_t players) {
  constexpr std::size_t numbers = 400'000, most = 20'000, fewest = 500;  // 400,000 numbers are 2.1 MB
  const std::size_t columns = tracks * (1 + (slips ? 4 : 1) * static_cast<std::size_t>(blocks)) + 1 +
                              3 * static_cast<std::size_t>(blocks);
  return std::clamp(numbers / (players * columns), fewest, most);
}

Json data_of(const Comparison& comparison, const ComparedScene& scene, std::size_t players) {
  std::vector<Run> runs = shown_runs(comparison, scene.name).exact;
  std::set<std::string> coarse;
  for (const StepLine& line : shown_lines(comparison, scene.name)) {
    for (const Run& run : ends_of(line)) runs.push_back(run);
    if (line.size() > 1) coarse.insert(line.back().run);
  }
  const Run& first = runs.front();
  const Json events = player_events(first.exact() ? *history_of(first) : History{}, scene.chatter_speed);
  PlayerScene stage{scene.title, scene.stack, scene.gravity, {}, {}, {}};
  if (tells_slips(first)) stage.friction = scene.friction;
  if (!scene.ground_motion.empty()) {
    auto columns = read_columns(scene.ground_motion, {"time", "horizontal"});
    stage.ground_times = std::move(columns[0]), stage.ground = std::move(columns[1]);
  }
  Json data = player_scene(stage, events);
  const std::set<std::string> seen = shown_at_first(runs);
  const std::size_t samples = samples_for(runs.size(), scene.blocks(), scene.slips, players);
  data["tracks"] = Json::array();
  for (const Run& run : runs)
    data["tracks"].push_back(
        track_of(run, events, samples, seen.contains(run.run), coarse.contains(run.run)));
  return data;
}

}  // namespace

std::string player_anchor(std::size_t scene) {
  return fmt::format("player-{}-stage", scene + 1);
}

std::string player_section(const Comparison& comparison, std::size_t scene, const Json& start) {
  const ComparedScene& shown = comparison.scenes[scene];
  Json data = data_of(comparison, shown, comparison.scenes.size());
  if (!start.is_null()) data["start"] = start;
  return filled_in(player_html, {{"id", fmt::format("player-{}", scene + 1)},
                                 {"title", escaped(shown.title)},
                                 {"data", for_script(data)}});
}

}  // namespace rockstack::plots
