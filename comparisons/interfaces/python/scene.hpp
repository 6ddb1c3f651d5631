#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "analytic/scene/input/scene_file.hpp"

namespace rockstack::python {

/// A scene with the document that it was made of, from which others with changed values are made.
struct GivenScene {
  SceneDocument document;
  Scene scene;
};

using ScenePointer = std::shared_ptr<const GivenScene>;

void add_scene(pybind11::module_& core);

}  // namespace rockstack::python
