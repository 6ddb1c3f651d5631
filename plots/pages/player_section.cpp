#include "comparisons/measures/results/csv.hpp"
#include "plots/data/run_files.hpp"
#include "plots/pages/player_data.hpp"
#include "plots/pages/sections.hpp"

namespace rockstack::plots {
namespace {

/// Times of impacts to mark in the player, s: exact ones above the chatter speed, an engine's matched and
/// extra ones.
Json impacts_in(const Run& run, const Json& events) {
  Json times = Json::array();
  if (run.exact()) {
    for (const Json& stop : events["stops"])
      if (stop[4] == 0 && stop[5] == "impact") times.push_back(stop[0]);
  } else {
    for (const AlignedImpact& impact : *impacts_of(run))
      if (impact.engine) times.push_back(*impact.engine);
  }
  return times;
}

void read_forces(const fs::path& file, int blocks, std::size_t samples, Json& track) {
  std::vector<std::string> names{"time"};
  for (const char* stem : {"normal_", "tangential_", "centre_"})
    for (const std::string& name : numbered(stem, blocks)) names.push_back(name);
  const auto columns = read_columns(file, names);
  const std::vector<double>& times = columns.front();
  std::vector<double> rows;
  for (std::size_t i = 0; i < times.size(); ++i)
    for (std::size_t c = 1; c < columns.size(); ++c) rows.push_back(columns[c][i]);
  add_forces(times, rows, blocks, stride_for(times.size(), samples), track);
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
  track["impacts"] = impacts_in(run, events);
  if (const auto file = run.folder / "reactions.csv"; fs::exists(file))
    read_forces(file, history->blocks, samples, track);
  return track;
}

/// The exact run, and two engines that differ from it and from each other, at their coarsest steps, or where
/// others are `left_out` not at these.
std::set<std::string> shown_at_first(const std::vector<Run>& runs, const std::set<std::string>& left_out) {
  std::set<std::string> engines, names;
  for (const Run& run : runs)
    if (run.exact() ||
        (run.dt && !left_out.contains(run.run) && engines.size() < 2 && engines.insert(run.engine).second))
      names.insert(run.run);
  if (engines.empty() && runs.size() > 1) names.insert(runs[1].run);
  return names;
}

Json data_of(const Comparison& comparison, const ComparedScene& scene, std::size_t players, bool finest) {
  std::vector<Run> runs = shown_runs(comparison, scene.name).exact;
  std::set<std::string> coarse;
  for (const StepLine& line : shown_lines(comparison, scene.name)) {
    for (const Run& run : ends_of(line)) runs.push_back(run);
    if (line.size() > 1) coarse.insert(line.back().run);
  }
  const Run& first = runs.front();
  Json data = player_scene(scene, first.exact() ? *history_of(first) : History{});
  const Json events = data["events"];
  if (!scene.ground_motion.empty()) {
    const auto columns = read_columns(scene.ground_motion, {"time", "horizontal", "vertical"});
    add_ground(columns[0], columns[1], columns[2], data);
  }
  const std::set<std::string> seen = shown_at_first(runs, finest ? coarse : std::set<std::string>());
  constexpr std::size_t numbers = 400'000, most = 20'000, fewest = 500;  // 400,000 numbers are 2.1 MB
  const std::size_t blocks = scene.blocks.size();
  const std::size_t carried = scene.has("forces") ? runs.size() : 1;
  const std::size_t columns = runs.size() * (1 + (scene.slips ? 4 : 1) * blocks) + carried * (1 + 3 * blocks);
  const std::size_t samples = std::clamp(numbers / (players * columns), fewest, most);
  data["tracks"] = Json::array();
  for (const Run& run : runs)
    data["tracks"].push_back(
        track_of(run, events, samples, seen.contains(run.run), coarse.contains(run.run)));
  return data;
}

/// Where the player of a motion by itself stands at first: just before a block leans by a part of what it
/// will, with angles as large as can be seen.
Json start_of(const History& history) {
  constexpr double part = 0.01, seen = 0.15, most = 100;
  const double largest = largest_magnitude(history.angles);
  std::size_t row = 0;
  const auto leans = [&](double angle) { return std::abs(angle) > part * largest; };
  while (row + 1 < history.size() && std::ranges::none_of(history.angles_at(row), leans)) ++row;
  const double before = row > 0 ? history.times[row - 1] : 0;
  return {{"time", row + 1 < history.size() ? before : 0},
          {"gain", largest > 0 ? std::clamp(seen / largest, 1.0, most) : 1},
          {"overlaid", false},
          {"chatter", false}};
}

}  // namespace

std::string player_section(const Comparison& comparison, std::size_t scene, const Json& start) {
  const ComparedScene& shown = comparison.scenes[scene];
  const bool finest = start.is_object() && start.value("finest", false);
  Json data = data_of(comparison, shown, comparison.scenes.size(), finest);
  if (!start.is_null()) data["start"] = start;
  if (start.is_null() && shown.alone)
    data["start"] = start_of(*history_of(done_runs(comparison, shown.name).front()));
  if (!shown.page.empty()) data["scene"] = parse_json(shown.page, "the scene of a page ");
  return filled_in(player_html, {{"id", fmt::format("player-{}", scene + 1)},
                                 {"title", escaped(shown.title)},
                                 {"data", for_script(data)}});
}

}  // namespace rockstack::plots
