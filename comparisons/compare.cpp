#include "comparisons/compare.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "analytic/scene/input_error.hpp"
#include "comparisons/environment.hpp"
#include "comparisons/files.hpp"
#include "comparisons/fits.hpp"
#include "comparisons/measure.hpp"
#include "comparisons/statements.hpp"

namespace rockstack {
namespace {

using Json = nlohmann::ordered_json;

std::vector<Job> jobs_of(const std::vector<Suite>& suites) {
  std::vector<Job> jobs;
  for (const Suite& suite : suites) {
    for (const NamedScene& scene : suite.scenes) {
      jobs.push_back({suite, scene, {}});
      for (const Variant& variant : suite.variants) jobs.push_back({suite, scene, {}, nullptr, &variant});
      for (const EngineSeries& series : suite.series) {
        for (const double dt : series.steps) jobs.push_back({suite, scene, dt, &series});
      }
    }
  }
  return jobs;
}

void require_compatible(const std::vector<Suite>& suites) {
  std::set<std::string> names;
  for (const Suite& suite : suites) {
    if (suite.tolerance != suites.front().tolerance) {
      throw InputError(fmt::format("tolerance = {}: must be the same in all suites of one comparison, {}",
                                   suite.tolerance, suites.front().tolerance));
    }
    for (const NamedScene& scene : suite.scenes) {
      if (!names.insert(scene.name).second) {
        throw InputError(fmt::format(
            "scene {}: must be in a comparison once; its results would share a folder", scene.name));
      }
    }
  }
}

std::string ground_of(const Scene& scene) {
  std::string text = scene.horizontal.source;
  if (!scene.vertical.empty()) text += (text.empty() ? "" : "; ") + scene.vertical.source + ", vertical";
  return text;
}

/// Sizes and masses as they were run, overrides included; SI units, bottom to top.
Json stack_json(const Scene& scene) {
  Json list = Json::array();
  for (const Block& block : scene.blocks) {
    list.push_back({{"width", 2 * block.half_width},
                    {"height", 2 * block.half_height},
                    {"mass", block.mass},
                    {"inertia", block.inertia}});
  }
  return list;
}

Json statements_json(const std::vector<Suite>& suites) {
  Json list = Json::array();
  for (const Suite& suite : suites) {
    if (!suite.statements) continue;
    for (const Statement& statement : judge(gather(suite))) {
      list.push_back({{"source", statement.source},
                      {"claim", statement.claim},
                      {"verdict", name(statement.verdict)},
                      {"criterion", statement.criterion},
                      {"computed", statement.computed}});
    }
  }
  return list;
}

std::vector<const EngineSeries*> all_series(const std::vector<Suite>& suites) {
  std::vector<const EngineSeries*> list;
  for (const Suite& suite : suites) {
    for (const EngineSeries& series : suite.series) list.push_back(&series);
  }
  return list;
}

Json comparison_json(const std::vector<Suite>& suites, const std::vector<Row>& rows,
                     const std::vector<SeriesFit>& fits, const std::string& command) {
  Json json;
  std::vector<std::string> titles;
  json["scenes"] = Json::array();
  for (const Suite& suite : suites) {
    titles.push_back(suite.title);
    for (const NamedScene& scene : suite.scenes) {
      json["scenes"].push_back({{"name", scene.name},
                                {"title", scene.scene.title},
                                {"blocks", scene.scene.blocks.size()},
                                {"stack", stack_json(scene.scene)},
                                {"gravity", scene.scene.gravity},
                                {"duration", scene.scene.duration},
                                {"ground", ground_of(scene.scene)},
                                {"chatter_speed", chatter_speed(scene.scene)},
                                {"matching_window", matching_window(scene.scene)},
                                {"results", names_of(suite.wanted)},
                                {"toml", scene.text}});
    }
  }
  json["title"] = fmt::format("{}", fmt::join(titles, "; "));
  for (const Column& column : columns()) json["definitions"][column.name] = column.definition;
  json["tolerance_rad"] = suites.front().tolerance;
  json["left_out"] = engines_left_out();
  json["environment"] = environment(all_series(suites));
  json["command"] = command;
  json["statements"] = statements_json(suites);
  json["fit_definition"] = fit_definition();
  json["fits"] = fits_json(fits);
  json["rows"] = Json::array();
  for (const Row& row : rows) json["rows"].push_back(row_json(row));
  return json;
}

void write_ground(const std::vector<Suite>& suites, const std::filesystem::path& folder) {
  for (const Suite& suite : suites) {
    for (const NamedScene& scene : suite.scenes) {
      if (scene.scene.horizontal.empty() && scene.scene.vertical.empty()) continue;
      prepare_folder(folder / "ground");
      write_file(folder / "ground" / (scene.name + ".csv"), ground_csv(scene.scene));
    }
  }
}

}  // namespace

std::vector<Row> compare(const std::vector<Suite>& suites, const std::filesystem::path& folder,
                         const std::string& command, const Progress& progress) {
  require_compatible(suites);
  const std::vector<Job> jobs = jobs_of(suites);
  std::vector<Row> rows;
  for (const Job& job : jobs) {
    progress(rows.size() + 1, jobs.size(), describe(job).run);
    rows.push_back(measure(job, folder, command));
  }
  write_ground(suites, folder);
  const std::vector<SeriesFit> fits = fit_rows(rows);
  if (!fits.empty()) write_file(folder / "fits.csv", fits_csv(fits));
  write_file(folder / "comparison.csv", comparison_csv(rows));
  write_file(folder / "comparison.json", comparison_json(suites, rows, fits, command).dump(2) + "\n");
  return rows;
}

}  // namespace rockstack
