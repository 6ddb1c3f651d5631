#include "analytic/scene/lists.hpp"
#include "comparisons/studies/diff/changes.hpp"

#include <fmt/format.h>

#include "analytic/scene/input/document.hpp"
#include "analytic/scene/input/json_reader.hpp"
#include "comparisons/measures/results/provenance.hpp"

namespace rockstack {
namespace {

RecordedRun read_run(const std::filesystem::path& folder, bool replicated) {
  RecordedRun run = read_json(folder / "summary.json", [](const Json& json) {
    return RecordedRun{
        json.get<RunMetrics>(), {}, json.at("files").get<std::map<std::string, std::string>>()};
  });
  if (!replicated) return run;
  run.replicates = read_json(folder / "draws.json", [](const Json& json) {
    return json.at("draws").get<std::vector<RunMetrics>>();
  });
  run.replicates.insert(run.replicates.begin(), run.row);
  return run;
}

/// What the title does not change, nor samples of the ground, whose last digits another compiler may round
/// otherwise.
Json asked_fields(Scene scene) {
  scene.title.clear();
  scene.horizontal.samples.clear();
  scene.vertical.samples.clear();
  return scene_fields(scene);
}

using RowKey = std::vector<std::string>;
using Across = std::vector<std::string>;

bool crosses(const Across& across, const std::string& name) {
  return std::ranges::find(across, name) != across.end();
}

RowKey key_of(const RunMetrics& row, const Across& across) {
  RowKey key{row.scene, row.engine, row.solver, row.settings, row.dt ? fmt::format("{}", *row.dt) : ""};
  for (std::size_t i = 0; i < key.size(); ++i)
    if (crosses(across, row_names()[i])) key[i].clear();
  return key;
}

using Rows = std::vector<const RecordedRun*>;

std::map<RowKey, const RecordedRun*> rows_by_key(const Rows& rows, const Across& across,
                                                 const std::filesystem::path& folder) {
  std::map<RowKey, const RecordedRun*> by_key;
  for (const RecordedRun* run : rows) {
    const auto [known, added] = by_key.emplace(key_of(run->row, across), run);
    if (!added)
      throw InputError(fmt::format("{}: {} and {} agree in all but what --across names: must be one row",
                                   folder.string(), known->second->row.run, run->row.run));
  }
  return by_key;
}

Rows all_rows(const RecordedResults& results) {
  return mapped(results.runs, [](const RecordedRun& run) { return &run; });
}

/// The scenes of one name that differ, each with what differs first.
std::map<std::string, std::string> other_questions(const RecordedResults& old_results,
                                                   const RecordedResults& new_results, const Across& across) {
  std::map<std::string, std::string> others;
  if (crosses(across, "scene")) return others;
  for (const auto& [scene, facts] : old_results.scenes) {
    const auto twin = new_results.scenes.find(scene);
    if (twin == new_results.scenes.end()) continue;
    for (const auto& [key, value] : facts) {
      const auto other = twin->second.find(key);
      if (other != twin->second.end() && other->second != value) others.emplace(scene, key);
    }
  }
  return others;
}

RecordedResults read_folder(const std::filesystem::path& folder) {
  RecordedResults results{folder, {}, {}, {}};
  const auto file = folder / "comparison.json";
  const std::vector<RunMetrics> rows = read_json(file, [&](const Json& json) {
    for (const auto& [key, value] : json.at("environment").items())
      results.environment[key] = value.is_string() ? value.get<std::string>() : value.dump();
    for (const Json& scene : json.at("scenes")) {
      RecordedResults::Facts& question = results.scenes[scene.at("name").get<std::string>()];
      for (const char* key : {"ground", "draw_steps", "draw_scene"})
        if (scene.contains(key)) question[key] = scene.at(key).dump();
      if (scene.value("page", "").empty()) continue;
      const Json asked = asked_fields(recorded_scene(scene, "", file.string()));
      for (const auto& [key, value] : asked.items()) question[key] = value.dump();
    }
    return json.at("rows").get<std::vector<RunMetrics>>();
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

constexpr const char* packed_mark = "rockstack_baseline";

/// What a row has of its columns; an empty cell takes no room.
Json cells_of(const RunMetrics& row) {
  Json cells = row, kept = Json::object();
  for (const auto& [name, cell] : cells.items())
    if (!cell.is_null() && cell != Json("")) kept[name] = cell;
  return kept;
}

RecordedResults read_packed(const std::filesystem::path& file) {
  return read_json(file, [&](const Json& json) {
    if (json.value(packed_mark, 0) != 1)
      throw std::invalid_argument(
          fmt::format("must be a baseline, as --save writes it, or a folder of `rockstack compare`: no {}: 1",
                      packed_mark));
    RecordedResults results{file, json.at("environment"), json.at("scenes"), {}};
    for (const Json& run : json.at("runs"))
      results.runs.push_back({run.at("row").get<RunMetrics>(),
                              run.at("replicates").get<std::vector<RunMetrics>>(), run.at("files")});
    return results;
  });
}

}  // namespace

RecordedResults read_recorded_results(const std::filesystem::path& place) {
  return std::filesystem::is_regular_file(place) ? read_packed(place) : read_folder(place);
}

std::string packed_results(const RecordedResults& results) {
  const auto run_json = [](const RecordedRun& run) {
    return Json{{"row", cells_of(run.row)},
                {"replicates", mapped(run.replicates, cells_of)},
                {"files", run.checksums}};
  };
  return Json{{packed_mark, 1},
              {"environment", results.environment},
              {"scenes", results.scenes},
              {"runs", mapped(results.runs, run_json)}}
             .dump() +
         "\n";
}
const std::vector<std::string>& row_names() {
  static const std::vector<std::string> names{"scene", "engine", "solver", "settings", "dt"};
  return names;
}

RowPairs pair_rows(const RecordedResults& old_results, const RecordedResults& new_results,
                   const Across& across) {
  Rows old_rows = all_rows(old_results), new_rows = all_rows(new_results);
  RowPairs all;
  for (const Across& names : {Across{}, across}) {
    const auto own = rows_by_key(old_rows, names, old_results.folder);
    const auto twins = rows_by_key(new_rows, names, new_results.folder);
    std::erase_if(old_rows, [&](const RecordedRun* run) {
      const auto twin = twins.find(key_of(run->row, names));
      if (twin != twins.end()) all.pairs.push_back({run, twin->second});
      return twin != twins.end();
    });
    std::erase_if(new_rows, [&](const RecordedRun* run) { return own.contains(key_of(run->row, names)); });
  }
  const auto others = other_questions(old_results, new_results, across);
  for (const auto& [scene, key] : others)
    all.other_questions.push_back(fmt::format("scene {}: {}", scene, key));
  std::erase_if(all.pairs, [&](const RowPair& pair) { return others.contains(pair.old_run->row.scene); });
  for (const RecordedRun* run : old_rows) all.only_old.push_back(run->row.run);
  for (const RecordedRun* run : new_rows) all.only_new.push_back(run->row.run);
  if (all.pairs.empty())
    throw InputError(
        fmt::format("{} and {}: must have a row in common: scene, engine, solver, settings and dt",
                    old_results.folder.string(), new_results.folder.string()));
  return all;
}

}  // namespace rockstack
