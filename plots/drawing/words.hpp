#pragma once

#include <string>
#include <vector>

namespace rockstack::plots {

/// Words in lines of so many letters at most, broken after a comma, blank or hyphen, or before a plus; inside
/// a word where it has none of them.
std::vector<std::string> lines_of(const std::string& words, std::size_t most);

/// The size of long words, smaller than usual to stay inside a figure; `fitting` letters of the usual size
/// do.
int words_size(const std::string& words, std::size_t usual, std::size_t fitting);

/// Where words may be broken next: behind a comma, or before a further parameter, "…+name=value".
std::size_t next_break(const std::string& words, std::size_t from);

/// gnuplot's commands with no letters smaller than that size, in points of a screen.
std::string legible(const std::string& commands, double least);

}  // namespace rockstack::plots
