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

/// The two ranges that a scene's numbers have. @throws FieldError.
void require_positive(const std::string& key, double value);
void require_finite(const std::string& key, double value);

}  // namespace rockstack
