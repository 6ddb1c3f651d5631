#pragma once

#include <filesystem>

namespace rockstack {

/// The folder of this program's file.
std::filesystem::path own_folder();

/// True for a program where it was built, which takes its parts from the trees that it was built in and from.
/// Any other takes what was installed with it, wherever that has been moved.
bool in_build_tree();

/// Where worker programs are: where the build puts them, or beside this program.
std::filesystem::path worker_folder();

}  // namespace rockstack
