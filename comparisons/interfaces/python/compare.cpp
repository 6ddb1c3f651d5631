#include "comparisons/runs/compare.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/interfaces/python/module.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/results_folder.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack::python {
namespace {

/// A scene made in Python with its name and text, or what names a scene or a suite.
using Input = std::variant<std::tuple<ScenePointer, std::string, std::string>, std::string>;

Suite suite_of(const Input& input, const SceneChoice& choice) {
  if (const auto* made = std::get_if<0>(&input)) {
    const auto& [scene, name, text] = *made;
    return suite_for({folder_name(name), text, scene->scene, "scene"}, choice);
  }
  const std::string& name = std::get<std::string>(input);
  std::error_code ignored;
  auto file = find_file(name, "suites");
  if (!std::filesystem::exists(file, ignored)) file = find_file(name, "scenes");
  const InputKind kind = kind_of(file);
  if (kind == InputKind::scene) return suite_for(read_named_scene(file, {}), choice);
  if (kind != InputKind::suite)
    throw InputError(name + ": must be a scene or a suite, studies are for the program");
  if (!choice.engines.empty() || !choice.steps.empty() || choice.quick || choice.softness)
    throw InputError("engines, dt, quick and softness: must be left out of " + name +
                     ", a suite says its own");
  return read_suite(file, {});
}

std::string compare_all(const std::vector<Input>& inputs, const std::filesystem::path& out,
                        const SceneChoice& choice, int draws, std::optional<double> history_interval,
                        std::size_t jobs) {
  std::vector<Suite> suites;
  for (const Input& input : inputs) {
    Suite& suite = suites.emplace_back(suite_of(input, choice));
    if (draws > 0) set_runs(suite.draws, draws);
    if (history_interval) suite.history_interval = *history_interval;
  }
  require_comparable(suites);
  const ResultsFolder folder(out, Results::comparison);
  CompareResult result;
  beside_interpreter([&](const std::atomic<bool>& stop) {
    result =
        compare(suites, out, {.command = "rockstack.compare", .jobs = jobs, .progress = [&](const Progress&) {
                                if (stop) throw Cancelled();
                              }});
  });
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const RunMetrics& row : result.rows) rows.push_back(metrics_json(row));
  return rows.dump();
}

py::dict meanings() {
  py::dict list;
  for (const Column& column : columns()) list[column.name] = column.definition;
  return list;
}

}  // namespace

void add_compare(py::module_& core) {
  py::class_<SceneChoice>(core, "SceneChoice")
      .def(py::init(
          [](std::vector<std::string> engines, std::vector<double> steps, bool quick, bool softness) {
            return SceneChoice{std::move(engines), std::move(steps), quick, softness};
          }));
  core.def("compare", &compare_all);
  core.def("column_meanings", &meanings);
}

}  // namespace rockstack::python
