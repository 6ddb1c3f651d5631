#include "comparisons/studies/diff/recorded_results.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "analytic/scene/input/document.hpp"
#include "analytic/scene/input/json_reader.hpp"

namespace rockstack {
namespace {

using Json = nlohmann::ordered_json;

RecordedResults::Facts facts_in(const Json& object) {
  RecordedResults::Facts facts;
  for (const auto& [key, value] : object.items())
    facts[key] = value.is_string() ? value.get<std::string>() : value.dump();
  return facts;
}

/// What the scene's name, text and number of draws do not change.
RecordedResults::Facts question_in(const Json& scene) {
  RecordedResults::Facts question;
  for (const char* key :
       {"stack", "gravity", "duration", "ground", "law", "friction", "draw_steps", "draw_scene"})
    if (scene.contains(key)) question[key] = scene.at(key).dump();
  return question;
}

RecordedRun read_run(const std::filesystem::path& folder, bool drawn) {
  RecordedRun run = read_json(folder / "summary.json", [](const Json& json) {
    return RecordedRun{metrics_from(json), {}, json.at("files").get<std::map<std::string, std::string>>()};
  });
  if (!drawn) return run;
  run.draws =
      read_json(folder / "draws.json", [](const Json& json) { return metrics_list(json.at("draws")); });
  run.draws.insert(run.draws.begin(), run.row);
  return run;
}

}  // namespace

RecordedResults read_recorded_results(const std::filesystem::path& folder) {
  RecordedResults results{folder, {}, {}, {}};
  const auto file = folder / "comparison.json";
  const std::vector<RunMetrics> rows = read_json(file, [&](const Json& json) {
    results.environment = facts_in(json.at("environment"));
    for (const Json& scene : json.at("scenes"))
      results.scenes[scene.at("name").get<std::string>()] = question_in(scene);
    return metrics_list(json.at("rows"));
  });
  results.runs.reserve(rows.size());
  for (const RunMetrics& row : rows) {
    if (row.run.empty() || std::filesystem::path(row.run).filename() != row.run)
      throw InputError(
          fmt::format("{}: run = {}: must be a name without a slash", file.string(), one_line(row.run)));
    results.runs.push_back(read_run(folder / "runs" / row.run, row.draws.value_or(1) > 1));
  }
  return results;
}

}  // namespace rockstack
