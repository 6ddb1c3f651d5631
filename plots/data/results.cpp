#include "plots/data/results.hpp"

#include <fmt/format.h>

#include "analytic/scene/input/document.hpp"

namespace rockstack::plots {
namespace {

/// A name in comparison.json that is one of files too.
std::string name_in(const fs::path& results, const char* key, const std::string& name) {
  return file_name(name, fmt::format("{}: {}", (results / "comparison.json").string(), key));
}

/// `text`: the key of its file's text.
ComparedScene scene_of(const Json& json, const char* text, const fs::path& place) {
  const auto toml = json.at(text).get<std::string>();
  ComparedScene scene{recorded_scene(json, toml, place.string())};
  scene.toml = toml;
  scene.page = json.value("page", "");
  scene.heading = fmt::format("{}, law {}", scene.title, name(scene.law));
  return scene;
}

ComparedScene compared_scene(const Json& json, const fs::path& results) {
  ComparedScene scene = scene_of(json, "toml", results / "comparison.json");
  scene.name = name_in(results, "name of a scene", json.at("name").get<std::string>());
  scene.ground = json.at("ground").get<std::string>();
  if (!scene.restitution.empty())
    scene.heading += fmt::format(" with restitution {}, engines without", fmt::join(scene.restitution, ", "));
  if (!scene.kinetic_friction.empty())
    scene.heading += fmt::format(" with kinetic_friction {}; engines of one coefficient have friction's",
                                 fmt::join(scene.kinetic_friction, ", "));
  if (const Json& time = json.at("predictable_time"); !time.is_null())
    scene.predictable_time = time.get<double>();
  scene.results = json.at("results").get<std::vector<std::string>>();
  if (const Json measured = json.value("measured", Json()); !measured.is_null()) {
    scene.readings = measured.at("columns").get<std::vector<std::string>>();
    scene.reading_unit = measured.at("unit").get<std::string>();
  }
  if (const fs::path ground = results / "ground" / (scene.name + ".csv"); fs::exists(ground))
    scene.ground_motion = ground;
  return scene;
}

/// What a scene's figures are chosen by.
void note_kinds(Comparison& comparison) {
  for (ComparedScene& scene : comparison.scenes) {
    for (const Run& run : comparison.runs) {
      if (run.scene != scene.name || !run.done()) continue;
      scene.both_equations = scene.both_equations || run.has_other_equations();
      scene.frictions = scene.frictions || run.has_own_friction();
      scene.split = scene.split || run.step_difference;
      scene.slips = scene.slips || run.tells_slips();
    }
    const auto is_own = [&](const auto& one) { return one.scene == scene.name; };
    scene.fitted = std::ranges::any_of(comparison.fits, is_own);
    scene.perturbed = std::ranges::any_of(comparison.distances, is_own);
  }
}

Comparison comparison_of(const Json& json, const fs::path& results) {
  Comparison comparison;
  comparison.title = json.at("title").get<std::string>();
  comparison.command = json.at("command").get<std::string>();
  for (const Json& scene : json.at("scenes")) comparison.scenes.push_back(compared_scene(scene, results));
  comparison.definitions = facts_of(json.at("definitions"));
  comparison.environment = facts_of(json.at("environment"));
  comparison.tolerance = json.at("tolerance_rad").get<double>();
  if (!(comparison.tolerance > 0))
    throw std::invalid_argument(fmt::format("tolerance_rad = {}: must be > 0", comparison.tolerance));
  comparison.left_out = json.at("left_out").get<std::vector<std::string>>();
  for (const Json& one : json.at("statements"))
    comparison.statements.push_back(
        {one.at("source"), one.at("claim"), one.at("verdict"), one.at("criterion"), one.at("computed")});
  comparison.fits = json.at("fits").get<std::vector<SeriesFit>>();
  comparison.distances = json.at("distributions").get<std::vector<DistributionDistance>>();
  if (const std::string print = json.value("figures", ""); !print.empty())
    comparison.print = read_style_text(print, (results / "comparison.json").string() + ": figures");
  comparison.verdict = verdict_from(json.at("verdict"));
  if (comparison.verdict.scenes.size() != comparison.scenes.size())
    throw std::invalid_argument(fmt::format("verdict of {} scenes: must be of {}",
                                            comparison.verdict.scenes.size(), comparison.scenes.size()));
  const auto files = std::make_shared<KeptFiles>();
  for (const RunMetrics& row : json.at("rows").get<std::vector<RunMetrics>>())
    comparison.runs.push_back({row, results / "runs" / name_in(results, "run", row.run), files});
  note_kinds(comparison);
  return comparison;
}

ComparedScene scene_by_itself(const Json& summary, const Run& run) {
  ComparedScene scene = scene_of(summary, "scene_file", run.folder / "summary.json");
  scene.name = run.scene;
  scene.ground = summary.at("scene_as_run").at("ground").get<std::string>();
  scene.results = {"histories"};
  if (fs::exists(run.folder / "reactions.csv")) scene.results.emplace_back("forces");
  scene.slips = run.tells_slips();
  scene.alone = true;
  if (!run.exact()) scene.heading = scene.title;
  if (fs::exists(run.folder / "ground.csv")) scene.ground_motion = run.folder / "ground.csv";
  return scene;
}

Motion motion_of(const Json& summary, const fs::path& results) {
  Motion motion;
  Run run{motion_row(summary), results, std::make_shared<KeptFiles>()};
  run.status = RunStatus::done;  // a motion that was given up is shown up to there
  motion.comparison.runs = {run};
  motion.comparison.scenes = {scene_by_itself(summary, run)};
  motion.comparison.title = motion.comparison.scenes.front().title;
  motion.comparison.command = summary.at("command").get<std::string>();
  motion.comparison.environment = facts_of(summary.at("environment"));
  motion.verdict = summary.at("status") == "done" ? summary.at("verdict").get<std::string>()
                                                  : "given up: " + summary.at("reason").get<std::string>();
  Json rest = summary;
  for (const char* shown : {"scene_file", "page", "verdict", "command"}) rest.erase(shown);
  motion.summary = facts_of(rest);
  return motion;
}

}  // namespace

std::string file_name(const std::string& text, const std::string& place) {
  if (text.empty() || text == "." || text == ".." || text.find('/') != std::string::npos)
    throw InputError(fmt::format("{} = \"{}\": must be a name without a slash", place, one_line(text)));
  return text;
}

Facts facts_of(const Json& object) {
  Facts facts;
  for (const auto& [key, value] : object.items())
    if (value.is_object())
      for (auto& [inner, text] : facts_of(value))
        facts.emplace_back(fmt::format("{}.{}", key, inner), std::move(text));
    else
      facts.emplace_back(key, value.is_string() ? value.get<std::string>() : value.dump());
  return facts;
}

void KeptFiles::make_room_for(const fs::path& file) {
  constexpr std::uintmax_t room = 500'000'000;
  std::error_code none;
  const std::uintmax_t size = fs::file_size(file, none);
  if (none) return;
  if (bytes_ + size > room) {
    kept_.clear();
    bytes_ = 0;
  }
  bytes_ += size;
}

Comparison read_comparison(const fs::path& results) {
  return read_json(results / "comparison.json",
                   [&](const Json& json) { return comparison_of(json, results); });
}

std::vector<Run> done_runs(const Comparison& comparison, const std::string& scene) {
  std::vector<Run> runs;
  for (const Run& run : comparison.runs)
    if (run.done() && run.scene == scene) runs.push_back(run);
  std::stable_partition(runs.begin(), runs.end(), [](const Run& run) { return run.exact(); });
  return runs;
}

Motion read_motion(const fs::path& results) {
  return read_json(results / "summary.json",
                   [&](const Json& summary) { return motion_of(summary, results); });
}

}  // namespace rockstack::plots
