#include "plots/pages/html.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace rockstack::plots {
namespace {

/// Writes `prefix` behind every occurrence of `mark`.
void insert_after(std::string& text, std::string_view mark, const std::string& prefix) {
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at)) {
    at += mark.size();
    text.insert(at, prefix);
  }
}

/// Takes out the first element of that name, which a browser would show as a tooltip.
void remove_element(std::string& text, const std::string& name) {
  const std::string closing = "</" + name + ">";
  const std::size_t begin = text.find("<" + name + ">");
  const std::size_t end = text.find(closing, std::min(begin, text.size()));
  if (end != std::string::npos) text.erase(begin, end + closing.size() - begin);
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '&':
        result += "&amp;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string element(const std::string& name, const std::string& content, const std::string& attributes) {
  return fmt::format("<{0}{1}>{2}</{0}>", name, attributes, content);
}

std::string inline_svg(const std::string& file, const std::string& prefix, const std::string& label) {
  const std::size_t start = std::min(file.find("<svg"), file.size());
  std::string svg = file.substr(start);
  remove_element(svg, "title");
  remove_element(svg, "desc");
  for (const std::string_view mark : {"id=\"", "id='", "href='#", "href=\"#", "url(#"})
    insert_after(svg, mark, prefix);
  constexpr std::size_t tag_length = 4;
  if (svg.size() > tag_length)
    svg.insert(tag_length, fmt::format(" role=\"img\" aria-label=\"{}\"", escaped(label)));
  return svg;
}

}  // namespace rockstack::plots
