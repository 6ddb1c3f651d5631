#pragma once

#include <string>

namespace rockstack {

/// A number of a scene, and where it is looked for.
struct VariedKey {
  std::string key;  ///< of the scene, such as "restitution.1" or "blocks.1.width"
  double low = 0, high = 0;
};

/// "KEY=LOW:HIGH", which an option has. @throws InputError where a text is not of that form, or LOW < HIGH
/// does not hold.
VariedKey varied_key(const std::string& option, const std::string& text);

}  // namespace rockstack
