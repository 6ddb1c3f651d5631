#include "engines/worker/installation.hpp"

#include <algorithm>

namespace rockstack {

std::filesystem::path own_folder() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path();
}

bool in_build_tree() {
  const std::filesystem::path tree = ROCKSTACK_BUILD_TREE;
  const std::filesystem::path own = own_folder();
  return std::mismatch(tree.begin(), tree.end(), own.begin(), own.end()).first == tree.end();
}

std::filesystem::path worker_folder() {
  return in_build_tree() ? std::filesystem::path(ROCKSTACK_BUILD_TREE) : own_folder();
}

}  // namespace rockstack
