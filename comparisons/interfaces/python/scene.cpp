#include "comparisons/interfaces/python/scene.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <utility>

#include "analytic/scene/input/toml_reader.hpp"
#include "comparisons/interfaces/python/arrays.hpp"
#include "comparisons/interfaces/python/nodes.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack::python {
namespace {

namespace py = pybind11;

/// What messages say where a file has its name and the line.
constexpr const char* scene_place = "scene";

std::shared_ptr<GivenScene> make(SceneDocument document) {
  MotionLibrary library;
  Scene scene = make_scene(document, library);
  return std::make_shared<GivenScene>(GivenScene{std::move(document), std::move(scene)});
}

std::shared_ptr<GivenScene> changed(const GivenScene& scene, const py::dict& values) {
  SceneDocument document = scene.document;
  for (const auto& [key, value] : values) {
    Node node;
    node.key = key.cast<std::string>();
    node.place = scene_place;
    read_value(value, node);
    set_value(document.root, node.key, node);
  }
  return make(std::move(document));
}

const char* equations_name(const GivenScene& given_scene) {
  static constexpr std::array names{"nonlinear", "linear", "small-angle"};
  return names[static_cast<std::size_t>(given_scene.scene.equations)];
}

py::array_t<double> of_each(const GivenScene& given_scene, double (*angle)(const Scene&, int)) {
  std::vector<double> values;
  for (std::size_t k = 0; k < given_scene.scene.blocks.size(); ++k)
    values.push_back(angle(given_scene.scene, static_cast<int>(k)));
  return copied(values);
}

}  // namespace

void add_scene(py::module_& core) {
  core.def("toml_text", [](const std::string& text) { return toml_text(text); });
  py::class_<GivenScene, std::shared_ptr<GivenScene>>(core, "Scene")
      .def_static(
          "made",
          [](const py::object& mapping, const std::filesystem::path& folder, const std::string& title) {
            return make({read_document(mapping, scene_place), folder, title});
          })
      .def_static("read",
                  [](const std::string& name, const std::vector<std::string>& overrides) {
                    return make(rockstack::read_document(find_file(name, "scenes"), overrides));
                  })
      .def("changed", &changed)
      .def_property_readonly("document",
                             [](const GivenScene& scene) { return to_python(scene.document.root); })
      .def_property_readonly("folder", [](const GivenScene& scene) { return scene.document.folder; })
      .def_property_readonly("title", [](const GivenScene& scene) { return scene.scene.title; })
      .def_property_readonly("duration", [](const GivenScene& scene) { return scene.scene.duration; })
      .def_property_readonly("gravity", [](const GivenScene& scene) { return scene.scene.gravity; })
      .def_property_readonly("law", [](const GivenScene& scene) { return name(scene.scene.law); })
      .def_property_readonly("equations", &equations_name)
      .def_property_readonly("blocks", [](const GivenScene& scene) { return scene.scene.blocks.size(); })
      .def_property_readonly("friction",
                             [](const GivenScene& scene) { return copied(friction_of(scene.scene)); })
      .def_property_readonly("slenderness",
                             [](const GivenScene& scene) { return of_each(scene, &slenderness); })
      .def_property_readonly("toppling_angles",
                             [](const GivenScene& scene) { return of_each(scene, &toppling_angle); });
}

}  // namespace rockstack::python
