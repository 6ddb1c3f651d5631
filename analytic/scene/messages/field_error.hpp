#pragma once

#include <stdexcept>
#include <string>

namespace rockstack {

/// A field of a scene is out of range. `key` is the scene file's name for it, e.g. "blocks.1.height".
class FieldError : public std::invalid_argument {
 public:
  FieldError(std::string field, const std::string& value, const std::string& allowed);
  std::string key;
};

/// The largest of a scene's numbers, in SI units, and one over the least that must be positive: far beyond
/// what blocks are like, and such that products of several stay in the range of a double.
inline constexpr double largest_number = 1e20;

/// The ranges that a scene's numbers have: up to largest_number, from `least`, from 1/largest_number, or from
/// −largest_number. @throws FieldError.
void require_between(const std::string& key, double value, double least);
void require_positive(const std::string& key, double value);
void require_signed(const std::string& key, double value);

}  // namespace rockstack
