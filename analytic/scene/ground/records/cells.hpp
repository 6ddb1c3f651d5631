#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analytic/scene/ground/records/table.hpp"

namespace rockstack::records {

using Texts = std::vector<std::string>;

/// A percent sign begins a comment, and the unit %g.
bool is_comment(std::string_view line);

/// The pieces of a line between separators outside quotes, without those.
Texts cut_at(std::string_view line, char separator);

/// Where titles are parted by two blanks or more.
Texts cut_at_gaps(std::string_view line);

/// A line without the sign of a comment in front.
std::string_view uncommented(std::string_view line);

/// The cells of a line of text by each sign that may part them: separators, gaps, brackets.
std::vector<Texts> parted(std::string_view line, const Dialect& dialect);

/// The cells of a line of text that are as many as there are columns, by whatever they are parted.
std::optional<Texts> cells_of(std::string_view line, std::size_t columns, const Dialect& dialect);

}  // namespace rockstack::records
