#include "comparisons/measures/results/provenance.hpp"

#include <fmt/format.h>
#include <Eigen/Core>

#include <fstream>

#include "comparisons/measures/metrics/impacts.hpp"
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

Json scene_json(const Scene& scene) {
  std::string ground = scene.horizontal.source;
  if (!scene.vertical.empty()) ground += (ground.empty() ? "" : "; ") + scene.vertical.source + ", vertical";
  const auto block_json = [](const Block& block) {
    return Json{
        {"width", 2 * block.half_width}, {"height", 2 * block.half_height}, {"mass", block.mass},
        {"inertia", block.inertia},      {"offset_x", block.offset_x},      {"offset_y", block.offset_y}};
  };
  return {{"title", scene.title},
          {"blocks", scene.blocks.size()},
          {"stack", mapped(scene.blocks, block_json)},
          {"gravity", scene.gravity},
          {"duration", scene.duration},
          {"ground", ground},
          {"chatter_speed", chatter_speed(scene)},
          {"settling_duration", settling_duration(scene)},
          {"law", name(scene.law)},
          {"friction", friction_of(scene)}};
}

RecordedScene recorded_scene(const Json& json) {
  RecordedScene scene{json.at("title").get<std::string>(),  {},
                      json.at("gravity").get<double>(),     json.at("duration").get<double>(),
                      json.at("ground").get<std::string>(), json.at("chatter_speed").get<double>(),
                      json.at("law").get<std::string>(),    json.at("friction").get<std::vector<double>>()};
  for (const Json& block : json.at("stack"))
    scene.stack.push_back({block.at("width").get<double>() / 2, block.at("height").get<double>() / 2,
                           block.at("mass").get<double>(), block.at("inertia").get<double>(),
                           block.at("offset_x").get<double>(), block.at("offset_y").get<double>()});
  if (scene.stack.empty() || scene.stack.size() > max_blocks)
    throw std::invalid_argument(
        fmt::format("stack has {} blocks: must have 1 to {}", scene.stack.size(), max_blocks));
  return scene;
}

}  // namespace rockstack
