#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "analytic/scene/input/toml_reader.hpp"
#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/studies/lessons/lesson.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
namespace {

const std::vector<std::string>& listed_kinds() {
  static const std::vector<std::string> kinds{"scenes",  "suites", "ensembles", "cylinders",
                                              "lessons", "proved", "engines"};
  return kinds;
}

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

std::string scene_title(const std::string& name, const std::string& kind) {
  const Node root = read_toml(find_file(name, kind));
  const Node* title = find(root, "title");
  return title != nullptr ? title->text : "";
}

/// Tables of events whose times are certain, each of the scene that it is named by.
std::vector<Listed> listed_proved() {
  const std::string folder = "canon/proved";
  return mapped(shipped_names(folder, ".csv"), [&](const std::string& name) {
    std::ifstream table(shipped(folder) / (name + ".csv"));
    const auto lines = std::count(std::istreambuf_iterator<char>(table), {}, '\n');
    return Listed{name, fmt::format("{} events; {}", lines - 1, scene_title(name, "scenes"))};
  });
}

std::vector<Listed> listed(const std::string& kind) {
  if (kind == "engines") return listed_engines();
  if (kind == "proved") return listed_proved();
  if (kind == "lessons")
    return mapped(lessons(), [](const Lesson& lesson) { return Listed{lesson.name, title(lesson)}; });
  return mapped(shipped_names(kind), [&](const std::string& name) {
    return Listed{name, scene_title(name, kind)};
  });
}

void print_list(const std::vector<Listed>& list, const std::string& indent) {
  std::size_t width = 0;
  for (const Listed& one : list) width = std::max(width, one.name.size());
  for (const Listed& one : list) fmt::print("{}{:<{}}  {}\n", indent, one.name, width, one.title);
}

/// All kinds in one table of a document.
void print_lists(const std::vector<std::string>& kinds, TableForm form) {
  std::vector<TableCells> lines{{"kind", "name", "title"}};
  for (const std::string& kind : kinds)
    for (const Listed& one : listed(kind)) lines.push_back({kind, one.name, one.title});
  print_table(lines, form);
}

struct ListArguments {
  std::string kind;  ///< empty: all
};

int run_list(const ListArguments& arguments, const Common& common) {
  refuse_overrides(common, "names have no scene keys");
  const std::string& only = arguments.kind;
  const std::vector<std::string> kinds = only.empty() ? listed_kinds() : std::vector{only};
  if (common.prints_documents()) {
    print_lists(kinds, common.table);
    return 0;
  }
  Json all;
  for (const std::string& kind : kinds) {
    if (common.json) {
      (only.empty() ? all[kind] : all) = mapped(listed(kind), [](const Listed& one) {
        return Json{{"name", one.name}, {"title", one.title}};
      });
    } else {
      if (only.empty()) fmt::print("{}\n", kind);
      print_list(listed(kind), only.empty() ? "  " : "");
    }
  }
  if (common.json) fmt::print("{}\n", all.dump(2));
  return 0;
}

void add_list(CLI::App& command, ListArguments& arguments) {
  command
      .add_option("what", arguments.kind,
                  fmt::format("{} (events at certain times); left out: all", fmt::join(listed_kinds(), ", ")))
      ->check(one_of(listed_kinds()));
}

}  // namespace

Command list_command() {
  return with_tables(make_command("list", "list what there is, with a line on each", add_list, run_list));
}

}  // namespace rockstack
