#include "comparisons/measures/results/sentences.hpp"

#include <fmt/core.h>

#include <sstream>
#include <stdexcept>

#include "analytic/scene/input/scene_keys.hpp"

namespace rockstack {
namespace {

/// Unit of a scene's key, as ground.vertical.period or blocks.2.width; empty where it has none.
std::string unit_of(const std::string& key) {
  std::string header = "[", name;
  std::istringstream parts(key);
  for (std::string part; std::getline(parts, part, '.');) {
    if (part.find_first_not_of("0123456789") == std::string::npos) continue;
    if (!name.empty()) header += (header.size() > 1 ? "." : "") + name;
    name = part == "vertical" ? "horizontal" : part;  // whose tables stand for both
  }
  header += "]";
  for (const KeyTable* table : scene_tables) {
    const std::string own = table->header;
    if (own != header && own != "[" + header + "]" && !(own.empty() && header == "[]")) continue;
    for (const InputKey& one : table->keys)
      if (one.name == name) return one.unit;
  }
  return "";
}

}  // namespace

std::string counted(std::size_t count, const std::string& one) {
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return text;
}

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string joined_up_to(std::size_t most, const std::vector<std::string>& words) {
  if (words.size() <= most + 1) return joined(words);
  std::vector<std::string> some(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(most));
  some.push_back(fmt::format("{} others", words.size() - most));
  return joined(some);
}

std::vector<Paragraph> paragraphs(std::string_view text) {
  std::vector<Paragraph> list;
  std::istringstream lines{std::string(text)};
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    if (inside && !line.empty()) {
      std::string& words = list.back().words;
      words += (words.empty() ? "" : " ") + line;
    } else if (!line.empty()) {
      const std::size_t colon = std::min(line.find(": "), line.size());
      list.push_back({line.substr(0, colon), line.substr(std::min(colon + 2, line.size())), ""});
    }
    inside = !line.empty();
  }
  return list;
}

std::string filled_in(std::string_view text, const std::map<std::string, std::string>& values) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = text.find("{{", at);
    result += text.substr(at, open - at);
    if (open == std::string_view::npos) break;
    const std::size_t close = text.find("}}", open);
    const std::string name(text.substr(open + 2, close - open - 2));
    const auto value = values.find(name);
    if (close == std::string_view::npos || value == values.end())
      throw std::logic_error("text with places: no value for {{" + name + "}}");
    result += value->second;
    at = close + 2;
  }
  return result;
}

std::string axis_title(const std::string& key) {
  for (const auto& [end, title] : {std::pair{".peak", "peak ground acceleration (m/s²)"},
                                   {".amplitude", "amplitude of the pulse (m/s²)"},
                                   {".scale", "scale of the record"}})
    if (key.ends_with(end)) return title;
  const std::string unit = unit_of(key);
  return unit.empty() ? key : fmt::format("{} ({})", key, unit);
}

std::string value_on(const std::string& axis, const std::string& value) {
  const std::size_t unit = axis.find(" (");
  if (unit == std::string::npos) return axis + " = " + value;
  const bool vowel = std::string("aeiou").find(axis.front()) != std::string::npos;
  return fmt::format("{} {} of {} {}", vowel ? "an" : "a", axis.substr(0, unit), value,
                     axis.substr(unit + 2, axis.size() - unit - 3));
}

std::string value_on(const std::string& axis, double value) {
  return value_on(axis, fmt::format("{:.3g}", value));
}

}  // namespace rockstack
