#include "comparisons/measures/results/provenance.hpp"

#include <fmt/format.h>
#include <Eigen/Core>

#include <fstream>

#include "analytic/scene/input/json_reader.hpp"
#include "analytic/scene/input/page_scene.hpp"
#include "analytic/scene/input/scene_file.hpp"
#include "analytic/scene/input/toml_reader.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/build.hpp"

namespace rockstack {
namespace {

/// The processor's own name, as Linux gives it.
std::string processor() {
  std::ifstream stream("/proc/cpuinfo");
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

Json motion_fields(const GroundMotion& motion) {
  const auto& [interval, samples, source, made_up, pulse, steps] = motion;
  Json of_pulse;
  if (pulse) {
    const auto& [shape, amplitude, period, start, cycles, phase] = *pulse;
    of_pulse = std::tuple(shape, amplitude, period, start, cycles, phase);
  }
  Json fields = std::tuple(interval, samples, source, made_up, of_pulse);
  for (const auto& [time, size] : steps) fields.push_back(std::tuple(time, size));
  return fields;
}

Json point_fields(const BlockPoint& point) {
  const auto& [block, x, y] = point;
  return std::tuple(block, x, y);
}

Json push_fields(const Push& push) {
  const auto& [point, direction, force] = push;
  return std::tuple(point_fields(point), direction, motion_fields(force));
}

Json restraint_fields(const Restraint& restraint) {
  const auto& [kind, from, to, stiffness, prestress, yield, damping] = restraint;
  return std::tuple(kind, point_fields(from), point_fields(to), stiffness, prestress, number_text(yield),
                    damping);
}

}  // namespace

std::map<std::string, std::string> environment(const std::vector<const WorkerEngine*>& engines) {
  std::map<std::string, std::string> facts{
      {"rockstack", build::version},
      {"compiler", build::compiler},
      {"flags", build::flags},
      {"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"processor", processor()},
  };
  for (const WorkerEngine* engine : engines) facts[engine->name] = engine->version;
  return facts;
}

// Members are bound by their number, so that a struct with another one does not compile until it counts here.
Json scene_fields(const Scene& scene) {
  const auto& [title, duration, gravity, inclination, law, equations, restitution, blocks, friction,
               kinetic_friction, point_restitution, restitution_law, springs, wall, initial, horizontal,
               vertical, pushes, restraints, depth] = scene;
  const Json each = mapped(blocks, [](const Block& block) -> Json {
    const auto& [half_width, half_height, mass, inertia, offset_x, offset_y] = block;
    return std::tuple(half_width, half_height, mass, inertia, offset_x, offset_y);
  });
  const auto& [stiffness, damping, bed_stiffness, bed_damping, tangential] = springs;
  const auto& [angles, velocities, slip_velocities, preloaded, offsets, gaps, gap_velocities] = initial;
  Json fields{
      {"title", title},
      {"duration", duration},
      {"gravity", gravity},
      {"inclination", inclination},
      {"law", law},
      {"equations", equations},
      {"restitution", restitution},
      {"blocks", each},
      {"friction", friction},
      {"kinetic_friction", kinetic_friction},
      {"point_restitution", point_restitution},
      {"restitution_law", restitution_law},
      {"springs", std::tuple(stiffness, damping, bed_stiffness, bed_damping, tangential)},
      {"wall", std::tuple(wall.side, wall.restitution.value_or(-1))},
      {"initial", std::tuple(angles, velocities, slip_velocities, preloaded, offsets, gaps, gap_velocities)},
      {"horizontal", motion_fields(horizontal)},
      {"vertical", motion_fields(vertical)},
      {"depth", depth}};
  // Identities of scenes without them stay as they were.
  if (!pushes.empty()) fields["pushes"] = mapped(pushes, push_fields);
  if (!restraints.empty()) fields["restraints"] = mapped(restraints, restraint_fields);
  return fields;
}

std::string ground_words(const Scene& scene) {
  const std::string& along = scene.horizontal.source;
  if (scene.vertical.empty()) return along;
  return along + (along.empty() ? "" : "; ") + scene.vertical.source + ", vertical";
}

Scene recorded_scene(const Json& json, const std::string& text, const std::string& place) {
  const std::string page = json.value("page", "");
  Node root = page.empty() ? parse_toml(text, place) : scene_document(parse_json(page, place + ": "), place);
  const auto is_apart = [](const Node& table) { return table.name == "ground" || table.name == "measured"; };
  if (page.empty()) std::erase_if(root.children, is_apart);
  MotionLibrary library;
  return make_scene({std::move(root), {}, json.value("title", "")}, library);
}

}  // namespace rockstack
