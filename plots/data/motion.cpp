#include "plots/data/motion.hpp"

#include <algorithm>

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

ComparedScene scene_of(const Json& summary, const Run& run) {
  ComparedScene scene{recorded_scene(summary.at("scene_as_run"))};
  scene.name = run.scene;
  scene.toml = summary.at("scene_file").get<std::string>();
  scene.results = {"histories"};
  scene.slips = tells_slips(run);
  scene.alone = true;
  if (!run.exact()) scene.law.clear();
  if (fs::exists(run.folder / "ground.csv")) scene.ground_motion = run.folder / "ground.csv";
  return scene;
}

/// A motion that was given up is shown up to there.
Run run_of(const Json& summary, const fs::path& results) {
  Run run{metrics_from(summary)};
  run.status = RunStatus::done;
  run.folder = results;
  run.files = std::make_shared<KeptFiles>();
  return run;
}

Motion motion_of(const Json& summary, const fs::path& results) {
  Motion motion;
  motion.comparison.runs = {run_of(summary, results)};
  motion.comparison.scenes = {scene_of(summary, motion.comparison.runs.front())};
  motion.comparison.title = motion.comparison.scenes.front().title;
  motion.comparison.command = summary.at("command").get<std::string>();
  motion.comparison.environment = facts_of(summary.at("environment"));
  motion.verdict = summary.at("status") == "done" ? summary.at("verdict").get<std::string>()
                                                  : "given up: " + summary.at("reason").get<std::string>();
  Json rest = summary;
  for (const char* shown : {"scene_file", "verdict", "command"}) rest.erase(shown);
  motion.summary = facts_of(rest);
  return motion;
}

}  // namespace

bool has_one_motion(const fs::path& results) {
  return fs::exists(results / "summary.json") && fs::exists(results / "history.csv");
}

Motion read_motion(const fs::path& results) {
  return read_json(results / "summary.json",
                   [&](const Json& summary) { return motion_of(summary, results); });
}

}  // namespace rockstack::plots
