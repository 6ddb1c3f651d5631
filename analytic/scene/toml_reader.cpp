#include "analytic/scene/toml_reader.hpp"

#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

// The library's only use: compiled in whole here, so that nobody who links this library needs it.
#define TOML_HEADER_ONLY 1
// Its assertions end the process on malformed files that it reports as errors right after.
#define TOML_ASSERT(expr) static_assert(true)
#include <toml++/toml.h>

namespace rockstack {
namespace {

/// Names the place of a value that the TOML reader has seen.
struct Places {
  std::string prefix;
  bool with_line = true;

  std::string operator()(const toml::node& value) const {
    return with_line ? prefix + ":" + std::to_string(value.source().begin.line) : prefix;
  }
};

Node converted(const toml::node& value, Node target, const Places& places);

void add_children(const toml::table& table, Node& target, const Places& places) {
  target.kind = Node::Kind::table;
  for (const auto& [key, value] : table) {
    Node child = make_child(target, std::string(key.str()), places(value));
    target.children.push_back(converted(value, std::move(child), places));
  }
}

void add_children(const toml::array& array, Node& target, const Places& places) {
  target.kind = Node::Kind::array;
  target.children.reserve(array.size());
  for (const toml::node& value : array) {
    Node child = make_child(target, std::to_string(target.children.size() + 1), places(value));
    target.children.push_back(converted(value, std::move(child), places));
  }
}

Node converted(const toml::node& value, Node target, const Places& places) {
  value.visit([&](const auto& typed) {
    using Typed = std::remove_cvref_t<decltype(typed)>;
    if constexpr (toml::is_table<Typed> || toml::is_array<Typed>) {
      add_children(typed, target, places);
    } else if constexpr (toml::is_number<Typed>) {
      target.kind = Node::Kind::number;
      target.number = static_cast<double>(typed.get());
    } else if constexpr (toml::is_string<Typed>) {
      target.kind = Node::Kind::text;
      target.text = typed.get();
    } else {
      std::ostringstream written;
      written << typed;
      target.kind = Node::Kind::other;
      target.text = written.str();
    }
  });
  return target;
}

std::string contents(const std::filesystem::path& file, const std::string& name) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    throw InputError(name + ": must be a scene file, nothing is there");
  if (std::filesystem::is_directory(file, ignored)) {
    throw InputError(name + ": must be a scene file, this is a directory");
  }
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) throw InputError(name + ": must be a file that can be read");
  return text;
}

}  // namespace

Node read_toml(const std::filesystem::path& file) {
  const std::string name = one_line(file.string());
  const std::string text = contents(file, name);
  try {
    const toml::table table = toml::parse(text);
    Node root;
    root.place = name + ":1";
    return converted(table, std::move(root), {name});
  } catch (const toml::parse_error& error) {
    throw InputError(name + ":" + std::to_string(error.source().begin.line) +
                     ": must be TOML: " + one_line(error.description()));
  }
}

std::optional<Node> parse_toml_value(const std::string& text, const Node& target) {
  try {
    const toml::table table = toml::parse("value = " + text);
    if (table.size() != 1) return std::nullopt;
    return converted(*table.get("value"), target, {target.place, false});
  } catch (const toml::parse_error&) {
    return std::nullopt;
  }
}

}  // namespace rockstack
