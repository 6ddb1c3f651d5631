#include <fmt/format.h>

#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/provenance.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/studies/round/study.hpp"

namespace rockstack {
namespace {

constexpr std::initializer_list<const char*> state_columns{
    "time",      "tilt",       "azimuth", "axis_x",          "axis_y", "omega_tilt",
    "omega_rim", "omega_axis", "normal",  "friction_needed", "energy"};

void add_state(const RoundState& state, CsvWriter& csv) {
  const Rolling<double>& rolling = state.rolling;
  const double sine = std::sin(rolling.tilt);
  csv.line(state.time, rolling.tilt, rolling.azimuth, sine * std::cos(rolling.azimuth),
           sine * std::sin(rolling.azimuth), rolling.tilt_rate, rolling.omega1, rolling.omega3,
           state.support.normal, state.support.friction, state.energy);
}

std::string history_csv(const RoundMotion& motion) {
  CsvWriter csv;
  csv.line(state_columns);
  for (const RoundState& state : motion.samples) add_state(state, csv);
  return csv.text();
}

std::string events_csv(const RoundMotion& motion) {
  CsvWriter csv;
  csv.line("event", state_columns);
  for (const auto& [kind, state] : motion.events) {
    csv.add(round_events[static_cast<std::size_t>(kind)]);
    add_state(state, csv);
  }
  return csv.text();
}

/// The first turn between two peaks, or from the start to the first of them where it starts from a largest
/// tilt.
std::optional<double> first_turn(const RoundScene& scene, const RoundMotion& motion) {
  std::vector<double> peaks;
  if (scene.tilt > 0 && scene.tilt_rate == 0) peaks.push_back(0);
  for (const auto& [kind, state] : motion.events)
    if (kind == RoundEvent::peak) peaks.push_back(state.rolling.azimuth);
  return peaks.size() < 2 ? std::nullopt : std::optional(peaks[1] - peaks[0]);
}

std::vector<std::string> headline(const RoundScene& scene, const RoundMotion& motion) {
  const auto count = [&](RoundEvent event) {
    return static_cast<std::size_t>(
        std::ranges::count(motion.events, event, [](const auto& one) { return one.first; }));
  };
  std::vector<std::string> sentences;
  const Rolling<double>& last = motion.samples.back().rolling;
  if (motion.toppled)
    sentences.push_back(fmt::format("The column topples at {:.9g} s.", *motion.toppled));
  else
    sentences.push_back(fmt::format(
        "The column {} up to {:g} s; its axis then leans {:.9g} rad, having turned to {:.9g} rad.",
        topples(scene, motion) ? "falls" : "does not topple", scene.duration, last.tilt, last.azimuth));
  sentences.push_back(fmt::format("Its largest tilt is {:.9g} rad, {:.4g} of the slenderness.",
                                  motion.largest_tilt, motion.largest_tilt / scene.body().slenderness()));
  if (const auto direction = plane_of(scene))
    sentences.push_back(
        fmt::format("All keeps it in a plane, {:.6g} rad from x: {}, each of which loses energy.", *direction,
                    counted(count(RoundEvent::impact), "impact")));
  else
    sentences.push_back(
        fmt::format("It passes {} a least tilt, and loses no energy: in this model it never rests.",
                    counted(count(RoundEvent::passage), "time")));
  if (const auto turn = first_turn(scene, motion); turn && !plane_of(scene)) {
    const Cylinder body = scene.body();
    const double across = body.A + body.half_height * body.half_height;
    sentences.push_back(fmt::format(
        "From its first peak to the next it turns by {:.10g} rad; the limit of near passages is {:.10g}.",
        *turn, pi<double> * std::sqrt(body.contact / across)));
  }
  if (scene.steady)
    sentences.push_back(
        fmt::format("It precesses steadily at {:.10g} rad/s.", *steady_precession(scene.body(), scene.tilt)));
  sentences.push_back(fmt::format(
      "Rolling needs a coefficient of friction of {:.4g}; the least force on the ground is {:.4g} of the weight.",
      motion.demand.friction, motion.demand.normal));
  return sentences;
}

}  // namespace

Json write_round(const RoundScene& scene, const RoundMotion& motion, const std::filesystem::path& folder,
                 const std::string& command) {
  write_file(folder / "history.csv", history_csv(motion));
  write_file(folder / "events.csv", events_csv(motion));
  const auto direction = plane_of(scene);
  const auto turn = first_turn(scene, motion);
  const auto or_null = [](const std::optional<double>& number) { return number ? Json(*number) : Json(); };
  Json json{{"title", scene.title},
            {"headline", headline(scene, motion)},
            {"topples", topples(scene, motion)},
            {"topple_time", or_null(motion.toppled)},
            {"largest_tilt", motion.largest_tilt},
            {"slenderness", scene.body().slenderness()},
            {"plane", or_null(direction)},
            {"first_turn", or_null(turn)},
            {"least_normal", motion.demand.normal},
            {"friction_needed", motion.demand.friction},
            {"environment", environment({})},
            {"command", command}};
  write_file(folder / "round.json", json.dump(2) + "\n");
  return json;
}

Json write_round_threshold(const std::string& title, const VariedKey& vary, const RoundThreshold& found,
                           const std::filesystem::path& folder, const std::string& command) {
  CsvWriter csv;
  csv.line("value", "topples_in_space", "topples_in_plane");
  for (const RoundOutcome& one : found.tried) csv.line(one.value, one.space ? 1 : 0, one.plane ? 1 : 0);
  write_file(folder / "threshold.csv", csv.text());
  const auto words = [&](const std::optional<double>& least, bool RoundOutcome::*topples) -> std::string {
    if (found.tried.front().*topples) return "topples at the lowest value tried already";
    return least ? fmt::format("topples first at {} = {:.10g}", vary.key, *least)
                 : "topples at none of the values tried";
  };
  Json json{{"title", title},
            {"headline",
             {fmt::format("In space the column {}; in the plane of x and z it {}.",
                          words(found.space, &RoundOutcome::space), words(found.plane, &RoundOutcome::plane)),
              fmt::format("{} were tried: what is narrower than their distance may be missed.",
                          counted(found.tried.size(), "value"))}},
            {"space", found.space ? Json(*found.space) : Json()},
            {"plane", found.plane ? Json(*found.plane) : Json()},
            {"environment", environment({})},
            {"command", command}};
  write_file(folder / "round.json", json.dump(2) + "\n");
  return json;
}

}  // namespace rockstack
