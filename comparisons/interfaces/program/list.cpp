#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "analytic/scene/input/toml_reader.hpp"
#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/studies/lessons/lesson.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
namespace {

using Json = nlohmann::ordered_json;

/// What can be named on a command line, and what it is.
struct Listed {
  std::string name, title;
};

std::vector<Listed> listed_engines() {
  std::vector<Listed> list;
  for (const WorkerEngine& engine : engines())
    list.push_back({engine.full_name(),
                    fmt::format("{}; {}; {}", engine.version, engine.licence, engine.program.string())});
  for (const BrokenWorker& broken : broken_workers())
    list.push_back({broken.program, "no worker: " + one_line(broken.reason)});
  for (const std::string& name : engines_left_out()) list.push_back({name, "left out of this build"});
  return list;
}

std::vector<Listed> listed(const std::string& kind) {
  std::vector<Listed> list;
  if (kind == "engines") return listed_engines();
  if (kind == "lessons") {
    for (const Lesson& lesson : lessons()) list.push_back({lesson.name, title(lesson)});
    return list;
  }
  for (const std::string& name : shipped_names(kind)) {
    const Node root = read_toml(find_file(name, kind));
    const Node* title = find(root, "title");
    list.push_back({name, title != nullptr ? title->text : ""});
  }
  return list;
}

void print_list(const std::vector<Listed>& list, const std::string& indent) {
  std::size_t width = 0;
  for (const Listed& one : list) width = std::max(width, one.name.size());
  for (const Listed& one : list) fmt::print("{}{:<{}}  {}\n", indent, one.name, width, one.title);
}

Json to_json(const std::vector<Listed>& list) {
  Json json = Json::array();
  for (const Listed& one : list) json.push_back({{"name", one.name}, {"title", one.title}});
  return json;
}

}  // namespace

int list_command(const ListArguments& arguments, const Common& common) {
  refuse_overrides(common, "names have no scene keys");
  const std::string& only = arguments.kind;
  Json all;
  for (const std::string kind : {"scenes", "suites", "ensembles", "lessons", "engines"}) {
    if (!only.empty() && kind != only) continue;
    if (common.json) {
      (only.empty() ? all[kind] : all) = to_json(listed(kind));
    } else {
      if (only.empty()) fmt::print("{}\n", kind);
      print_list(listed(kind), only.empty() ? "  " : "");
    }
  }
  if (common.json) fmt::print("{}\n", all.dump(2));
  return 0;
}

}  // namespace rockstack
