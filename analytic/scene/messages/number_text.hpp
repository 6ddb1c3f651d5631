#pragma once

#include <array>
#include <charconv>
#include <string>

namespace rockstack {

/// The shortest decimal text that reads back to the same double; "inf", "-inf" or "nan" where it is not
/// finite.
inline std::string number_text(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

/// With so many significant digits.
inline std::string number_text(double value, int digits) {
  std::array<char, 32> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits)
          .ptr;
  return {buffer.data(), end};
}

}  // namespace rockstack
