#include "plots/data/results.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <utility>

#include "analytic/scene/messages/input_error.hpp"
#include "analytic/scene/pattern.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "plots/data/json_file.hpp"

namespace rockstack::plots {
namespace {

/// Of files that do not say.
const std::vector<std::string> all_results{"angles", "impacts", "patterns", "bodies", "histories"};

/// Zero where it is no number of blocks.
int block_count(const Json& value) {
  const double count = value.get<double>();
  return count >= 1 && count <= max_blocks && count == std::floor(count) ? static_cast<int>(count) : 0;
}

double number_of(const Json& value) {
  return value.is_null() ? std::nan("") : value.get<double>();
}

void read_fits(const Json& json, Comparison& comparison) {
  for (const Json& fit : json.value("fits", Json::array())) {
    comparison.fits.push_back({fit.at("scene").get<std::string>(), fit.at("engine").get<std::string>(),
                               fit.at("solver").get<std::string>(), fit.at("settings").get<std::string>(),
                               fit.at("quantity").get<std::string>(), number_of(fit.at("gap")),
                               number_of(fit.at("gap_low")), number_of(fit.at("gap_high")),
                               number_of(fit.at("order")), number_of(fit.at("order_low")),
                               number_of(fit.at("order_high")), number_of(fit.at("coefficient")),
                               fit.at("holds").get<bool>(), fit.at("reason").get<std::string>()});
    for (ComparedScene& scene : comparison.scenes)
      if (scene.name == comparison.fits.back().scene) scene.fitted = true;
  }
}

std::vector<StackBlock> stack_of(const Json& scene) {
  std::vector<StackBlock> stack;
  for (const Json& block : scene.value("stack", Json::array()))
    stack.push_back({block.at("width").get<double>(), block.at("height").get<double>(),
                     block.at("mass").get<double>(), block.at("inertia").get<double>(),
                     block.value("offset_x", 0.0), block.value("offset_y", 0.0)});
  return stack;
}

void read_distances(const Json& json, Comparison& comparison) {
  for (const Json& one : json.value("distributions", Json::array())) {
    comparison.distances.push_back(
        {one.at("scene").get<std::string>(), one.at("run").get<std::string>(),
         one.at("quantity").get<std::string>(), one.at("distance").get<double>(),
         one.at("critical").get<double>(), number_of(one.value("exact_runs", Json())),
         number_of(one.value("exact_mean", Json())), number_of(one.value("mean", Json()))});
    for (ComparedScene& scene : comparison.scenes)
      if (scene.name == comparison.distances.back().scene) scene.perturbed = true;
  }
}

/// Sentences that the comparison made of its rows.
void read_verdict(const Json& json, Comparison& comparison) {
  const Json verdict = json.value("verdict", Json::object());
  comparison.headline = verdict.value("headline", std::vector<std::string>());
  for (const Json& one : verdict.value("scenes", Json::array()))
    for (ComparedScene& scene : comparison.scenes)
      if (scene.name == one.at("name").get<std::string>())
        scene.sentences = one.at("sentences").get<std::vector<std::string>>();
}

void read_description(const Json& json, Comparison& comparison) {
  comparison.title = json.at("title").get<std::string>();
  comparison.command = json.at("command").get<std::string>();
  for (const Json& scene : json.at("scenes")) {
    comparison.scenes.push_back({scene.at("name").get<std::string>(),
                                 scene.at("title").get<std::string>(),
                                 block_count(scene.at("blocks")),
                                 scene.at("toml").get<std::string>(),
                                 scene.value("ground", ""),
                                 scene.value("law", ""),
                                 number_of(scene.value("predictable_time", Json())),
                                 stack_of(scene),
                                 scene.value("gravity", 0.0),
                                 scene.value("duration", std::nan("")),
                                 scene.value("chatter_speed", 0.0),
                                 {},
                                 scene.value("results", all_results),
                                 false,
                                 false});
    comparison.scenes.back().friction = scene.value("friction", std::vector<double>());
  }
  comparison.definitions = facts_of(json.at("definitions"));
  comparison.environment = facts_of(json.at("environment"));
  comparison.tolerance = json.at("tolerance_rad").get<double>();
  comparison.left_out = json.at("left_out").get<std::vector<std::string>>();
  for (const Json& statement : json.value("statements", Json::array()))
    comparison.statements.push_back(
        {statement.at("source").get<std::string>(), statement.at("claim").get<std::string>(),
         statement.at("verdict").get<std::string>(), statement.at("criterion").get<std::string>(),
         statement.at("computed").get<std::string>()});
  read_fits(json, comparison);
  read_distances(json, comparison);
  read_verdict(json, comparison);
}

void check_description(const Comparison& comparison, const std::filesystem::path& file) {
  for (const ComparedScene& scene : comparison.scenes)
    file_name(scene.name, file.string() + ": name of a scene");
  if (!(comparison.tolerance > 0))
    throw InputError(fmt::format("{}: tolerance_rad = {}: must be > 0", file.string(), comparison.tolerance));
  for (const ComparedScene& scene : comparison.scenes)
    if (scene.blocks < 1 || scene.blocks > max_blocks)
      throw InputError(fmt::format("{}: scene {}: blocks = {}: must be 1 to {}", file.string(), scene.name,
                                   scene.blocks, max_blocks));
  for (const ComparedScene& scene : comparison.scenes)
    if (!scene.stack.empty() && scene.stack.size() != static_cast<std::size_t>(scene.blocks))
      throw InputError(fmt::format("{}: scene {}: stack has {} blocks: must have {}", file.string(),
                                   scene.name, scene.stack.size(), scene.blocks));
}

/// Fills the fields of a run from its cells.
class RowReader {
 public:
  RowReader(const Table& table, std::size_t row, const std::filesystem::path& file)
      : table_(table), row_(row), file_(file) {}

