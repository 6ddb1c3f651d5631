#include "comparisons/measures/results/scene_json.hpp"

#include <nlohmann/json.hpp>
#include <string>

#include "comparisons/measures/metrics/impacts.hpp"

namespace rockstack {
namespace {

using Json = nlohmann::ordered_json;

std::string ground_of(const Scene& scene) {
  std::string text = scene.horizontal.source;
  if (!scene.vertical.empty()) text += (text.empty() ? "" : "; ") + scene.vertical.source + ", vertical";
  return text;
}

/// Sizes and masses, bottom to top.
Json stack_json(const Scene& scene) {
  Json list = Json::array();
  for (const Block& block : scene.blocks) {
    list.push_back({{"width", 2 * block.half_width},
                    {"height", 2 * block.half_height},
                    {"mass", block.mass},
                    {"inertia", block.inertia},
                    {"offset_x", block.offset_x},
                    {"offset_y", block.offset_y}});
  }
  return list;
}

}  // namespace

Json scene_json(const Scene& scene) {
  return {{"title", scene.title},
          {"blocks", scene.blocks.size()},
          {"stack", stack_json(scene)},
          {"gravity", scene.gravity},
          {"duration", scene.duration},
          {"ground", ground_of(scene)},
          {"chatter_speed", chatter_speed(scene)},
          {"settling_duration", settling_duration(scene)},
          {"law", name(scene.law)},
          {"friction", friction_of(scene)}};
}

}  // namespace rockstack
