#pragma once

#include <string>
#include <vector>

namespace rockstack {

/// An accelerogram as read from a file, in SI units.
struct Record {
  double interval = 0;          ///< s, > 0
  std::vector<double> samples;  ///< m/s², at least one
  std::string format;           ///< what the file was recognised as, e.g. "PEER AT2"
};

}  // namespace rockstack
