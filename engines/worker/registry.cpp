#include "engines/worker/registry.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <system_error>
#include <utility>

#include "analytic/scene/messages/input_error.hpp"
#include "engines/worker/installation.hpp"

namespace rockstack {
namespace {

std::vector<std::string> worker_programs() {
  std::vector<std::string> names;
#ifdef ROCKSTACK_WITH_BULLET
  names.emplace_back("rockstack-bullet");
#endif
#ifdef ROCKSTACK_WITH_ODE
  names.emplace_back("rockstack-ode");
#endif
#ifdef ROCKSTACK_WITH_BULLET
  names.emplace_back("rockstack-bullet-single");
#endif
  return names;
}

std::filesystem::path find_worker(const std::string& name) {
  std::filesystem::path file = worker_folder() / name;
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored)) return file;
  throw std::runtime_error(fmt::format("{}: must be there, it came with this program", file.string()));
}

std::vector<WorkerEngine> ask_workers() {
  std::vector<WorkerEngine> list;
  for (const std::string& name : worker_programs()) {
    for (WorkerEngine& engine : engines_of(find_worker(name))) list.push_back(std::move(engine));
  }
  return list;
}

std::string joined(const std::vector<std::string>& names) {
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

const std::vector<WorkerEngine>& engines() {
  static const std::vector<WorkerEngine> list = ask_workers();
  return list;
}

std::vector<std::string> engines_left_out() {
  std::vector<std::string> names;
#ifndef ROCKSTACK_WITH_BULLET
  names.emplace_back("bullet");
  names.emplace_back("bullet-single");
#endif
#ifndef ROCKSTACK_WITH_ODE
  names.emplace_back("ode");
#endif
  return names;
}

const WorkerEngine& find_engine(const std::string& name) {
  std::vector<std::string> there;
  there.reserve(engines().size());
  for (const WorkerEngine& engine : engines()) {
    const std::string full = engine.name() + ":" + engine.solver();
    if (name == engine.name() || name == full) return engine;
    there.push_back(full);
  }
  throw InputError(fmt::format("engine = {}: must be one of: {}; left out of this build: {}", name,
                               joined(there), joined(engines_left_out())));
}

}  // namespace rockstack
