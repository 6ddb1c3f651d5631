#include "engines/worker/installation.hpp"

#include <dlfcn.h>
#include <link.h>

#include <algorithm>

namespace rockstack {
namespace {

namespace fs = std::filesystem;

/// The module that this code is in; empty where that is the program itself.
const fs::path& own_module() {
  static const fs::path module = [] {
    Dl_info info{};
    link_map* map = nullptr;
    const bool found = dladdr1(reinterpret_cast<const void*>(&own_file), &info,
                               reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP) != 0;
    const std::string file = found && map != nullptr ? map->l_name : "";
    return file.empty() ? fs::path() : fs::canonical(file);
  }();
  return module;
}

/// Where the link by which a program finds itself leads, even if nothing is there any more.
fs::path resolved() {
  return own_module().empty() ? fs::read_symlink(own_file()) : own_module();
}

}  // namespace

fs::path own_file() {
  return own_module().empty() ? "/proc/self/exe" : own_module();
}

fs::path own_folder() {
  fs::path folder = resolved().parent_path();
  if (own_module().empty()) return folder;
  for (fs::path prefix = folder; prefix.has_relative_path(); prefix = prefix.parent_path())
    if (fs::exists(prefix / ROCKSTACK_BINDIR / "rockstack")) return prefix / ROCKSTACK_BINDIR;
  return folder;
}

bool in_build_tree() {
  const fs::path tree = ROCKSTACK_BUILD_TREE;
  const fs::path own = resolved();
  return std::mismatch(tree.begin(), tree.end(), own.begin(), own.end()).first == tree.end();
}

fs::path worker_folder() {
  return in_build_tree() ? fs::path(ROCKSTACK_BUILD_TREE) : own_folder();
}

}  // namespace rockstack
