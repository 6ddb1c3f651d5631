#include "comparisons/interfaces/program/commands.hpp"

namespace rockstack {

std::unique_ptr<Executor> make_executor(std::size_t threads) {
#ifdef ROCKSTACK_WITH_MPI
  if (auto ranks = find_ranks()) return ranks;
#endif
  return make_threads(threads);
}

}  // namespace rockstack
