#include "tests/comparisons/studies/sweep/sweep_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "analytic/scene/messages/input_error.hpp"

namespace rockstack {

std::string ensemble_of_one_block(const std::string& variations) {
  return R"(title = "One block under one sine"
[scene]
duration = 2
[[scene.blocks]]
width = 0.2
height = 1
mass = 1000
[scene.ground.horizontal]
pulse = "sine"
amplitude = 3
period = 0.5
)" + variations;
}

Ensemble ensemble_from(const std::string& text) {
  const TemporaryFolder folder;
  MotionLibrary library;
  return read_ensemble(folder.write("ensemble.toml", text), {}, library);
}

std::string ensemble_error(const std::string& text) {
  const TemporaryFolder folder;
  MotionLibrary library;
  try {
    read_ensemble(folder.write("ensemble.toml", text), {}, library);
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

SweepResult sweep_into(const std::filesystem::path& folder, const Ensemble& ensemble, const SweepPlan& plan) {
  MotionLibrary library;
  std::size_t blocks = 0;
  return sweep(ensemble, library, *make_threads(plan.threads),
               {folder, "test", [](std::size_t, std::size_t, std::size_t) {},
                [&] { return blocks++ >= plan.blocks; }, plan.format});
}

std::string bytes_in(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace rockstack
