#include <pybind11/stl.h>

#include "analytic/solve.hpp"
#include "comparisons/interfaces/python/convert.hpp"
#include "comparisons/studies/round/study.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack::python {
namespace {

/// A mapping as a file has it, or a name.
SceneDocument cylinder_document(const py::object& cylinder) {
  if (py::isinstance<py::str>(cylinder))
    return rockstack::read_document(input_file(cylinder.cast<std::string>(), {"cylinders"}),
                                    std::vector<std::string>{});
  return {read_document(cylinder, "cylinder"), {}, ""};
}

py::dict columns_of(const std::vector<RoundState>& states) {
  py::dict columns;
  const auto add = [&](const char* name, const auto& value) {
    columns[name] = copied(mapped(states, value));
  };
  add("time", [](const RoundState& state) { return state.time; });
  add("tilt", [](const RoundState& state) { return state.rolling.tilt; });
  add("azimuth", [](const RoundState& state) { return state.rolling.azimuth; });
  add("omega_tilt", [](const RoundState& state) { return state.rolling.tilt_rate; });
  add("omega_rim", [](const RoundState& state) { return state.rolling.omega1; });
  add("omega_axis", [](const RoundState& state) { return state.rolling.omega3; });
  add("normal", [](const RoundState& state) { return state.support.normal; });
  add("friction_needed", [](const RoundState& state) { return state.support.friction; });
  add("energy", [](const RoundState& state) { return state.energy; });
  return columns;
}

py::tuple round_motion(const py::object& cylinder, double interval) {
  MotionLibrary library;
  const RoundScene scene = make_round(cylinder_document(cylinder), library);
  const RoundMotion motion = solve_round(scene, regular_times(interval, scene.duration));
  py::list names;
  for (const auto& event : motion.events) names.append(round_events[static_cast<std::size_t>(event.first)]);
  const auto states = mapped(motion.events, [](const auto& event) { return event.second; });
  return py::make_tuple(columns_of(motion.samples), names, columns_of(states), topples(scene, motion));
}

}  // namespace

void add_round(py::module_& core) {
  core.def("round_motion", &round_motion);
}

}  // namespace rockstack::python
