#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <nlohmann/json.hpp>

#include "analytic/scene/input/toml_reader.hpp"
#include "comparisons/interfaces/python/convert.hpp"
#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/measures/metrics/impacts.hpp"
#include "comparisons/measures/metrics/sizes.hpp"
#include "comparisons/measures/results/outcome_columns.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack::python {
namespace {

/// What messages say where a file has its name and the line.
constexpr const char* scene_place = "scene";

GivenScene make(SceneDocument document) {
  MotionLibrary library;
  Scene scene = make_scene(document, library);
  return {std::move(document), std::move(scene)};
}

GivenScene changed(const GivenScene& scene, const py::dict& values) {
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

template <double (*angle)(const Scene&, int)>
py::array_t<double> of_blocks(const Scene& scene) {
  std::vector<double> values;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) values.push_back(angle(scene, static_cast<int>(k)));
  return copied(values);
}

/// A property of the scene itself.
template <class Get>
auto of_scene(const Get& get) {
  return [get](const GivenScene& given) { return std::invoke(get, given.scene); };
}

/// A property that looks at a list of a history in place, `columns` numbers for each block of each sample;
/// None where the history does not have it.
template <class Number>
auto samples(const std::vector<Number> History::*list, py::ssize_t columns = 1) {
  return [list, columns](const py::object& self) -> py::object {
    const History& history = self.cast<const HeldMotion&>().history;
    if ((history.*list).empty() && !history.times.empty()) return py::none();
    Shape shape{static_cast<py::ssize_t>(history.size()), history.blocks};
    if (columns > 1) shape.push_back(columns);
    return view(history.*list, self, shape);
  };
}

/// Property of a list with one entry for each block or interface.
template <class Number>
auto of_each(const std::vector<Number> History::*list) {
  return [list](const py::object& self) -> py::object {
    const std::vector<Number>& entries = self.cast<const HeldMotion&>().history.*list;
    return entries.empty() ? py::object(py::none()) : view(entries, self);
  };
}

py::array_t<double> states(const History& history, std::vector<double> Event::*state) {
  py::array_t<double> array(Shape{static_cast<py::ssize_t>(history.events.size()), history.blocks});
  double* next = array.mutable_data();
  for (const Event& event : history.events)
    next = std::copy((event.*state).begin(), (event.*state).end(), next);
  return array;
}

/// The columns of events, by name.
py::dict events(const HeldMotion& motion) {
  const History& history = motion.history;
  const std::vector<Event>& list = history.events;
  py::dict columns;
  columns["time"] = copied(mapped(list, &Event::time));
  columns["kind"] = mapped(list, [](const Event& event) { return name(event.kind); });
  columns["interface"] = copied(mapped(list, &Event::interface));
  columns["from"] = mapped(list, [](const Event& event) { return name(event.from); });
  columns["to"] = mapped(list, [](const Event& event) { return name(event.to); });
  columns["angles"] = states(history, &Event::angles);
  columns["before"] = states(history, &Event::before);
  columns["after"] = states(history, &Event::after);
  columns["consistency"] = mapped(list, [](const Event& event) { return name(event.consistency); });
  columns["approach"] = copied(mapped(list, [&](const Event& event) {
    const auto interface = static_cast<std::size_t>(event.interface - 1);
    return is_impact(event.kind) ? approach_speed(event, interface_width(motion.scene->scene, interface))
                                 : std::nan("");
  }));
  return columns;
}

std::vector<std::string> patterns(const HeldMotion& motion) {
  return mapped(motion.history.patterns, [](const Pattern& pattern) { return name(pattern); });
}

/// What interfaces carry at each sample; None where samples have no patterns.
py::object reactions(const HeldMotion& motion) {
  const History& history = motion.history;
  if (history.patterns.size() != history.size()) return py::none();
  const std::vector<Reaction> list = reactions_of(motion.scene->scene, history);
  py::array_t<Reaction> array(Shape{static_cast<py::ssize_t>(history.size()), history.blocks});
  std::copy(list.begin(), list.end(), array.mutable_data());
  return array;
}

/// Whether all lists of a history have the lengths that so many blocks give, and what is numbered is there.
bool is_of(const History& history, std::size_t blocks) {
  const std::size_t samples = history.size();
  const auto has = [](const auto& list, std::size_t entries) {
    return list.empty() || list.size() == entries;
  };
  const auto each = [&](const auto& list) { return has(list, blocks); };
  const auto rows = [&](const auto& list) { return has(list, samples * blocks); };
  const auto numbered = [&](const auto& one) {
    return one.interface >= 1 && static_cast<std::size_t>(one.interface) <= blocks;
  };
  const auto fits = [&](const Pattern& pattern) { return static_cast<std::size_t>(pattern.size) == blocks; };
  const auto whole = [&](const Event& event) {
    return numbered(event) && fits(event.from) && fits(event.to) && event.angles.size() == blocks &&
           event.before.size() == blocks && event.after.size() == blocks;
  };
  return static_cast<std::size_t>(history.blocks) == blocks && history.angles.size() == samples * blocks &&
         history.velocities.size() == samples * blocks && has(history.patterns, samples) &&
         std::ranges::all_of(history.patterns, fits) && std::ranges::all_of(history.events, whole) &&
         std::ranges::all_of(history.grazes, numbered) && std::ranges::all_of(history.choices, numbered) &&
         rows(history.slips) && rows(history.gaps) && has(history.centres, 2 * samples * blocks) &&
         has(history.centre_velocities, 2 * samples * blocks) && rows(history.reactions) &&
         rows(history.spring_energies) && each(history.peaks) && each(history.uplifts) &&
         each(history.slips_left) && each(history.largest_slips) && each(history.lifts) &&
         each(history.forces) && each(history.impulses);
}

/// Times and interfaces of what the numbers could not tell.
std::vector<py::tuple> doubts(const std::vector<BasicGraze<double>>& list) {
  return mapped(
      list, [](const auto& doubt) { return py::make_tuple(doubt.time, name(doubt.kind), doubt.interface); });
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
                             [](const GivenScene& given) { return to_python(given.document.root); })
      .def_property_readonly("folder", [](const GivenScene& given) { return given.document.folder; })
      .def_property_readonly("title", of_scene(&Scene::title))
      .def_property_readonly("duration", of_scene(&Scene::duration))
      .def_property_readonly("gravity", of_scene(&Scene::gravity))
      .def_property_readonly("law", of_scene([](const Scene& scene) { return name(scene.law); }))
      .def_property_readonly("equations", of_scene([](const Scene& scene) { return name(scene.equations); }))
      .def_property_readonly("blocks", of_scene([](const Scene& scene) { return scene.blocks.size(); }))
      .def_property_readonly("friction",
                             of_scene([](const Scene& scene) { return copied(friction_of(scene)); }))
      .def_property_readonly("slenderness", of_scene(of_blocks<slenderness>))
      .def_property_readonly("toppling_angles", of_scene(of_blocks<toppling_angle>));
}

