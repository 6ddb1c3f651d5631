#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace rockstack {

/// A commented input file of a kind, "scene", "suite" or "ensemble", made of the keys that its reader takes:
/// it is accepted as it stands, and what may be left out is there as comments. A scene with `record` has that
/// record, as a path from `folder`, for its ground motion.
/// @throws InputError where the record cannot be read.
std::string template_text(const std::string& kind, const std::optional<std::filesystem::path>& record,
                          const std::filesystem::path& folder);

}  // namespace rockstack
