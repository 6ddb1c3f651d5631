#include "comparisons/interfaces/live/exact_answers.hpp"

#include <fmt/format.h>

#include "analytic/branches.hpp"
#include "analytic/scene/input/json_reader.hpp"
#include "analytic/scene/input/page_scene.hpp"
#include "analytic/scene/input/scene_file.hpp"
#include "comparisons/measures/metrics/bodies.hpp"
#include "comparisons/measures/metrics/motion_verdict.hpp"
#include "comparisons/suites/suite.hpp"
#include "plots/pages/player_data.hpp"

namespace rockstack::live {
namespace {

/// Energies of the bodies, with what springs of law `compliant` hold.
std::vector<double> exact_energies(const Scene& scene, const History& history) {
  std::vector<double> values = energies(scene, history);
  const auto blocks = static_cast<std::size_t>(history.blocks);
  for (std::size_t i = 0; i < history.spring_energies.size(); ++i)
    values[i / blocks] += history.spring_energies[i].elastic;
  return values;
}

/// What moves the ground, as it was read, and how far.
std::string ground_text(const Scene& scene) {
  std::string text;
  for (const auto& [motion, axis] :
       {std::pair(&scene.horizontal, ""), std::pair(&scene.vertical, "vertical, ")})
    if (!motion->empty())
      text += fmt::format("{}{}, {}peak {:.4g} m/s²", text.empty() ? "" : "; ", motion->source, axis,
                          peak(*motion));
  return text;
}

/// The motion as far as it can be followed, and why no further.
std::pair<History, std::string> followed(const Scene& scene, const SolveOptions& options) {
  try {
    return {solve(scene, options), ""};
  } catch (const Unfinished& error) {
    return {error.history, error.what()};
  }
}

/// The motions beside that of solve() that obey as well, from the start on.
Json other_motions(const Scene& scene, const SolveOptions& options) {
  constexpr std::size_t most = 4;
  Json list = Json::array();
  const BranchTree tree = solve_branches(scene, options, most);
  for (std::size_t i = 1; i < tree.branches.size(); ++i)
    list.push_back(
        plots::player_track(plots::with_events(tree.branches[i].history), 1,
                            {fmt::format("branch {}, from {:.4g} s on", i + 1, tree.branches[i].start->time),
                             "#d55e00", "solid", true, false}));
  return list;
}

Json whole_answer(const Scene& scene, SolveOptions options) {
  options.validity = options.peaks = true;
  const auto [history, failure] = followed(scene, options);
  Json answer = Json::object();
  plots::make_room(answer);
  if (!failure.empty()) answer["failure"] = failure;
  if (history.size() == 0) return answer;
  answer["stage"] = plots::stage_of(scene, history);
  add_track(answer,
            plots::player_track(plots::with_events(history), 1, {"exact", "#1a1a1a", "solid", true, true}),
            reported_impacts(scene, history, chatter_speed(scene)));
  plots::add_forces(scene, history, 1, answer["track"]);
  add_energies(answer, scene, history.times, exact_energies(scene, history), 1);
  answer["ground"] = ground_text(scene);
  answer["verdict"] = motion_verdict(scene, history);
  answer["end"] = {{"angles", history.angles_at(history.size() - 1)},
                   {"velocities", history.velocities_at(history.size() - 1)}};
  return answer;
}

/// Times and angles alone.
Json member_answer(const Scene& scene, SolveOptions options) {
  options.events = EventsKept::summed;
  return {{"track", plots::player_track(followed(scene, options).first, 1)}};
}

}  // namespace

void add_track(Json& answer, Json track, const std::vector<ImpactTime>& impacts) {
  constexpr std::size_t most = 400;
  answer["impacts"] = track["impacts"] = Json::array();
  for (const ImpactTime& impact : std::span(impacts).first(std::min(most, impacts.size()))) {
    answer["impacts"].push_back({impact.time, impact.interface, sign(impact.side)});
    track["impacts"].push_back(impact.time);
  }
  answer["track"] = std::move(track);
}

void add_energies(Json& answer, const Scene& scene, const std::vector<double>& times,
                  std::vector<double> values, std::size_t stride) {
  const double scale = energy_scale(scene);
  for (double& value : values) value /= scale;
  answer["energy_times"] = plots::packed(times, 1, stride);
  answer["energy"] = plots::packed(values, 1, stride);
}

std::string exact_answer(const std::string& question) {
  const Json asked = parse_json(question, "the question ");
  MotionLibrary library;
  const Scene scene = make_scene({scene_document(asked.at("scene")), {}, "Live scene"}, library);
  SolveOptions options{.sample_times = regular_times(asked.at("interval"), scene.duration)};
  // What is said of the end is of the end, not of the last step before it.
  if (options.sample_times.back() < scene.duration) options.sample_times.push_back(scene.duration);
  const int member = asked.value("member", 0);
  Json answer = member == 0 ? whole_answer(scene, options)
                            : member_answer(perturbed(scene, {member, asked.at("spread")}, member), options);
  if (asked.value("branches", false)) answer["others"] = other_motions(scene, options);
  return answer.dump();
}

}  // namespace rockstack::live
