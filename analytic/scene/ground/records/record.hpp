#pragma once

#include <string>
#include <vector>

namespace rockstack {

/// Whether steps below 10 µs and above 0.5 s and peaks above 10 g are refused, which come as a rule of a unit
/// read wrongly.
enum class RecordLimits { usual, none };

/// An accelerogram as read from a file, in SI units.
struct Record {
  double interval = 0;          ///< s, > 0
  std::vector<double> samples;  ///< m/s², at least one
  std::string format;           ///< what the file was recognised as, e.g. "PEER AT2"
  std::string taken = {};       ///< where there were others: "column 3 of 4, \"Acceleration (g)\""
};

/// "text columns, column 3 of 4, \"Acceleration (g)\"": what the file is, and what was taken of it.
inline std::string description(const Record& record) {
  return record.taken.empty() ? record.format : record.format + ", " + record.taken;
}

}  // namespace rockstack
