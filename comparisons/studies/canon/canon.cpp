#include "comparisons/studies/canon/canon.hpp"

#include <fmt/format.h>

#include <numeric>

#include "analytic/scene/input/json_reader.hpp"
#include "analytic/solve.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/provenance.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/runs/execution/executor.hpp"
#include "comparisons/runs/job.hpp"

namespace rockstack {
namespace {

namespace fs = std::filesystem;

/// At all steps, the coarsest and shortest first, on all cores. @throws whatever kept the engine from
/// answering.
std::vector<CanonErrors> errors_at_all_steps(const Suite& suite, const NamedScene& scene,
                                             const EngineSeries& series) {
  const auto runs = static_cast<std::size_t>(suite.replicates.runs);
  std::vector<CanonErrors> errors = mapped(canon_steps, [&](double step) {
    return CanonErrors{step, std::vector<std::vector<Deviation>>(runs)};
  });
  std::vector<std::size_t> all(errors.size() * runs);
  std::iota(all.begin(), all.end(), 0);
  const auto compute = [&](std::size_t run) {
    CanonErrors& at = errors[run / runs];
    const auto number = static_cast<int>(run % runs);
    const Scene drawn = replicate_scene(scene.scene, suite.replicates, number);
    const double step = replicate_step(at.step, suite.replicates, number);
    const History engine = simulate(*series.engine, drawn, step, series.parameters, suite.limits).history;
    at.replicates[run % runs] = deviations(drawn, solve(drawn, {.sample_times = engine.times}), engine);
    return std::string();
  };
  make_threads(all_cores())->run(all, {compute});
  return errors;
}

Json answer_json(const CanonAnswer& answer) {
  Json json{{"scene", answer.scene}, {"verdict", answer.verdict}, {"reason", answer.reason}};
  for (const char* list : {"steps_off", "amounts", "correlations"}) json[list] = Json::array();
  if (answer.deviations.empty()) return json;
  json["quantity"] = answer.deviations.back().of;
  json["unit"] = answer.deviations.back().unit();
  for (std::size_t i = 0; i < answer.deviations.size(); ++i) {
    json["steps_off"].push_back(answer.deviations[i].time / canon_steps[i]);
    json["amounts"].push_back(answer.deviations[i].amount());
    json["correlations"].push_back(answer.deviations[i].correlation);
  }
  return json;
}

std::optional<CanonAnswer> kept_answer(const fs::path& file, const std::string& identity) {
  try {
    return read_json(file, [&](const Json& json) -> std::optional<CanonAnswer> {
      const Json& told = json.at("answer");
      if (json.at("identity") != identity) return {};
      CanonAnswer answer{told.at("scene"), {}, told.at("verdict"), told.at("reason")};
      for (const Json& one : json.at("deviations"))
        answer.deviations.push_back({one.at(0), one.at(1), one.at(2), one.at(3)});
      return answer;
    });
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace

CanonAnswer answer_canon(const Suite& suite, const NamedScene& scene, const WorkerEngine& engine,
                         const std::string& settings) {
  const EngineSeries series = make_series(engine, settings, {});
  try {
    return judge_canon(scene.name, errors_at_all_steps(suite, scene, series));
  } catch (const std::exception& error) {
    return {.scene = scene.name, .deviations = {}, .reason = error.what()};
  }
}

CanonAnswer kept_canon_answer(const Suite& suite, const NamedScene& scene, const WorkerEngine& engine,
                              const std::string& settings, const fs::path& folder) {
  const EngineSeries series = make_series(engine, settings, {});
  std::string text;
  for (const double step : canon_steps) text += replicates_identity({suite, scene, step, &series});
  const std::string identity = fmt::format("{:016x}", checksum(text));
  const fs::path file =
      folder /
      (folder_name(fmt::format("{}-{}-{}-{}", engine.name, engine.solver, settings, scene.name)) + ".json");
  if (auto kept = kept_answer(file, identity)) return *std::move(kept);
  CanonAnswer answer = answer_canon(suite, scene, engine, settings);
  if (answer.deviations.empty()) return answer;
  fs::create_directories(folder);
  Json whole{{"identity", identity}, {"answer", answer_json(answer)}, {"deviations", Json::array()}};
  for (const Deviation& one : answer.deviations)
    whole["deviations"].push_back({one.time, one.speed, one.of, one.correlation});
  write_file(file, whole.dump(2) + "\n");
  return answer;
}

double canon_time(const WorkerPace& pace, const Suite& suite, const NamedScene& scene) {
  double time = 0;
  for (const double dt : canon_steps)
    time += pace.of(1, scene.scene.duration / dt * static_cast<double>(scene.scene.blocks.size()));
  return time * suite.replicates.runs / static_cast<double>(all_cores());
}

std::string canon_headline(const Suite& suite, const std::vector<CanonRow>& rows) {
  std::vector<std::string> first;
  std::ptrdiff_t most = 0;
  for (const CanonRow& row : rows) {
    const auto follows = std::ranges::count_if(row.answers, follows_law);
    if (follows > most) first.clear();
    most = std::max(most, follows);
    if (follows == most) first.push_back(fmt::format("{} ({})", row.engine->full_name(), row.settings));
  }
  const auto scenes = std::ssize(suite.scenes);
  if (most == 0)
    return fmt::format("No set agrees with the exact solution, or converges to it, in any of {} scenes.",
                       scenes);
  const bool one = first.size() == 1;
  return fmt::format(
      "{} {} with the exact solution, or {} to it, in {} of {} scenes{}.", joined_up_to(3, first),
      one ? "agrees" : "agree", one ? "converges" : "converge", most, scenes,
      rows.size() == 1 || most == scenes ? "" : fmt::format("; none of {} sets in more", rows.size()));
}

std::string canon_json(const Suite& suite, const std::vector<CanonRow>& rows, const std::string& command) {
  const auto scene_of = [](const NamedScene& scene) {
    return Json{{"name", scene.name}, {"title", scene.scene.title}, {"scene_file", scene.text}};
  };
  const auto row_of = [](const CanonRow& row) {
    return Json{{"engine", row.engine->name},
                {"solver", row.engine->solver},
                {"version", row.engine->version},
                {"settings", row.settings},
                {"answers", mapped(row.answers, answer_json)}};
  };
  const Json json{{"title", suite.title},
                  {"headline", {canon_headline(suite, rows)}},
                  {"command", command},
                  {"steps", canon_steps},
                  {"agreement", canon_agreement},
                  {"replicates", suite.replicates.runs},
                  {"scenes", mapped(suite.scenes, scene_of)},
                  {"rows", mapped(rows, row_of)},
                  {"environment", environment(mapped(rows, &CanonRow::engine))}};
  return json.dump(2) + "\n";
}

std::string canon_csv(const std::vector<CanonRow>& rows) {
  CsvWriter csv;
  csv.line("engine", "solver", "settings", "scene", "verdict", "reason", "quantity", "dt", "steps_off",
           "amount", "unit", "correlation");
  for (const CanonRow& row : rows) {
    const auto line = [&](const CanonAnswer& answer, const auto&... values) {
      csv.line(row.engine->name, row.engine->solver, row.settings, answer.scene, answer.verdict,
               answer.reason, values...);
    };
    for (const CanonAnswer& answer : row.answers) {
      for (std::size_t i = 0; i < answer.deviations.size(); ++i) {
        const Deviation& one = answer.deviations[i];
        line(answer, one.of, canon_steps[i], one.time / canon_steps[i], one.amount(), one.unit(),
             one.correlation);
      }
      if (answer.deviations.empty()) line(answer, "", "", "", "", "", "");
    }
  }
  return csv.text();
}

}  // namespace rockstack
