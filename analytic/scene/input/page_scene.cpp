#include "analytic/scene/input/page_scene.hpp"

#include <utility>

#include "analytic/scene/lists.hpp"
#include "analytic/scene/messages/number_text.hpp"

namespace rockstack {
namespace {

constexpr const char* infinite = "inf";

void fill(Node& node, const Json& value) {
  if (value.is_structured()) {
    node.kind = value.is_object() ? Node::Kind::table : Node::Kind::array;
    node.children.reserve(value.size());
    for (const auto& [name, entry] : value.items()) {
      const std::string number = std::to_string(node.children.size() + 1);
      Node child = make_child(node, value.is_object() ? name : number, node.place);
      fill(child, entry);
      node.children.push_back(std::move(child));
    }
  } else if (value.is_number() || (value == infinite && node.name != "title")) {
    node.kind = Node::Kind::number;
    node.number = value.is_number() ? value.get<double>() : std::numeric_limits<double>::infinity();
  } else {
    node.kind = value.is_string() ? Node::Kind::text : Node::Kind::other;
    node.text = value.is_string() ? value.get<std::string>() : value.dump();
  }
}

bool is_tables(const Json& value) {
  return value.is_array() && !value.empty() && value.front().is_object();
}

/// Values first, then tables, whose headers end those before. `prefix`: of the tables' names, with its dot.
std::string table_text(const Json& table, const std::string& prefix) {
  std::string text;
  for (const auto& [name, value] : table.items())
    if (!value.is_object() && !is_tables(value))
      text.append(name).append(" = ").append(name == "title" ? toml_text(value.get<std::string>())
                                                             : toml_value(value)) += '\n';
  for (const auto& [name, value] : table.items()) {
    const std::string inner = prefix + name;
    for (const Json& entry : is_tables(value) ? value : Json::array({value}))
      if (entry.is_object())
        text.append(is_tables(value) ? "\n[[" : "\n[")
            .append(inner)
            .append(is_tables(value) ? "]]\n" : "]\n")
            .append(table_text(entry, inner + '.'));
  }
  return text;
}

}  // namespace

std::string toml_value(const Json& value) {
  if (value.is_string()) return value == infinite ? infinite : toml_text(value.get<std::string>());
  if (value.is_number()) return number_text(value.get<double>());
  return "[" + joined_texts(value, toml_value, ", ") + "]";
}

std::string scene_text(const Json& scene) {
  return table_text(scene, "");
}

Json page_scene(const Node& node) {
  if (node.kind == Node::Kind::number) return std::isfinite(node.number) ? Json(node.number) : Json(infinite);
  if (node.kind == Node::Kind::text || node.kind == Node::Kind::other) return node.text;
  Json list = Json::array(), table = Json::object();
  for (const Node& child : node.children)
    (node.kind == Node::Kind::array ? list.emplace_back() : table[child.name]) = page_scene(child);
  return node.kind == Node::Kind::array ? list : table;
}

Node scene_document(const Json& scene, const std::string& place) {
  Node root;
  root.place = place;
  fill(root, scene);
  return root;
}

std::string page_text(const Node& document, const Scene& scene) {
  if (document.children.empty()) return "";
  Json page = page_scene(document);
  page["title"] = scene.title;
  page["duration"] = scene.duration;
  for (const auto& [axis, motion] :
       {std::pair{"horizontal", &scene.horizontal}, std::pair{"vertical", &scene.vertical}})
    if (!motion->samples.empty())
      page["ground"][axis] = {{"samples", motion->samples}, {"interval", motion->interval}};
  return page.dump();
}

}  // namespace rockstack
