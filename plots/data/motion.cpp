#include "plots/data/motion.hpp"

#include <cmath>

#include "plots/data/json_file.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

ComparedScene scene_of(const Json& summary) {
  const Json& described = summary.at("scene_as_run");
  ComparedScene scene;
  scene.name = summary.at("scene").get<std::string>();
  scene.title = described.at("title").get<std::string>();
  for (const Json& block : described.at("stack"))
    scene.stack.push_back({block.at("width").get<double>(), block.at("height").get<double>(),
                           block.at("mass").get<double>(), block.at("inertia").get<double>(),
                           block.value("offset_x", 0.0), block.value("offset_y", 0.0)});
  scene.blocks = static_cast<int>(scene.stack.size());
  scene.toml = summary.at("scene_file").get<std::string>();
  scene.ground = described.at("ground").get<std::string>();
  scene.law = described.at("law").get<std::string>();
  scene.gravity = described.at("gravity").get<double>();
  scene.chatter_speed = described.at("chatter_speed").get<double>();
  scene.results = {"histories"};
  scene.friction = described.value("friction", std::vector<double>());
  return scene;
}

/// A motion that was given up is shown up to there.
Run run_of(const Json& summary, const fs::path& results) {
  Run run;
  run.name = summary.at("run").get<std::string>();
  run.scene = summary.at("scene").get<std::string>();
  run.engine = summary.at("engine").get<std::string>();
  run.solver = summary.at("solver").get<std::string>();
  run.settings = summary.at("settings").get<std::string>();
  run.status = "done";
  run.dt = summary.at("dt").is_null() ? std::nan("") : summary.at("dt").get<double>();
  run.folder = results;
  return run;
}

Motion motion_of(const Json& summary, const fs::path& results) {
  Motion motion;
  motion.comparison.scenes = {scene_of(summary)};
  motion.comparison.runs = {run_of(summary, results)};
  ComparedScene& scene = motion.comparison.scenes.front();
  scene.slips = has_column(motion.comparison.runs.front(), "slip_1");
  if (!motion.comparison.runs.front().exact()) scene.law.clear();
  motion.comparison.title = scene.title;
  motion.comparison.command = summary.at("command").get<std::string>();
  motion.comparison.environment = facts_of(summary.at("environment"));
  if (fs::exists(results / "ground.csv")) scene.ground_motion = results / "ground.csv";
  const bool done = summary.at("status") == "done";
  motion.verdict = done ? summary.at("verdict").get<std::string>()
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
