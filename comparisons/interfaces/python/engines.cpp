#include <pybind11/stl.h>

#include <cmath>
#include <optional>
#include <utility>

#include "analytic/scene/messages/input_error.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/interfaces/python/convert.hpp"
#include "comparisons/interfaces/python/module.hpp"
#include "comparisons/measures/metrics/contact_patterns.hpp"
#include "comparisons/studies/canon/canon.hpp"
#include "comparisons/suites/shipped.hpp"
#include "comparisons/suites/suite.hpp"
#include "engines/scene_setup.hpp"
#include "engines/worker/registry.hpp"

namespace rockstack::python {
namespace {

using namespace py::literals;

py::dict to_dict(const Setting& setting) {
  return py::dict("name"_a = setting.name, "default"_a = setting.standard, "tuned"_a = setting.tuned,
                  "least"_a = setting.least, "most"_a = setting.most, "whole"_a = setting.whole,
                  "choices"_a = setting.choices, "unit"_a = setting.unit);
}

py::dict to_dict(const WorkerEngine& engine) {
  py::list settings;
  for (const Setting& setting : engine.settings) settings.append(to_dict(setting));
  return py::dict("name"_a = engine.name, "solver"_a = engine.solver, "version"_a = engine.version,
                  "licence"_a = engine.licence, "settings"_a = settings);
}

py::list list_engines() {
  py::list list;
  for (const WorkerEngine& engine : engines()) list.append(to_dict(engine));
  return list;
}

void require_settings(const std::string& settings) {
  if (settings != "default" && settings != "tuned")
    throw InputError("settings = " + settings + ": must be default or tuned");
}

py::object to_dict(const std::optional<BodyRecord>& bodies) {
  if (!bodies) return py::none();
  return py::dict("energy"_a = copied(bodies->energy), "input"_a = copied(bodies->input),
                  "penetration"_a = copied(bodies->penetration), "gap"_a = bodies->gap,
                  "slip"_a = bodies->slip);
}

/// The motion, warnings, what bodies did, and the reason where the run failed.
py::tuple simulate_one(const ScenePointer& scene, const std::string& engine_name, const std::string& settings,
                       const std::vector<std::string>& changes, double dt, double time_limit, bool bodies) {
  require_settings(settings);
  if (!(time_limit > 0))
    throw InputError("time_limit = " + number_text(time_limit) + ": must be a number > 0");
  if (!(dt > 0)) throw InputError("dt = " + number_text(dt) + ": must be a finite number > 0");
  const WorkerEngine& engine = find_engine(engine_name);
  const EngineSeries series = make_series(engine, settings, {dt}, read_parameters(changes, engine));
  check_step(dt, scene->scene.duration);
  WorkerRun made;
  beside_interpreter([&](const std::atomic<bool>& stop) {
    const std::function<bool()> cancelled = [&] { return stop.load(); };
    const Limits limits{.time = time_limit, .unwanted = &cancelled};
    made = run_in_worker(engine, scene->scene, dt, series.parameters, 0, limits, bodies);
    if (made.status == "done") made.run.history.patterns = sampled_patterns(scene->scene, made.run.history);
  });
  if (made.status != "done")
    return py::make_tuple(py::none(), 0, py::none(), made.status + ": " + made.reason);
  const std::size_t warnings = made.run.warnings;
  const py::object record = to_dict(made.run.bodies);
  Support support;
  if (made.run.bodies) support = support_of(made.run.bodies->penetration, made.run.bodies->unsupported_since);
  return py::make_tuple(std::make_shared<HeldMotion>(HeldMotion{scene, std::move(made.run.history), support}),
                        warnings, record, py::none());
}

py::list canon(const std::string& engine_name, const std::string& settings,
               const std::optional<std::vector<std::string>>& scenes, int draws) {
  require_settings(settings);
  const WorkerEngine& engine = find_engine(engine_name);
  Suite suite = read_suite(find_file("canon", "suites"), {});
  if (draws < 1) throw InputError("draws = " + std::to_string(draws) + ": must be at least 1");
  suite.draws.runs = draws;
  if (scenes) {
    std::vector<NamedScene> chosen;
    for (const std::string& name : *scenes) {
      const auto found = std::find_if(suite.scenes.begin(), suite.scenes.end(),
                                      [&](const NamedScene& scene) { return scene.name == name; });
      if (found == suite.scenes.end()) throw InputError("scenes: " + name + ": must be a scene of the canon");
      chosen.push_back(*found);
    }
    suite.scenes = std::move(chosen);
  }
  std::vector<CanonAnswer> list;
  beside_interpreter([&](const std::atomic<bool>& stop) {
    for (const NamedScene& scene : suite.scenes) {
      if (stop) throw Cancelled();
      list.push_back(answer_canon(suite, scene, engine, settings));
    }
  });
  py::list answers;
  for (const CanonAnswer& answer : list) {
    std::vector<double> amounts(canon_steps.size(), std::nan("")), steps_off = amounts;
    for (std::size_t i = 0; i < answer.deviations.size(); ++i) {
      amounts[i] = answer.deviations[i].amount();
      steps_off[i] = answer.deviations[i].time / canon_steps[i];
    }
    answers.append(py::dict("scene"_a = answer.scene, "verdict"_a = answer.verdict,
                            "reason"_a = answer.reason, "amounts"_a = amounts, "steps_off"_a = steps_off));
  }
  return answers;
}

}  // namespace

void add_engines(py::module_& core) {
  core.def("engines", &list_engines);
  core.def("simulate", &simulate_one);
  core.def("canon", &canon);
}

}  // namespace rockstack::python
