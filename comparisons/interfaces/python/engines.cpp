#include "comparisons/runs/compare.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <system_error>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/interfaces/python/convert.hpp"
#include "comparisons/measures/metrics/sampled_patterns.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/studies/canon/canon.hpp"
#include "comparisons/suites/compare_choice.hpp"
#include "comparisons/suites/shipped.hpp"
#include "engines/scene_setup.hpp"
#include "engines/worker/answer_check.hpp"

namespace rockstack::python {
namespace {

using namespace py::literals;

py::dict setting_dict(const Setting& setting) {
  return py::dict("name"_a = setting.name, "default"_a = setting.default_value, "tuned"_a = setting.tuned,
                  "least"_a = setting.least, "most"_a = setting.most, "whole"_a = setting.whole,
                  "choices"_a = setting.choices, "unit"_a = setting.unit);
}

py::dict engine_dict(const WorkerEngine& engine) {
  return py::dict("name"_a = engine.name, "solver"_a = engine.solver, "version"_a = engine.version,
                  "licence"_a = engine.licence, "settings"_a = mapped(engine.settings, setting_dict));
}

/// Without the interpreter's lock, as an engine may answer from another thread of it.
const WorkerEngine& engine_named(const std::string& name) {
  const py::gil_scoped_release free;
  return find_engine(name);
}

void require_settings(const std::string& settings) {
  if (settings != "default" && settings != "tuned")
    throw InputError("settings = " + settings + ": must be default or tuned");
}

py::object to_dict(const std::optional<BodyRecord>& bodies) {
  if (!bodies) return py::none();
  return py::dict("energy"_a = copied(bodies->energy), "input"_a = copied(bodies->input),
                  "penetration"_a = copied(bodies->penetration), "gap"_a = std::ranges::max(bodies->gaps),
                  "slip"_a = bodies->slip);
}

/// The motion, warnings, what bodies did, and the reason where the run failed.
py::tuple simulate_one(const ScenePointer& scene, const std::string& engine_name, const std::string& settings,
                       const std::vector<std::string>& changes, double dt, double time_limit, bool bodies,
                       bool forces) {
  require_settings(settings);
  if (!(time_limit > 0))
    throw InputError("time_limit = " + number_text(time_limit) + ": must be a number > 0");
  require_above_zero("dt", dt);
  const WorkerEngine& engine = engine_named(engine_name);
  const EngineSeries series = make_series(engine, settings, {dt}, read_parameters(changes, engine));
  check_step(dt, scene->scene.duration);
  WorkerRun made;
  beside_interpreter([&](const std::function<bool()>& stopped) {
    const Limits limits{.time = time_limit, .cancelled = &stopped};
    made = run_in_worker(engine, scene->scene, dt, series.parameters, 0, limits, true, forces);
    if (made.status == "done") made.run.history.patterns = sampled_patterns(scene->scene, made.run.history);
  });
  if (made.status != "done")
    return py::make_tuple(py::none(), 0, py::none(), made.status + ": " + made.reason);
  if (forces && made.run.history.reactions.empty())
    throw InputError("forces: must be left out of " + engine.full_name() + ", which tells none");
  const std::size_t warnings = made.run.warnings;
  const py::object record = bodies ? to_dict(made.run.bodies) : py::none();
  SupportLoss support;
  if (made.run.bodies) support = support_of(made.run.bodies->penetration, made.run.bodies->unsupported_since);
  return py::make_tuple(std::make_shared<HeldMotion>(HeldMotion{scene, std::move(made.run.history), support}),
                        warnings, record, py::none());
}

std::vector<py::dict> canon(const std::string& engine_name, const std::string& settings,
                            const std::optional<std::vector<std::string>>& scenes, int draws,
                            const py::object& tell) {
  require_settings(settings);
  const WorkerEngine& engine = engine_named(engine_name);
  Suite suite = read_suite(find_file("canon", "suites"), {});
  require_valid({.replicates = draws});
  suite.replicates.runs = draws;
  if (scenes) {
    std::vector<NamedScene> chosen;
    for (const std::string& name : *scenes) {
      const auto found = std::ranges::find(suite.scenes, name, &NamedScene::name);
      if (found == suite.scenes.end()) throw InputError("scenes: " + name + ": must be a scene of the canon");
      chosen.push_back(*found);
    }
    suite.scenes = std::move(chosen);
  }
  std::vector<CanonAnswer> list;
  ToldProgress progress{tell, 0, suite.scenes.size()};
  beside_interpreter(
      [&](const std::function<bool()>& stopped) {
        for (const NamedScene& scene : suite.scenes) {
          if (stopped()) throw Cancelled();
          list.push_back(answer_canon(suite, scene, engine, settings));
          ++progress.done;
        }
      },
      progress);
  return mapped(list, [](const CanonAnswer& answer) {
    std::vector<double> amounts(canon_steps.size(), std::nan("")), steps_off = amounts;
    for (std::size_t i = 0; i < answer.deviations.size(); ++i) {
      amounts[i] = answer.deviations[i].amount();
      steps_off[i] = answer.deviations[i].time / canon_steps[i];
    }
    return py::dict("scene"_a = answer.scene, "verdict"_a = answer.verdict, "reason"_a = answer.reason,
                    "amounts"_a = amounts, "steps_off"_a = steps_off);
  });
}

/// A scene made in Python with its name and text, or what names a scene or a suite.
using Input = std::variant<std::tuple<ScenePointer, std::string, std::string>, std::string>;

Suite suite_of(const Input& input, const SceneChoice& choice) {
  if (const auto* made = std::get_if<0>(&input)) {
    const auto& [scene, name, text] = *made;
    return suite_for({folder_name(name), text, scene->scene, "scene", {}, scene->document.root}, choice);
  }
  const std::string& name = std::get<std::string>(input);
  std::error_code ignored;
  auto file = find_file(name, "suites");
  if (!std::filesystem::exists(file, ignored)) file = find_file(name, "scenes");
  const InputKind kind = kind_of(file);
  if (kind == InputKind::scene) return suite_for(read_named_scene(file, {}), choice);
  if (kind != InputKind::suite)
    throw InputError(name + ": must be a scene or a suite, studies are for the program");
  refuse(choice, name);
  return read_suite(file, {});
}

std::string compare_all(const std::vector<Input>& inputs, const std::filesystem::path& out,
                        const CompareChoice& choice, std::size_t jobs, const py::object& tell) {
  require_valid(choice);
  std::vector<Suite> suites;
  for (const Input& input : inputs) {
    const py::gil_scoped_release free;  // as in engine_named()
    apply(choice, suites.emplace_back(suite_of(input, choice.scenes)));
  }
  require_comparable(suites);
  const ResultsFolder folder(out, Results::comparison);
  CompareResult result;
  ToldProgress progress{tell};
  beside_interpreter(
      [&](const std::function<bool()>& stopped) {
        const auto follow = [&](const Progress& of) {
          progress.done = of.done;
          progress.total = of.total;
          if (stopped()) throw Cancelled();
        };
        result =
            compare(suites, out, *make_threads(jobs), {.command = "rockstack.compare", .progress = follow});
      },
      progress);
  return Json(result.rows).dump();
}

}  // namespace

void add_engines(py::module_& core) {
  core.def("engines", [] { return mapped(engines(), engine_dict); });
  core.def("simulate", &simulate_one);
  core.def("canon", &canon);
  py::class_<CompareChoice>(core, "CompareChoice")
      .def(py::init([](const std::vector<std::string>& engines, const std::vector<double>& steps, bool quick,
                       bool softness, bool forces, std::optional<int> replicates,
                       std::optional<double> history_interval,
                       const std::vector<std::pair<std::string, std::vector<std::filesystem::path>>>& files) {
        const auto trajectories = mapped(files, [](const auto& one) {
          return NamedTrajectory{one.first, one.second};
        });
        return CompareChoice{
            {engines, steps, quick, softness, trajectories, forces}, replicates, history_interval};
      }));
  core.def("compare", &compare_all);
  core.def("check_description", [](const std::string& answer) {
    try {
      check_descriptions(read_reply(read_message(answer)).engines);
    } catch (const std::runtime_error& error) {
      throw InputError(one_line(error.what()));
    }
  });
  core.def("column_meanings", [] {
    py::dict list;
    for (const Column& column : columns()) list[py::str(column.name)] = column.definition;
    return list;
  });
}

}  // namespace rockstack::python
