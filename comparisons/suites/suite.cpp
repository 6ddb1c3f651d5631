#include "comparisons/suites/suite.hpp"

#include <fmt/format.h>

#include <set>

#include "analytic/scene/files/file_text.hpp"
#include "analytic/scene/ground/records/record_file.hpp"
#include "analytic/scene/input/page_scene.hpp"
#include "analytic/scene/input/scene_file.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/statistics/ranking.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
namespace {

/// Those of some names, or the first solver of every usual engine of this build.
std::vector<const WorkerEngine*> engines_of_choice(const std::vector<std::string>& names) {
  std::vector<const WorkerEngine*> list;
  for (const std::string& name : names)
    for (const WorkerEngine* engine : chosen_engines(name)) list.push_back(engine);
  if (!names.empty()) return list;
  for (const WorkerEngine& engine : usual_engines())
    if (list.empty() || list.back()->name != engine.name) list.push_back(&engine);
  return list;
}

}  // namespace

NamedScene read_named_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  SceneDocument document = read_document(file, overrides);
  Json as_run = page_scene(document.root);
  if (document.measured) as_run["measured"] = page_scene(*document.measured);
  MotionLibrary library;
  Scene scene = make_scene(document, library);
  std::optional<Measurement> measured;
  if (document.measured) measured = read_measurement(*document.measured, document.folder, scene);
  return {folder_name(file.stem().string()),
          overrides.empty() ? file_text(file) : scene_text(as_run),
          std::move(scene),
          nearest(document.root, "duration").place,
          std::move(measured),
          std::move(document.root)};
}

std::vector<std::string> engines_left_out(const std::vector<Suite>& suites) {
  std::set<std::string> names;
  for (const Suite& suite : suites) names.insert(suite.left_out.begin(), suite.left_out.end());
  return {names.begin(), names.end()};
}

void replace_motion(std::vector<Suite>& suites, const std::filesystem::path& record, RecordLimits limits) {
  const Record replacement = read_record(record, limits);
  const double largest = peak({replacement.interval, replacement.samples, ""});
  if (largest == 0)
    throw InputError(fmt::format("--record {}: must not be zero throughout", record.string()));
  bool replaced = false;
  for (Suite& suite : suites)
    for (NamedScene& scene : suite.scenes) {
      GroundMotion& motion = scene.scene.horizontal;
      if (motion.samples.empty()) continue;
      GroundMotion real{replacement.interval, replacement.samples, ""};
      const double factor = peak(motion) / largest;
      for (double& sample : real.samples) sample *= factor;
      real.source = fmt::format("{} ({}), scaled by {:.4g}", record.filename().string(),
                                description(replacement), factor);
      motion = std::move(real);
      scene.scene.duration = std::max(scene.scene.duration, motion.end());
      replaced = true;
    }
  if (!replaced)
    throw InputError(
        fmt::format("--record {}: no scene has a horizontal motion by samples to replace", record.string()));
}

Suite suite_for(NamedScene scene, const SceneChoice& choice) {
  Suite suite;
  suite.title = scene.scene.title;
  suite.softness = choice.softness;
  suite.wanted.forces = choice.forces;
  if (choice.quick) {
    suite.repeats = 1;
    suite.history_interval = scene.scene.duration / 2000;
  }
  std::vector<double> steps = choice.steps.empty() ? default_steps : choice.steps;
  if (choice.quick && choice.steps.empty()) steps.pop_back();
  suite.scenes.push_back(std::move(scene));
  for (const WorkerEngine* engine : engines_of_choice(choice.engines))
    for (const char* settings : {"default", "tuned"})
      suite.series.push_back(make_series(*engine, settings, steps));
  if (choice.engines.empty()) suite.left_out = usual_engines_left_out();
  suite.replicates.runs = replicates_that_tell_apart(suite.series.size(), steps.size());
  for (const NamedTrajectory& one : choice.trajectories)
    suite.series.push_back(trajectory_series(one, suite.scenes.front(), "trajectory"));
  return suite;
}

}  // namespace rockstack
