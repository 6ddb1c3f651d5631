#include "engines/worker/registry.hpp"

#include <fmt/format.h>

#include <algorithm>
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

constexpr const char* prefix = "rockstack-";

fs::path find_worker(const std::string& name) {
  fs::path file = worker_folder() / name;
  std::error_code ignored;
  if (fs::exists(file, ignored)) return file;
  throw std::runtime_error(fmt::format("{}: must be there, it came with this program", file.string()));
}

/// Words with ':' between them.
std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, ':');) {
    if (!word.empty()) words.push_back(word);
  }
  return words;
}

/// Programs in the folders of workers_variable, in order of folders and then of names.
std::vector<fs::path> found_workers() {
  std::vector<fs::path> programs;
  const char* given = std::getenv(workers_variable);
  if (given == nullptr) return {};
  require_folders(workers_variable, given);
  for (const std::string& folder : split(given)) {
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

void add_found(const fs::path& program, Registry& registry) {
  try {
    std::vector<WorkerEngine> list = engines_of(program);
    for (const WorkerEngine& engine : list) {
      const auto other =
          std::find_if(registry.engines.begin(), registry.engines.end(),
                       [&](const WorkerEngine& one) { return one.full_name() == engine.full_name(); });
      if (other != registry.engines.end())
        throw std::runtime_error(fmt::format("{}: another program has this engine, {}", engine.full_name(),
                                             other->program.string()));
    }
    for (WorkerEngine& engine : list) registry.engines.push_back(std::move(engine));
  } catch (const std::exception& error) {
    registry.broken.push_back({program.string(), error.what()});
  }
}

Registry ask_workers() {
  Registry registry;
  for (const std::string& name : split(ROCKSTACK_BUILT_ENGINES)) {
    for (WorkerEngine& engine : engines_of(find_worker(prefix + name)))
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
  for (const std::string& folder : split(given)) {
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
  for (const std::string& name : split(ROCKSTACK_KNOWN_ENGINES)) {
    const bool there = std::any_of(engines().begin(), engines().end(),
                                   [&](const WorkerEngine& engine) { return engine.name == name; });
    if (!there) names.push_back(name);
  }
  return names;
}

bool is_usual(const WorkerEngine& engine) {
  return engine.name == "bullet" || engine.name == "ode" || engine.name == "bullet-single";
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
    if (name.empty() || name == engine->name || name == engine->full_name() || name == engine->solver)
      return *engine;
    there.push_back(engine->full_name());
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
    if (name == engine.name || name == engine.full_name()) return engine;
    there.push_back(engine.full_name());
  }
  for (const BrokenWorker& broken : broken_workers())
    there.push_back(fmt::format("({}: no worker: {})", broken.program, broken.reason));
  throw InputError(fmt::format("engine = {}: must be one of: {}; left out of this build: {}{}", name,
                               joined(there), joined(engines_left_out()), hint));
}

}  // namespace rockstack
