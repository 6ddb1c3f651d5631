// What holds for the list of engines.

#include "engines/worker/registry.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "analytic/scene/messages/input_error.hpp"

namespace rockstack {
namespace {

std::string message_of_finding(const std::string& name) {
  try {
    find_engine(name);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The engines of C++, and each folder of npm's that has a worker.
std::set<std::string> known_engines() {
  std::set<std::string> names{"box2d",  "bullet", "bullet-single", "chipmunk", "dart",
                              "mujoco", "ode",    "siconos",       "simbody"};
  for (const auto& folder : std::filesystem::directory_iterator(ROCKSTACK_WEB_FOLDER))
    if (exists(folder.path() / "worker.mjs")) names.insert(folder.path().filename());
  return names;
}

TEST(Registry, EveryEngineIsThereOrNamedAsLeftOut) {
  std::set<std::string> names;
  for (const std::string& name : engines_left_out()) names.insert(name);
  for (const WorkerEngine& engine : engines()) names.insert(engine.name);
  EXPECT_EQ(names, known_engines());
}

TEST(Registry, EngineIsFoundByNameAndBySolver) {
  for (const WorkerEngine& engine : engines()) {
    EXPECT_EQ(&find_engine(engine.full_name()), &engine);
    EXPECT_EQ(find_engine(engine.name).name, engine.name);
  }
}

TEST(Registry, UnknownEngineIsNamedBesideThoseThatAreThere) {
  const std::string message = message_of_finding("newton");
  EXPECT_TRUE(contains(message, "newton")) << message;
  for (const WorkerEngine& engine : engines()) {
    EXPECT_TRUE(contains(message, engine.full_name())) << message;
  }
  for (const std::string& name : engines_left_out()) EXPECT_TRUE(contains(message, name)) << message;
}

}  // namespace
}  // namespace rockstack
