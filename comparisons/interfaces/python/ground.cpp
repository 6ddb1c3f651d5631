#include <pybind11/stl.h>

#include "analytic/scene/ground/records/format.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/interfaces/python/convert.hpp"
#include "comparisons/measures/metrics/ground.hpp"

namespace rockstack::python {
namespace {

using namespace py::literals;

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// The key of a motion in messages, and what they say in place of file and line.
constexpr const char* motion_key = "motion";

GroundMotion make_ground(const py::object& mapping) {
  const Node table = read_document(mapping, motion_key);
  MotionLibrary library;
  try {
    GroundMotion motion = read_ground_motion(table, {}, library);
    validate(motion, motion_key);
    return motion;
  } catch (const FieldError& error) {
    throw InputError(error.what());
  }
}

const GroundMotion& sampled(const GroundMotion& motion) {
  if (motion.samples.empty())
    throw InputError(motion.source +
                     ": must be a motion with samples; sampled(interval) makes one of a pulse");
  return motion;
}

Numbers accelerations(const GroundMotion& motion, const Numbers& times) {
  Numbers result(Shape(times.shape(), times.shape() + times.ndim()));
  std::transform(times.data(), times.data() + times.size(), result.mutable_data(), [&](double time) {
    if (!(time >= 0)) throw InputError("times: " + number_text(time) + " s: must be numbers from 0");
    return acceleration(motion, time);
  });
  return result;
}

py::dict to_dict(const Peak& peak) {
  return py::dict("value"_a = peak.value, "time"_a = peak.time);
}

py::dict to_dict(const Span& span) {
  return py::dict("begin"_a = span.begin, "end"_a = span.end, "length"_a = span.length());
}

py::dict measures(const GroundMotion& motion) {
  const GroundMeasures measures = measure_ground(sampled(motion));
  return py::dict(
      "points"_a = measures.points, "interval"_a = measures.interval, "duration"_a = measures.duration,
      "peak_acceleration"_a = to_dict(measures.acceleration), "peak_velocity"_a = to_dict(measures.velocity),
      "peak_displacement"_a = to_dict(measures.displacement), "final_velocity"_a = measures.final_velocity,
      "final_displacement"_a = measures.final_displacement, "arias_intensity"_a = measures.arias_intensity,
      "significant_5_95"_a = to_dict(measures.significant_5_95),
      "significant_5_75"_a = to_dict(measures.significant_5_75));
}

/// Periods and pseudo-accelerations.
std::pair<py::array_t<double>, py::array_t<double>> spectrum(
    const GroundMotion& motion, const std::optional<std::vector<double>>& periods, double damping) {
  sampled(motion);
  if (!(damping >= 0 && damping < 1))
    throw InputError("damping = " + number_text(damping) + ": must be a number from 0, below 1");
  const double least = motion.interval / 100;
  for (const double period : periods.value_or(std::vector<double>()))
    if (!(period >= least && period <= largest_number))
      throw InputError("periods: " + number_text(period) + " s: must be numbers from " + number_text(least) +
                       " to " + number_text(largest_number));
  std::vector<Response> responses;
  {
    const py::gil_scoped_release free;
    responses = periods ? mapped(*periods, [&](double period) { return response(motion, period, damping); })
                        : response_spectrum(motion, damping);
  }
  return {copied(mapped(responses, &Response::period)),
          copied(mapped(responses, &Response::pseudo_acceleration))};
}

std::pair<double, double> base_line(const GroundMotion& motion) {
  const BaseLine line = fitted_base_line(sampled(motion));
  return {line.value, line.slope};
}

}  // namespace

void add_ground(py::module_& core) {
  core.def("unit_factor", &records::unit_factor);
  py::class_<GroundMotion, std::shared_ptr<GroundMotion>>(core, "GroundMotion")
      .def_static("made", &make_ground)
      .def("packed", &packed<GroundMotion>)
      .def_static("unpacked",
                  [](const py::bytes& bytes) {
                    auto motion = unpacked<GroundMotion>(bytes);
                    validate(motion, motion_key);
                    return motion;
                  })
      .def_static("of_scene",
                  [](const GivenScene& scene, const std::string& axis) {
                    return axis == "vertical" ? scene.scene.vertical : scene.scene.horizontal;
                  })
      .def_property_readonly(
          "samples",
          [](const py::object& self) { return view(self.cast<const GroundMotion&>().samples, self); })
      .def_property_readonly("interval", [](const GroundMotion& motion) { return motion.interval; })
      .def_property_readonly("end", &GroundMotion::end)
      .def_property_readonly("source", [](const GroundMotion& motion) { return motion.source; })
      .def("acceleration", &accelerations)
      .def("velocities",
           [](const GroundMotion& motion) { return copied(ground_integrals(sampled(motion)).velocities); })
      .def("displacements",
           [](const GroundMotion& motion) { return copied(ground_integrals(sampled(motion)).displacements); })
      .def("husid", [](const GroundMotion& motion) { return copied(husid(sampled(motion))); })
      .def("measures", &measures)
      .def("spectrum", &spectrum)
      .def("base_line", &base_line);
}

}  // namespace rockstack::python
