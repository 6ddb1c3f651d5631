#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace rockstack {

/// Text as one line that any terminal, table or page may show: what controls a terminal, breaks a line or
/// turns the direction of reading, and bytes that are no UTF-8, are escaped as "\x1b". Of more than `most`
/// letters, an escape being four, only the first are kept, with "…" in place of the last.
std::string one_line(std::string_view text, std::size_t most = std::numeric_limits<std::size_t>::max());

/// A text without those of `blanks` that it begins and ends with.
std::string_view trimmed(std::string_view text, std::string_view blanks);

/// The two of a byte, as in "1b".
std::string hex_digits(char byte);

}  // namespace rockstack
