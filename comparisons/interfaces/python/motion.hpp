#pragma once

#include <pybind11/pybind11.h>

#include "analytic/scene/history.hpp"
#include "comparisons/interfaces/python/scene.hpp"
#include "comparisons/measures/metrics/motion_verdict.hpp"

namespace rockstack::python {

/// A history of a scene, whose numbers arrays look at in place.
struct HeldMotion {
  ScenePointer scene;
  History history;
  Support support = {};  ///< of an engine's run that told its bodies
};

void add_motion(pybind11::module_& core);

}  // namespace rockstack::python
