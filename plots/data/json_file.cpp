#include "plots/data/json_file.hpp"

#include <fmt/core.h>

#include "analytic/scene/input/document.hpp"

namespace rockstack::plots {
namespace {

std::string text_of(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

void flatten(const Json& object, const std::string& prefix, Facts& facts) {
  for (const auto& [key, value] : object.items()) {
    if (value.is_object()) {
      flatten(value, prefix + key + ".", facts);
    } else {
      facts.emplace_back(prefix + key, text_of(value));
    }
  }
}

}  // namespace

std::string file_name(const std::string& text, const std::string& place) {
  if (text.empty() || text == "." || text == ".." || text.find('/') != std::string::npos)
    throw InputError(fmt::format("{} = \"{}\": must be a name without a slash", place, one_line(text)));
  return text;
}

Facts facts_of(const Json& object) {
  Facts facts;
  flatten(object, "", facts);
  return facts;
}

}  // namespace rockstack::plots
