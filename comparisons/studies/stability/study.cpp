#include "comparisons/studies/stability/study.hpp"

#include <fmt/format.h>

#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/sentences.hpp"

namespace rockstack {
namespace {

/// What measures of a scene are shares of.
struct Scale {
  double height = std::numeric_limits<double>::infinity();       ///< of the smallest block, m
  double width = std::numeric_limits<double>::infinity();        ///< of the narrowest interface, m
  double slenderness = std::numeric_limits<double>::infinity();  ///< of the most slender block, rad
  double rate = 0;                                               ///< √(g/H), 1/s
  double tipping = 0;  ///< energy that tips the stack over as one block, of weight times height of centre
};

Scale scale_of(const Scene& scene) {
  Scale scale;
  double mass = 0;
  double moment = 0;
  double height = 0;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const Block& block = scene.blocks[k];
    const double half_width = interface_half_width(scene, static_cast<int>(k));
    scale.height = std::min(scale.height, 2 * block.half_height);
    scale.width = std::min(scale.width, 2 * half_width);
    scale.slenderness = std::min(scale.slenderness, slenderness(scene, static_cast<int>(k)));
    mass += block.mass;
    moment += block.mass * (height + block.half_height);
    height += 2 * block.half_height;
  }
  scale.rate = std::sqrt(scene.gravity / height);
  scale.tipping = std::hypot(1, interface_half_width(scene, 0) * mass / moment) - 1;
  return scale;
}

/// A measure in a unit, and how many of it are too much.
struct Check {
  const char* label;
  std::optional<double> value;
  double unit, limit;
};

/// The first measure beyond its limit, in words; empty where there is none.
std::string first_beyond(std::initializer_list<Check> checks) {
  for (const Check& one : checks) {
    if (!one.value) continue;
    const double share = std::abs(*one.value) / one.unit;
    if (!(share <= one.limit)) return fmt::format("{} {:.3g}, limit {:g}", one.label, share, one.limit);
  }
  return "";
}

/// Where a run lies on the axis.
double place(const StabilityStudy& study, const RunMetrics& row) {
  if (study.axis.parameter.empty()) {
    const NamedScene& scene = part_named(study.suite.scenes, row.scene);
    return study.axis.values[static_cast<std::size_t>(&scene - study.suite.scenes.data())];
  }
  for (const EngineSeries& series : study.suite.series)
    if (series.engine->name == row.engine && series.engine->solver == row.solver &&
        series.settings == row.settings)
      return series.parameters.at(study.axis.parameter);
  return 0;
}

/// A parameter on the axis is no part of what a map is of.
std::string settings_of(const StabilityStudy& study, const std::string& settings) {
  const auto changed = settings.find("+" + study.axis.parameter + "=");
  if (study.axis.parameter.empty() || changed == std::string::npos) return settings;
  const auto end = settings.find('+', changed + 1);
  return settings.substr(0, changed) + (end == std::string::npos ? "" : settings.substr(end));
}

std::string stability_csv(const std::vector<StabilityRun>& rows) {
  CsvWriter csv;
  csv.line("run", "engine", "solver", "settings", "dt", "value", "verdict", "reason", "energy_gain",
           "penetration", "gap", "slip", "out_of_plane", "residual_motion", "largest_angle_difference",
           "stepping_time_minimum", "toppling_verdict");
  for (const auto& [row, value, verdict] : rows)
    csv.line(row.run, row.engine, row.solver, row.settings, row.dt, value, name(verdict.soundness),
             verdict.reason, row.energy_gain, row.penetration, row.gap, row.slip, row.out_of_plane,
             row.residual_motion, row.largest_angle_difference, row.stepping_time_minimum,
             name(row.toppling_verdict));
  return csv.text();
}

/// "3 are sound", for each verdict that there is.
std::string verdicts_sentence(const std::vector<StabilityRun>& rows) {
  std::map<Soundness, std::size_t> counts;
  std::size_t all = 0;
  for (const StabilityRun& run : rows)
    if (run.row.dt) ++counts[run.verdict.soundness], ++all;
  const auto parts = mapped(counts, [](const auto& one) {
    return fmt::format("{} {} {}", one.second, one.second == 1 ? "is" : "are", name(one.first));
  });
  return fmt::format("Of {} {}.", counted(all, "engine run"), joined(parts));
}

/// The largest stable step of each set along the axis.
std::vector<std::string> steps_sentences(const std::vector<LargestSteps>& list, const std::string& axis) {
  std::map<std::string, std::vector<double>> sets;
  for (const LargestSteps& one : list)
    sets[fmt::format("{} {}, {}", one.engine, one.solver, one.settings)].push_back(one.stable);
  const auto words = [](double step) { return step > 0 ? quantity_text(step, "s") : std::string("none"); };
  return mapped(sets, [&](const auto& set) {
    const auto [least, most] = std::ranges::minmax(set.second);
    return fmt::format("{}: the largest stable step is {} {} values of {}.", set.first,
                       least == most ? words(least) + " at all"
                                     : fmt::format("between {} and {} over", words(least), words(most)),
                       set.second.size(), axis);
  });
}

std::string steps_csv(const std::vector<LargestSteps>& list) {
  CsvWriter csv;
  csv.line("engine", "solver", "settings", "value", "largest_sound_step", "largest_stable_step");
  for (const LargestSteps& one : list)
    csv.line(one.engine, one.solver, one.settings, one.value, one.sound, one.stable);
  return csv.text();
}

Json limits_json() {
  constexpr StabilityLimits limits = stability_limits;
  return {{"unstable_energy", limits.unstable_energy},
          {"unstable_rise", limits.unstable_rise},
          {"unstable_tilt", limits.unstable_tilt},
          {"energy", limits.energy},
          {"penetration", limits.penetration},
          {"slip", limits.slip},
          {"out_of_plane", limits.out_of_plane},
          {"angle", limits.angle},
          {"residual", limits.residual}};
}

}  // namespace

