#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rockstack {

/// An accelerogram as read from a file, in SI units.
struct Record {
  double interval = 0;          ///< s, > 0
  std::vector<double> samples;  ///< m/s², at least one
  std::string format;           ///< what the file was recognised as, e.g. "PEER AT2"
};

/// Reads a ground-motion record; the format is recognised by content, units come from the file.
/// @throws InputError with file and line: missing, empty, binary, truncated, wrong count, unknown format or units.
Record read_record(const std::filesystem::path& file);

}  // namespace rockstack
