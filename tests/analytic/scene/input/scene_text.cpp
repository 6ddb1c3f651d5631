#include "tests/analytic/scene/input/scene_text.hpp"

#include "analytic/scene/input/scene_file.hpp"
#include "analytic/scene/messages/input_error.hpp"

namespace rockstack {

std::string two_blocks() {
  return R"(duration = 5
[[blocks]]
width = 1.25
height = 1.25
density = 2500
[[blocks]]
width = 1.0
height = 2.5
density = 2500
[initial]
angles = [0.15, 0.1]
velocities = [0, -0.5]
)";
}

std::string error_of(const std::string& text, const std::vector<std::string>& overrides) {
  const TemporaryFolder folder;
  try {
    read_scene(folder.write("scene.toml", text), overrides);
  } catch (const InputError& error) {
    std::string line = error.what();
    const std::string before = folder.path().string() + "/";
    for (auto at = line.find(before); at != std::string::npos; at = line.find(before)) {
      line.erase(at, before.size());
    }
    return line;
  }
  return {};
}

}  // namespace rockstack
