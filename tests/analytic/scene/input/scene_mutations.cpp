#include "tests/analytic/scene/input/scene_mutations.hpp"

#include <stdexcept>

#include "analytic/scene/input/scene_file.hpp"
#include "analytic/scene/messages/input_error.hpp"

namespace rockstack {

std::vector<std::string> scenes_with_every_key() {
  const std::string block = "[[blocks]]\nwidth = 1.0\nheight = 2.5\ndensity = 2500\n";
  const std::string head =
      "title = \"a \\\"b\\\" c\"\nduration = 2.5\ngravity = 9.81\nlaw = \"consistent\"\nequations = "
      "\"linear\"\n";
  return {
      head + block + block +
          "[initial]\nangles = [0.15, -0.1]\nvelocities = [0, 1e-3]\n[engine]\nfriction = 0.8\ndepth = 2\n",
      head +
          "[[blocks]]\nwidth = 1\nheight = 2\nmass = 100\ninertia = 40.5\n[ground.horizontal]\nsamples = [0, "
          "1.5, -2]\n"
          "interval = 0.01\nscale = 2\n[ground.vertical]\nsamples = [0, 1]\ninterval = 0.5\npeak = 3\n",
      head + block +
          "[ground.horizontal]\npulse = \"mavroeidis-papageorgiou\"\namplitude = 3\nperiod = 0.5\nstart = "
          "0.1\n"
          "cycles = 2\nphase = 0.3\n[ground.vertical]\npulse = \"ricker\"\namplitude = 1\nperiod = 0.5\n",
      head + block +
          "[ground.horizontal]\nsynthetic = 3\npeak = 2\nduration = 2\ninterval = 0.02\nfrequency = "
          "3\ndamping = 0.5\n"
          "[ground.vertical]\nrecord = \"none.at2\"\n",
  };
}

bool is_read(const TemporaryFolder& folder, const std::string& text) {
  const auto file = folder.write("scene.toml", text);
  try {
    validate(read_scene(file));
    return true;
  } catch (const InputError& error) {
    const std::string line = error.what();
    if (!line.starts_with(file.string()) || line.find('\n') != std::string::npos)
      throw std::logic_error("not one line: " + line);
    return false;
  } catch (const FieldError& error) {
    throw std::logic_error(std::string("read, but not valid: ") + error.what());
  }
}

}  // namespace rockstack
