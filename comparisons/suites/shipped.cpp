#include "comparisons/suites/shipped.hpp"

#include <algorithm>
#include <system_error>

#include "comparisons/measures/results/build.hpp"
#include "engines/worker/installation.hpp"

namespace rockstack {

std::filesystem::path shipped(const std::string& kind) {
  return (in_build_tree() ? std::filesystem::path(build::tree) : own_folder() / build::installed) / kind;
}

std::vector<std::string> shipped_names(const std::string& kind) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(shipped(kind))) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

namespace {

/// A file of a kind, or of a folder in it, such as scenes/canon.
std::filesystem::path shipped_file(const std::string& kind, const std::string& name) {
  std::error_code ignored;  // a link may lead in a circle
  std::filesystem::path file = shipped(kind) / name;
  if (std::filesystem::exists(file, ignored)) return file;
  for (const auto& entry : std::filesystem::directory_iterator(shipped(kind), ignored))
    if (std::filesystem::exists(entry.path() / name, ignored)) return entry.path() / name;
  return file;
}

}  // namespace

std::filesystem::path find_file(const std::string& input, const std::string& kind,
                                const std::filesystem::path& folder) {
  std::error_code ignored;  // a link may lead in a circle
  const auto own = shipped_file(kind, input + ".toml"), given = folder / input;
  return !std::filesystem::is_regular_file(given, ignored) && std::filesystem::exists(own, ignored) ? own
                                                                                                    : given;
}

}  // namespace rockstack
