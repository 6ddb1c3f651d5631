#pragma once

#include <filesystem>

namespace rockstack {

/// Leads to the file that this code is in: the program, or a module that another program has loaded.
std::filesystem::path own_file();

/// The folder of the programs: that of this program's file, or of a module of the nearest prefix around it.
std::filesystem::path own_folder();

/// True for a program or module where it was built, which takes its parts from the trees that it was built in
/// and from. Any other takes what was installed with it, wherever that has been moved.
bool in_build_tree();

/// Where worker programs are: where the build puts them, or in own_folder().
std::filesystem::path worker_folder();

}  // namespace rockstack
