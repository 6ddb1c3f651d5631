#pragma once

#include <string>
#include <string_view>

namespace rockstack::records {

/// Text of a file in UTF-8 with lines that end in "\n" or "\r\n": read from UTF-8, UTF-16 with its mark, or
/// Latin-1, without byte-order mark and without what fills the last block of files from DOS.
/// @throws InputError where it is empty or no text, as recorders' binary formats are.
std::string plain_text(std::string_view file, std::string_view bytes);

/// @throws InputError where the last line has no end and its last number may be cut short: where numbers are
/// not lined up by their ends, and do not have as many decimals on each line.
void check_last_line(std::string_view file, std::string_view text);

}  // namespace rockstack::records
