#pragma once

#include <string>
#include <string_view>

#include "comparisons/measures/results/sentences.hpp"

namespace rockstack::plots {

/// Text for use inside an element or a quoted attribute.
std::string escaped(std::string_view text);

/// <name>content</name>, the content as it is. `attributes` starts with a space where there are any.
std::string element(const std::string& name, const std::string& content, const std::string& attributes = "");

using rockstack::filled_in;

/// The part of an SVG file that stands inside a page: without its preamble, every id begun with `prefix`,
/// with `label` as its text for those who do not see it.
std::string inline_svg(const std::string& file, const std::string& prefix, const std::string& label);

}  // namespace rockstack::plots
