#pragma once

#include <map>
#include <string>
#include <string_view>

namespace rockstack::plots {

/// Text for use inside an element or a quoted attribute.
std::string escaped(std::string_view text);

/// <name>content</name>, the content as it is. `attributes` starts with a space where there are any.
std::string element(const std::string& name, const std::string& content, const std::string& attributes = "");

/// Puts each value in the place of its {{name}}. @throws std::logic_error for a place without a value.
std::string filled_in(std::string_view page, const std::map<std::string, std::string>& values);

/// The part of an SVG file that stands inside a page: without its preamble, every id begun with `prefix`,
/// with `label` as its text for those who do not see it.
std::string inline_svg(const std::string& file, const std::string& prefix, const std::string& label);

}  // namespace rockstack::plots
