#include "engines/worker/registry.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <mutex>
#include <sstream>
#include <system_error>

#include "engines/worker/installation.hpp"

namespace rockstack {
namespace {

namespace fs = std::filesystem;

constexpr const char* prefix = "rockstack-";

/// Words with ':' between them.
std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, ':');)
    if (!word.empty()) words.push_back(word);
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
      const bool runs = (entry.status().permissions() & fs::perms::owner_exec) != fs::perms::none;
      if (entry.is_regular_file() && runs && entry.path().filename().string().starts_with(prefix))
        here.push_back(fs::absolute(entry.path()));
    }
    std::ranges::sort(here);
    programs.insert(programs.end(), here.begin(), here.end());
  }
  return programs;
}

/// Engines of a program that is named by its path; asked once, and kept where they are.
const std::vector<WorkerEngine>& engines_at(const fs::path& program) {
  static std::map<fs::path, std::vector<WorkerEngine>> asked;
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  const auto found = asked.find(program);
  return found != asked.end() ? found->second : asked[program] = engines_of(program);
}

/// Those that this program was built with, by the names of their workers.
const std::vector<std::string>& built() {
  static const std::vector<std::string> names = split(ROCKSTACK_BUILT_ENGINES);
  return names;
}

const std::vector<WorkerEngine>& built_engines(const std::string& name) {
  const fs::path file = worker_folder() / (prefix + name);
  std::error_code ignored;
  if (!fs::exists(file, ignored))
    throw std::runtime_error(fmt::format("{}: must be there, it came with this program", file.string()));
  return engines_at(file);
}

bool is_built(const std::string& name) {
  return std::ranges::find(built(), name) != built().end();
}

/// What programs give, and those that give nothing.
struct Found {
  EngineList engines;
  std::vector<BrokenWorker> broken;
};

/// The program that gives an engine already, or none.
std::optional<fs::path> program_of(const WorkerEngine& engine, const EngineList& found) {
  const auto same = [&](const WorkerEngine& one) { return one.full_name() == engine.full_name(); };
  if (const auto other = std::ranges::find_if(found, same); other != found.end()) return other->get().program;
  if (!is_built(engine.name)) return {};
  const auto& list = built_engines(engine.name);
  const auto other = std::ranges::find_if(list, same);
  return other == list.end() ? std::nullopt : std::optional<fs::path>(other->program);
}

void add_found(const fs::path& program, Found& found) {
  for (const WorkerEngine& engine : engines_at(program))
    if (const auto other = program_of(engine, found.engines))
      throw std::runtime_error(
          fmt::format("{}: another program has this engine, {}", engine.full_name(), other->string()));
  std::ranges::copy(engines_at(program), std::back_inserter(found.engines));
}

/// Does it, or has the program among the broken ones with the reason why not.
template <typename Add>
void try_to_add(const std::string& program, Found& found, const Add& add) {
  try {
    add();
  } catch (const std::exception& error) {
    found.broken.push_back({program, error.what()});
  }
}

const Found& found() {
  static const Found made = [] {
    Found all;
    for (const fs::path& program : found_workers())
      try_to_add(program.string(), all, [&] { add_found(program, all); });
    return all;
  }();
  return made;
}

/// What this program was built with, and then what is found.
const Found& all_workers() {
  static const Found made = [] {
    Found all;
    for (const std::string& name : built())
      try_to_add(prefix + name, all,
                 [&] { std::ranges::copy(built_engines(name), std::back_inserter(all.engines)); });
    std::ranges::copy(found().engines, std::back_inserter(all.engines));
    std::ranges::copy(found().broken, std::back_inserter(all.broken));
    return all;
  }();
  return made;
}

std::string joined(const std::vector<std::string>& names) {
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

/// All engines of a program. @throws InputError where it is no worker, with the reason.
std::vector<const WorkerEngine*> all_engines_at(const fs::path& program) {
  try {
    return mapped(engines_at(fs::absolute(program)), [](const WorkerEngine& engine) { return &engine; });
  } catch (const std::exception& error) {
    throw InputError(
        fmt::format("worker = {}: must be a worker program; {}", program.string(), error.what()));
  }
}

constexpr const char* usual_names[] = {"bullet", "ode", "bullet-single"};

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

const EngineList& engines() {
  return all_workers().engines;
}

EngineList engines_called(const std::string& name) {
  EngineList list;
  if (is_built(name)) list.assign(built_engines(name).begin(), built_engines(name).end());
  std::ranges::copy_if(found().engines, std::back_inserter(list),
                       [&](const WorkerEngine& engine) { return engine.name == name; });
  return list;
}

EngineList usual_engines() {
  EngineList list;
  for (const char* name : usual_names) std::ranges::copy(engines_called(name), std::back_inserter(list));
  return list;
}

const std::vector<BrokenWorker>& broken_workers() {
  return all_workers().broken;
}

std::vector<std::string> engines_left_out() {
  std::vector<std::string> names = split(ROCKSTACK_KNOWN_ENGINES);
  std::erase_if(names,
                [](const std::string& name) { return is_built(name) || !engines_called(name).empty(); });
  return names;
}

std::vector<std::string> usual_engines_left_out() {
  std::vector<std::string> names = engines_left_out();
  std::erase_if(names, [](const std::string& name) {
    return std::ranges::find(usual_names, name) == std::ranges::end(usual_names);
  });
  return names;
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
  for (const WorkerEngine& engine : engines_called(file))
    if (name == engine.name || name == engine.full_name()) return engine;
  std::vector<std::string> there = mapped(engines(), &WorkerEngine::full_name);
  std::vector<std::string> words = there;
  for (const WorkerEngine& engine : engines()) words.push_back(engine.name);
  for (const BrokenWorker& broken : broken_workers())
    there.push_back(fmt::format("({}: no worker: {})", broken.program, broken.reason));
  throw InputError(fmt::format("engine = {}: must be one of: {}; left out of this build: {}{}{}", name,
                               joined(there), joined(engines_left_out()), hint, did_you_mean(name, words)));
}

}  // namespace rockstack
