#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <functional>

#include "analytic/scene/input/scene_file.hpp"
#include "comparisons/measures/metrics/motion_verdict.hpp"

namespace rockstack::python {

namespace py = pybind11;

/// A scene with the document that it was made of, from which others with changed values are made.
struct GivenScene {
  SceneDocument document;
  Scene scene;
};

using ScenePointer = std::shared_ptr<const GivenScene>;

/// A history of a scene, whose numbers arrays look at in place.
struct HeldMotion {
  ScenePointer scene;
  History history;
  SupportLoss support = {};  ///< of an engine's run that told its bodies
};

/// To be asked again and again by work without the interpreter's lock: true once a signal's handler has
/// raised, as Ctrl-C does. Looks at signals twenty times a second.
std::function<bool()> interrupts();

/// What work may throw to end because it is to stop.
struct Cancelled {};

/// How far some work has come, and who is told: a function of Python of the two numbers, or None.
struct ToldProgress {
  py::object tell = py::none();
  std::atomic<std::size_t> done = 0, total = 0;
};

/// Does work in a thread of its own, without the interpreter's lock, tells how far it has come, and looks at
/// signals meanwhile. Once a handler or what is told has raised, `stopped` says so, from any thread, and what
/// was raised is thrown when the work has ended.
/// @throws what the work throws, but Cancelled.
void beside_interpreter(const std::function<void(const std::function<bool()>& stopped)>& work,
                        const ToldProgress& progress = {});

// What the files of this folder add to the module, as _core.pyi has it.
void add_scene(py::module_& core);
void add_motion(py::module_& core);
void add_solve(py::module_& core);
void add_ground(py::module_& core);
void add_sweep(py::module_& core);
void add_round(py::module_& core);
void add_engines(py::module_& core);  ///< and comparisons
void add_player(py::module_& core);   ///< and figures for print, where figures are built

}  // namespace rockstack::python
