#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace rockstack {

/// What the user gave is wrong. The text is one line: file:line or option, key, value and what is allowed.
class InputError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// A field of a scene is out of range. `key` is the scene file's name for it, e.g. "blocks.1.height".
class FieldError : public std::invalid_argument {
 public:
  FieldError(std::string field, const std::string& value, const std::string& allowed);
  FieldError(std::string field, double value, const std::string& allowed);
  std::string key;
};

/// The largest of a scene's numbers, in SI units, and one over the least that must be positive: far beyond
/// what blocks are like, and such that products of several stay in the range of a double.
inline constexpr double largest_number = 1e20;

/// The ranges that a scene's numbers have: from `least` to `most`, or from 1/largest_number.
/// @throws FieldError.
void require_between(const std::string& key, double value, double least, double most = largest_number);

inline void require_positive(const std::string& key, double value) {
  require_between(key, value, 1 / largest_number);
}

/// The key of an array's entry k from 0; files count from 1.
inline std::string entry_key(const std::string& array, std::size_t k) {
  return array + "." + std::to_string(k + 1);
}

/// Applies require_between() to each entry of an array.
void require_each_between(const std::string& array, const std::vector<double>& values, double least,
                          double most = largest_number);

/// "; did you mean NAME?" for the name nearest to a word, by letters put in, left out, replaced or changed
/// with their neighbours (Damerau's distance), where these are at most a third of its letters; else empty.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& names);

}  // namespace rockstack
