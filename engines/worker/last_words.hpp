#pragma once

#include <string>
#include <string_view>

namespace rockstack {

/// Standard error of a program, of which one line is kept whatever its length.
class LastWords {
 public:
  /// Takes the bytes that come next.
  void hear(std::string_view bytes);

  /// The line that tells most of why a program failed: the last of the form "Error: …", as all runtimes have
  /// it, below which some list calls or name themselves; without one, the last line.
  std::string telling_line() const;

 private:
  std::string line_;  ///< that has no end yet, up to a stated length
  std::string last_, error_;
};

}  // namespace rockstack
