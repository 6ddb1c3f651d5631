#include "comparisons/suites/shipped.hpp"

#include <system_error>

#include "comparisons/results/build.hpp"
#include "engines/worker/installation.hpp"

namespace rockstack {

std::filesystem::path shipped(const std::string& kind) {
  return (in_build_tree() ? std::filesystem::path(build::tree) : own_folder() / build::installed) / kind;
}

std::filesystem::path find_file(const std::string& input, const std::string& kind) {
  std::error_code ignored;  // a link may lead in a circle
  const auto own = shipped(kind) / (input + ".toml");
  return !std::filesystem::is_regular_file(input, ignored) && std::filesystem::exists(own, ignored)
             ? own
             : std::filesystem::path(input);
}

}  // namespace rockstack