void add_motion(py::module_& core) {
  PYBIND11_NUMPY_DTYPE(Demand, least_normal, least_normal_time, friction, friction_time, first_pull_time,
                       first_slip_time);
  PYBIND11_NUMPY_DTYPE(Reaction, normal, tangential, centre);
  PYBIND11_NUMPY_DTYPE(SpringEnergy, elastic, damped, rubbed);
  py::class_<HeldMotion, std::shared_ptr<HeldMotion>>(core, "Motion")
      .def("packed", &packed<HeldMotion>)
      .def_static("unpacked",
                  [](const ScenePointer& scene, const py::bytes& bytes) {
                    auto motion = unpacked<HeldMotion>(bytes);
                    require_packed(is_of(motion.history, scene->scene.blocks.size()));
                    motion.scene = scene;
                    return motion;
                  })
      .def_property_readonly(
          "times",
          [](const py::object& self) { return view(self.cast<const HeldMotion&>().history.times, self); })
      .def_property_readonly("angles", samples(&History::angles))
      .def_property_readonly("velocities", samples(&History::velocities))
      .def_property_readonly("slips", samples(&History::slips))
      .def_property_readonly("gaps", samples(&History::gaps))
      .def_property_readonly("places", samples(&History::centres, 2))
      .def_property_readonly("place_rates", samples(&History::centre_velocities, 2))
      .def_property_readonly("spring_energies", samples(&History::spring_energies))
      .def_property_readonly("peaks", of_each(&History::peaks))
      .def_property_readonly("uplifts", of_each(&History::uplifts))
      .def_property_readonly("slips_left", of_each(&History::slips_left))
      .def_property_readonly("largest_slips", of_each(&History::largest_slips))
      .def_property_readonly("lifts", of_each(&History::lifts))
      .def_property_readonly("forces", of_each(&History::forces))
      .def_property_readonly("impulses", of_each(&History::impulses))
      .def_property_readonly("event_columns", &events)
      .def_property_readonly("patterns", &patterns)
      .def_property_readonly("reactions", &reactions)
      .def_property_readonly("grazes", [](const HeldMotion& motion) { return doubts(motion.history.grazes); })
      .def_property_readonly("choices",
                             [](const HeldMotion& motion) { return doubts(motion.history.choices); })
      .def_property_readonly("verdict",
                             [](const HeldMotion& motion) {
                               return motion.history.times.empty()
                                          ? std::string()
                                          : motion_verdict(motion.scene->scene, motion.history,
                                                           motion.support);
                             })
      .def_property_readonly("outcome",
                             [](const HeldMotion& motion) {
                               return outcome_json(run_outcome(motion.scene->scene, motion.history)).dump();
                             })
      .def_property_readonly("warnings", [](const HeldMotion& motion) {
        std::vector<std::string> warnings = size_warnings(motion.scene->scene);
        for (std::string& warning : validity_warnings(motion.scene->scene, motion.history))
          warnings.push_back(std::move(warning));
        return warnings;
      });
}

}  // namespace rockstack::python