  void read(const std::string& name, std::string& field) const { field = cell(name); }
  /// A column that results without draws do not have.
  void read_if_there(const std::string& name, double& field) const {
    const auto& columns = table_.columns;
    if (std::find(columns.begin(), columns.end(), name) == columns.end())
      field = std::nan("");
    else
      read(name, field);
  }
  void read(const std::string& name, double& field) const {
    field = number(cell(name), fmt::format("{}:{}", file_.string(), row_ + 2), name);
  }

 private:
  const std::string& cell(const std::string& name) const {
    return table_.rows[row_][column(table_, name, file_)];
  }

  const Table& table_;
  std::size_t row_;
  const std::filesystem::path& file_;
};

Run read_run(const RowReader& row) {
  Run run;
  row.read("run", run.name);
  row.read("scene", run.scene);
  row.read("engine", run.engine);
  row.read("solver", run.solver);
  row.read("settings", run.settings);
  row.read("status", run.status);
  row.read("reason", run.reason);
  row.read("dt", run.dt);
  row.read("steps", run.steps);
  row.read("stepping_time_minimum", run.stepping_time);
  row.read("largest_angle_difference", run.largest_angle_difference);
  row.read("rms_angle_difference", run.rms_angle_difference);
  row.read("first_impact_time_difference", run.first_impact_time_difference);
  row.read("impacts_matched", run.impacts_matched);
  row.read("impacts_missed", run.impacts_missed);
  row.read("impacts_extra", run.impacts_extra);
  for (const auto& [name, field] : {std::pair{"rms_angle_difference_lower", &run.rms_angle_difference_lower},
                                    {"rms_angle_difference_upper", &run.rms_angle_difference_upper},
                                    {"slip_error", &run.slip_error},
                                    {"model_difference", &run.model_difference},
                                    {"softness_difference", &run.softness_difference},
                                    {"step_difference", &run.step_difference},
                                    {"model_share", &run.model_share},
                                    {"softness_share", &run.softness_share},
                                    {"step_share", &run.step_share},
                                    {"contact_stiffness", &run.contact_stiffness},
                                    {"contact_damping_ratio", &run.contact_damping_ratio},
                                    {"contact_restitution", &run.contact_restitution},
                                    {"spring_factor", &run.spring_factor},
                                    {"energy_gain", &run.energy_gain},
                                    {"penetration", &run.penetration},
                                    {"residual_motion", &run.residual_motion},
                                    {"draws", &run.draws},
                                    {"impacts_matched_null", &run.impacts_matched_null},
                                    {"impacts_missed_null", &run.impacts_missed_null},
                                    {"impacts_extra_null", &run.impacts_extra_null},
                                    {"impacts_matched_random", &run.impacts_matched_random},
                                    {"impacts_matched_shifted", &run.impacts_matched_shifted}})
    row.read_if_there(name, *field);
  row.read("agreement_time", run.agreement_time);
  row.read("toppled", run.toppled);
  return run;
}

/// What a scene's figures are chosen by.
void note_kind(const Run& run, ComparedScene& scene) {
  scene.both_equations = scene.both_equations || has_other_equations(run);
  scene.frictions = scene.frictions || has_own_friction(run);
  scene.split = scene.split || !std::isnan(run.step_difference);
  scene.slips = scene.slips || has_column(run, "slip_1");
}

}  // namespace

bool ComparedScene::has(const std::string& result) const {
  return std::find(results.begin(), results.end(), result) != results.end();
}

std::string heading(const ComparedScene& scene) {
  return scene.law.empty() ? scene.title : fmt::format("{}, law {}", scene.title, scene.law);
}

Comparison read_comparison(const std::filesystem::path& results) {
  Comparison comparison;
  const std::filesystem::path description = results / "comparison.json";
  read_json(description, [&](const Json& json) { read_description(json, comparison); });
  check_description(comparison, description);
  const std::filesystem::path file = results / "comparison.csv";
  const Table table = read_table(file);
  comparison.columns = table.columns;
  for (ComparedScene& scene : comparison.scenes) {
    const std::filesystem::path ground = results / "ground" / (scene.name + ".csv");
    if (std::filesystem::exists(ground)) scene.ground_motion = ground;
  }
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    Run run = read_run(RowReader(table, i, file));
    run.cells = table.rows[i];
    run.folder = results / "runs" / file_name(run.name, fmt::format("{}:{}: run", file.string(), i + 2));
    for (ComparedScene& scene : comparison.scenes)
      if (scene.name == run.scene && run.done()) note_kind(run, scene);
    comparison.runs.push_back(std::move(run));
  }
  return comparison;
}

