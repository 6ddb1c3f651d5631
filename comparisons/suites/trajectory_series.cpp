#include <fmt/format.h>

#include "comparisons/measures/results/csv.hpp"
#include "comparisons/suites/suite.hpp"

namespace rockstack {
namespace {

constexpr const char* name_range = "letters, digits, - and _";

bool is_name(const std::string& text) {
  return !text.empty() && std::ranges::all_of(text, [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '-' || letter == '_';
  });
}

/// Names of rows that are there already.
bool is_taken(const std::string& name) {
  return name == "exact" || !engines_called(name).empty();
}

std::string recorded_in(const std::vector<TrajectoryFile>& runs) {
  const std::string first = runs.front().file.filename().string();
  return runs.size() == 1 ? "in " + first : fmt::format("in {} and {} more", first, runs.size() - 1);
}

}  // namespace

std::vector<NamedTrajectory> named_trajectories(const std::vector<std::string>& texts) {
  std::vector<NamedTrajectory> list;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals >= text.size() - 1)
      throw InputError(fmt::format("--trajectory {}: must be of the form NAME=FILE.csv", one_line(text)));
    const std::string name = text.substr(0, equals);
    const auto same = [&](const NamedTrajectory& one) { return one.name == name; };
    found_or_added(list, same, {name, {}}).files.emplace_back(text.substr(equals + 1));
  }
  return list;
}

EngineSeries trajectory_series(const NamedTrajectory& named, const NamedScene& scene,
                               const std::string& place) {
  if (!is_name(named.name) || is_taken(named.name))
    throw InputError(
        fmt::format("{}: name {}: must be of {}, and no engine's", place, one_line(named.name), name_range));
  auto files = std::make_shared<TrajectoryFiles>();
  files->scene = scene.name;
  for (const std::filesystem::path& file : named.files)
    files->runs.push_back(read_trajectory(file, scene.scene));
  files->program.name = named.name;
  files->program.solver = "trajectory";
  files->program.version = recorded_in(files->runs);
  const WorkerEngine* program = &files->program;
  const double dt = files->runs.front().dt;
  return {program, "recorded", {}, {dt}, std::move(files)};
}

}  // namespace rockstack
