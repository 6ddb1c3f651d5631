#pragma once

#include <string>
#include <vector>

#include "analytic/scene/messages/number_text.hpp"

namespace rockstack {

/// Whether steps below 10 µs and above 0.5 s and peaks above 10 g are refused, which come as a rule of a unit
/// read wrongly.
enum class RecordLimits { usual, none };

/// An accelerogram as read from a file, in SI units.
struct Record {
  double interval = 0;          ///< s, > 0
  std::vector<double> samples;  ///< m/s², at least one
  std::string format;           ///< what the file was recognised as, e.g. "PEER AT2"
  std::string unit = {};        ///< what a 1 in the file is: "0.01 m/s²"
  std::string step = {};        ///< where the interval was found: "line 3", "column 1, \"Time (s)\""
  std::string taken = {};       ///< where there were others: "column 3 of 4, \"Acceleration (g)\""
};

/// "text columns, column 3 of 4, \"Acceleration (g)\", in 9.80665 m/s², steps of 0.01 s by line 3": what the
/// file is, what was taken of it, and how its numbers were understood.
inline std::string description(const Record& record) {
  constexpr int digits = 6;
  return record.format + (record.taken.empty() ? "" : ", " + record.taken) + ", in " + record.unit +
         ", steps of " + number_text(record.interval, digits) + " s by " + record.step;
}

}  // namespace rockstack