std::string name(Soundness soundness) {
  constexpr std::array names{"sound", "inexact", "unstable", "failed"};
  return names.at(static_cast<std::size_t>(soundness));
}

StabilityVerdict judge_stability(const RunMetrics& row, const Scene& scene) {
  constexpr StabilityLimits limits = stability_limits;
  if (row.status != RunStatus::done) return {Soundness::failed, name(row.status) + ": " + row.reason};
  const Scale scale = scale_of(scene);
  std::string unstable = first_beyond(
      {{"energy gained, of what tips the stack over,", row.energy_gain, scale.tipping,
        limits.unstable_energy},
       {"a block thrown up, of the smallest height,", row.rise, scale.height, limits.unstable_rise},
       {"tilt out of the plane", row.out_of_plane_tilt, 1, limits.unstable_tilt}});
  if (unstable.empty() && row.toppling_verdict == TopplingVerdict::engine_alone)
    unstable = "topples though the exact solution does not";
  if (!unstable.empty()) return {Soundness::unstable, unstable};
  if (row.toppling_verdict == TopplingVerdict::exact_alone)
    return {Soundness::inexact, "stands though the exact solution topples"};
  const std::string inexact = first_beyond(
      {{"energy gained, of what tips the stack over,", row.energy_gain, scale.tipping, limits.energy},
       {"penetration, of the smallest height,", row.penetration, scale.height, limits.penetration},
       {"slip, of the narrowest width,", row.slip, scale.width, limits.slip},
       {"way out of the plane, of the narrowest width,", row.out_of_plane, scale.width, limits.out_of_plane},
       {"motion left at rest, of sqrt(g/H),", row.residual_motion, scale.rate, limits.residual},
       {"angle off, of the least slenderness,", row.largest_angle_difference, scale.slenderness,
        limits.angle}});
  if (!inexact.empty()) return {Soundness::inexact, inexact};
  return {};
}

std::vector<LargestSteps> largest_steps(const std::vector<StabilityRun>& rows) {
  std::vector<std::pair<LargestSteps, std::map<double, Soundness>>> solvers;
  for (const StabilityRun& run : rows) {
    if (!run.row.dt) continue;
    const LargestSteps own{run.row.engine, run.row.solver, run.row.settings, run.value};
    const auto is = [&](const auto& known) { return known.first == own; };
    found_or_added(solvers, is, {own, {}}).second[*run.row.dt] = run.verdict.soundness;
  }
  std::vector<LargestSteps> list;
  for (auto& [steps, by_step] : solvers) {
    bool sound = true;
    for (const auto& [dt, soundness] : by_step) {
      if (soundness > Soundness::inexact) break;
      steps.stable = dt;
      sound = sound && soundness == Soundness::sound;
      if (sound) steps.sound = dt;
    }
    list.push_back(steps);
  }
  return list;
}

std::vector<StabilityRun> run_stability(const StabilityStudy& study, const std::filesystem::path& folder,
                                        Executor& executor, const CompareOptions& options) {
  std::vector<StabilityRun> rows;
  for (const RunMetrics& row : compare({study.suite}, folder, executor, options).rows) {
    rows.push_back(
        {row, place(study, row), judge_stability(row, part_named(study.suite.scenes, row.scene).scene)});
    rows.back().row.settings = settings_of(study, row.settings);
  }
  const std::vector<LargestSteps> steps = largest_steps(rows);
  write_file(folder / "stability.csv", stability_csv(rows));
  write_file(folder / "steps.csv", steps_csv(steps));
  std::vector<std::string> headline = steps_sentences(steps, study.axis.name);
  headline.insert(headline.begin(), verdicts_sentence(rows));
  const Json json{{"title", study.suite.title},
                  {"headline", headline},
                  {"tables", {"steps.csv", "stability.csv"}},
                  {"axis", study.axis.name},
                  {"parameter", study.axis.parameter},
                  {"limits", limits_json()},
                  {"study_file", study.text},
                  {"command", options.command}};
  write_file(folder / "stability.json", json.dump(2) + "\n");
  return rows;
}

}  // namespace rockstack
