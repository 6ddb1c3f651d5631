#include "comparisons/measures/results/environment.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <fstream>

#include "comparisons/measures/results/build.hpp"

namespace rockstack {
namespace {

/// The processor's own name, as Linux gives it.
std::string processor() {
  std::ifstream stream("/proc/cpuinfo");
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

}  // namespace

std::map<std::string, std::string> environment(const std::vector<const WorkerEngine*>& engines) {
  std::map<std::string, std::string> facts{
      {"rockstack", build::version},
      {"compiler", build::compiler},
      {"flags", build::flags},
      {"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"processor", processor()},
  };
  for (const WorkerEngine* engine : engines) facts[engine->name] = engine->version;
  return facts;
}

}  // namespace rockstack