Facts read_summary(const Run& run) {
  return facts_of(read_json(run.folder / "summary.json"));
}

bool has_column(const Run& run, const std::string& column) {
  std::ifstream file(run.folder / "history.csv");
  std::string header;
  std::getline(file, header);
  if (!header.empty() && header.back() == '\r') header.pop_back();
  return ("," + header + ",").find("," + column + ",") != std::string::npos;
}

std::vector<Run> done_runs(const Comparison& comparison, const std::string& scene) {
  std::vector<Run> runs;
  for (const Run& run : comparison.runs)
    if (run.done() && run.scene == scene) runs.push_back(run);
  std::stable_partition(runs.begin(), runs.end(), [](const Run& run) { return run.exact(); });
  return runs;
}

bool has_motion(const Comparison& comparison, const ComparedScene& scene) {
  return !scene.stack.empty() && scene.has("histories") && !done_runs(comparison, scene.name).empty();
}

bool has_other_equations(const Run& run) {
  return run.engine == "linear" || run.engine == "nonlinear";
}

bool has_own_friction(const Run& run) {
  return run.engine.starts_with("friction=");
}

bool is_variant(const Run& run) {
  return has_other_equations(run) || has_own_friction(run) || run.engine == "paper" ||
         run.engine == "consistent" || run.engine == "unilateral";
}

std::string solver_name(const Run& run) {
  return run.exact() || run.solver.empty() ? run.engine : run.engine + ":" + run.solver;
}

}  // namespace rockstack::plots
