#include <fmt/format.h>
#include <unistd.h>

#include "comparisons/interfaces/program/live.hpp"
#include "engines/worker/installation.hpp"

namespace rockstack {

int serve_live(const LiveArguments&, const Common& common) {
  const std::filesystem::path program = worker_folder() / "rockstack_live";
  execv(program.c_str(), common.words);
  throw std::runtime_error(fmt::format("{}: cannot be run", program.string()));
}

}  // namespace rockstack
