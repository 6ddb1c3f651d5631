#include "comparisons/measures/results/filled_in.hpp"

#include <stdexcept>

namespace rockstack {

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

}  // namespace rockstack
