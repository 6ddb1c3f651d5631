#include "engines/worker/registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <map>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "analytic/scene/messages/input_error.hpp"
#include "engines/worker/installation.hpp"

namespace rockstack {
namespace {

namespace fs = std::filesystem;

struct Known {
  const char* engine;
  bool built;
};

#ifdef ROCKSTACK_WITH_WEB
constexpr bool web_built = true;
#else
constexpr bool web_built = false;
#endif

constexpr std::array known{
#ifdef ROCKSTACK_WITH_BULLET
    Known{"bullet", true},
#else
    Known{"bullet", false},
#endif
#ifdef ROCKSTACK_WITH_ODE
    Known{"ode", true},
#else
    Known{"ode", false},
#endif
#ifdef ROCKSTACK_WITH_BULLET
    Known{"bullet-single", true},
#else
    Known{"bullet-single", false},
#endif
#ifdef ROCKSTACK_WITH_BOX2D
    Known{"box2d", true},
#else
    Known{"box2d", false},
#endif
#ifdef ROCKSTACK_WITH_CHIPMUNK
    Known{"chipmunk", true},
#else
    Known{"chipmunk", false},
#endif
#ifdef ROCKSTACK_WITH_MUJOCO
    Known{"mujoco", true},
#else
    Known{"mujoco", false},
#endif
#ifdef ROCKSTACK_WITH_DART
    Known{"dart", true},
#else
    Known{"dart", false},
#endif
#ifdef ROCKSTACK_WITH_SICONOS
    Known{"siconos", true},
#else
    Known{"siconos", false},
#endif
#ifdef ROCKSTACK_WITH_SIMBODY
    Known{"simbody", true},
#else
    Known{"simbody", false},
#endif
    Known{"jolt", web_built},     Known{"rapier", web_built},
    Known{"physx", web_built},    Known{"mujoco-js", web_built},
    Known{"planck", web_built},   Known{"cannon-es", web_built},
    Known{"havok", web_built},
};

constexpr const char* prefix = "rockstack-";

fs::path find_worker(const std::string& name) {
  fs::path file = worker_folder() / name;
  std::error_code ignored;
  if (fs::exists(file, ignored)) return file;
  throw std::runtime_error(fmt::format("{}: must be there, it came with this program", file.string()));
}

std::vector<std::string> folders_of(const std::string& given) {
  std::vector<std::string> folders;
  std::istringstream stream(given);
  for (std::string folder; std::getline(stream, folder, ':');) {
    if (!folder.empty()) folders.push_back(folder);
  }
  return folders;
}

/// Programs in the folders of workers_variable, in order of folders and then of names.
std::vector<fs::path> found_workers() {
  std::vector<fs::path> programs;
  const char* given = std::getenv(workers_variable);
  if (given == nullptr) return {};
  require_folders(workers_variable, given);
  for (const std::string& folder : folders_of(given)) {
    std::vector<fs::path> here;
    for (const auto& entry : fs::directory_iterator(folder)) {
      const auto permissions = entry.status().permissions();
      const bool runs = (permissions & fs::perms::owner_exec) != fs::perms::none;
      if (entry.is_regular_file() && runs && entry.path().filename().string().starts_with(prefix))
        here.push_back(fs::absolute(entry.path()));
    }
    std::sort(here.begin(), here.end());
    programs.insert(programs.end(), here.begin(), here.end());
  }
  return programs;
}

struct Registry {
  std::vector<WorkerEngine> engines;
  std::vector<BrokenWorker> broken;
};

std::string full_name(const WorkerEngine& engine) {
  return engine.name() + ":" + engine.solver();
}

void add_found(const fs::path& program, Registry& registry) {
  try {
    std::vector<WorkerEngine> list = engines_of(program);
    for (const WorkerEngine& engine : list) {
      const auto other =
          std::find_if(registry.engines.begin(), registry.engines.end(),
                       [&](const WorkerEngine& one) { return full_name(one) == full_name(engine); });
      if (other != registry.engines.end())
        throw std::runtime_error(fmt::format("{}: another program has this engine, {}", full_name(engine),
                                             other->program().string()));
    }
    for (WorkerEngine& engine : list) registry.engines.push_back(std::move(engine));
  } catch (const std::exception& error) {
    registry.broken.push_back({program.string(), error.what()});
  }
}

Registry ask_workers() {
  Registry registry;
  for (const Known& one : known) {
    if (!one.built) continue;
    for (WorkerEngine& engine : engines_of(find_worker(prefix + std::string(one.engine))))
      registry.engines.push_back(std::move(engine));
  }
  for (const fs::path& program : found_workers()) add_found(program, registry);
  return registry;
}

const Registry& registry() {
  static const Registry made = ask_workers();
  return made;
}

std::string joined(const std::vector<std::string>& names) {
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

/// Engines of a program that is named by its path; asked once, and kept where they are.
const std::deque<WorkerEngine>& engines_at(const fs::path& program) {
  static std::map<fs::path, std::deque<WorkerEngine>> asked;
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  const auto found = asked.find(program);
  if (found != asked.end()) return found->second;
  std::vector<WorkerEngine> list = engines_of(program);
  return asked[program] = {list.begin(), list.end()};
}

}  // namespace

void require_folders(const std::string& name, const std::string& given) {
  for (const std::string& folder : folders_of(given)) {
    std::error_code error;
    const fs::directory_iterator entries(folder, error);
    if (error)
      throw InputError(fmt::format("{} = {}: must be folders that can be read, with ':' between them; {}: {}",
                                   name, given, folder, error.message()));
  }
}

const std::vector<WorkerEngine>& engines() {
  return registry().engines;
}

const std::vector<BrokenWorker>& broken_workers() {
  return registry().broken;
}

std::vector<std::string> engines_left_out() {
  std::vector<std::string> names;
  for (const Known& one : known) {
    const bool there = std::any_of(engines().begin(), engines().end(),
                                   [&](const WorkerEngine& engine) { return engine.name() == one.engine; });
    if (!there) names.emplace_back(one.engine);
  }
  return names;
}

bool is_usual(const WorkerEngine& engine) {
  return engine.name() == "bullet" || engine.name() == "ode" || engine.name() == "bullet-single";
}

std::vector<const WorkerEngine*> all_engines_at(const fs::path& program) {
  try {
    std::vector<const WorkerEngine*> list;
    for (const WorkerEngine& engine : engines_at(fs::absolute(program))) list.push_back(&engine);
    return list;
  } catch (const std::exception& error) {
    throw InputError(
        fmt::format("worker = {}: must be a worker program; {}", program.string(), error.what()));
  }
}

const WorkerEngine& find_engine_at(const fs::path& program, const std::string& name) {
  std::vector<std::string> there;
  for (const WorkerEngine* engine : all_engines_at(program)) {
    if (name.empty() || name == engine->name() || name == full_name(*engine) || name == engine->solver())
      return *engine;
    there.push_back(full_name(*engine));
  }
  throw InputError(fmt::format("{}: name = {}: must be one of: {}", program.string(), name, joined(there)));
}

std::vector<const WorkerEngine*> chosen_engines(const std::string& name) {
  if (name.find('/') == std::string::npos) return {&find_engine(name)};
  std::error_code ignored;
  const std::size_t colon = name.find(':', name.rfind('/'));
  if (colon == std::string::npos || fs::exists(name, ignored)) return all_engines_at(name);
  return {&find_engine_at(name.substr(0, colon), name.substr(colon + 1))};
}

const WorkerEngine& find_engine(const std::string& name) {
  if (name.find('/') != std::string::npos) return *chosen_engines(name).front();
  std::error_code ignored;
  const std::string file = name.substr(0, name.find(':'));
  const std::string hint =
      fs::is_regular_file(file, ignored) ? fmt::format("; for the file in this folder write ./{}", name) : "";
  std::vector<std::string> there;
  there.reserve(engines().size());
  for (const WorkerEngine& engine : engines()) {
    if (name == engine.name() || name == full_name(engine)) return engine;
    there.push_back(full_name(engine));
  }
  for (const BrokenWorker& broken : broken_workers())
    there.push_back(fmt::format("({}: no worker: {})", broken.program, broken.reason));
  throw InputError(fmt::format("engine = {}: must be one of: {}; left out of this build: {}{}", name,
                               joined(there), joined(engines_left_out()), hint));
}

}  // namespace rockstack
