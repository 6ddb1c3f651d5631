#pragma once

#include <stdexcept>
#include <string>

namespace rockstack {

/// Something the user gave is wrong. The text is one line that names the place (file:line, or the option),
/// the key, the value and what is allowed.
class InputError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

}  // namespace rockstack
