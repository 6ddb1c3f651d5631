#pragma once

#include <filesystem>

#include "analytic/scene/input/document.hpp"

namespace rockstack {

/// The folder of the "scenes", "suites", "ensembles", "studies/lessons" or "canon/proved" tables that come
/// with this program.
std::filesystem::path shipped(const std::string& kind);

/// The names of those, in order; tables end in ".csv".
std::vector<std::string> shipped_names(const std::string& kind, const std::string& ending = ".toml");

/// The file that an input names: that very file, or one of a kind that comes with the program, or of a folder
/// of that kind, by its name without ending. Where neither is there, the input as a file, for whoever reads
/// it to refuse. Files are looked for from `folder`.
std::filesystem::path find_file(const std::string& input, const std::string& kind,
                                const std::filesystem::path& folder = {});

/// Finds the input's file among the first of some kinds that has it. @throws InputError where nothing is
/// there, with the nearest name.
std::filesystem::path input_file(const std::string& input, const std::vector<std::string>& asked);

/// Finds an input that a file names. @throws InputError with file:line and key where neither is there.
std::filesystem::path named_file(const Node& node, const std::string& kind,
                                 const std::filesystem::path& folder);

}  // namespace rockstack
