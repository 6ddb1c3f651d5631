#include <fmt/format.h>

#include "analytic/scene/input/key_json.hpp"
#include "analytic/scene/input/scene_keys.hpp"
#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/studies/impact_laws/study.hpp"
#include "comparisons/studies/round/study.hpp"
#include "comparisons/studies/stability/study.hpp"
#include "comparisons/studies/sweep/ensemble.hpp"
#include "comparisons/suites/suite_keys.hpp"

namespace rockstack {
namespace {

constexpr std::initializer_list<const KeyTable*> measured_tables{&measured_keys};

/// The kinds of input files with their tables.
constexpr std::initializer_list<std::pair<const char*, std::initializer_list<const KeyTable*>>> files{
    {"scene", scene_tables},     {"scene", measured_tables},   {"suite", suite_tables},
    {"suite", stability_tables}, {"suite", impact_law_tables}, {"ensemble", ensemble_tables},
    {"cylinder", round_tables}};

void print_table(const KeyTable& table) {
  const std::string_view header = table.header;
  fmt::print("\n{}{}# {}\n", header, header.empty() ? "" : "  ", table.meaning);
  for (const InputKey& key : table.keys) {
    fmt::print("  {:<20} {:<11} {:<28} {}\n", key.name, *key.unit != '\0' ? key.unit : "-", key.default_value,
               key.range);
    fmt::print("  {:<20} {}\n", "", key.meaning);
  }
}

Json table_json(const char* file, const KeyTable& table) {
  Json json{{"file", file}};
  json.update(key_json(table));
  return json;
}

struct KeysArguments {
  std::string kind;  ///< of input files; empty: all
};

int run_keys(const KeysArguments& arguments, const Common& common) {
  refuse_overrides(common, "keys are explained, not used");
  Json list = Json::array();
  if (!common.json)
    fmt::print("  {:<20} {:<11} {:<28} {}\n", "KEY", "UNIT", "DEFAULT", "RANGE, and below it MEANING");
  for (const auto& [file, tables] : files) {
    if (!arguments.kind.empty() && arguments.kind != file) continue;
    for (const KeyTable* table : tables) {
      if (common.json)
        list.push_back(table_json(file, *table));
      else
        print_table(*table);
    }
  }
  if (common.json) fmt::print("{}\n", list.dump(2));
  return 0;
}

void add_keys(CLI::App& command, KeysArguments& arguments) {
  command.add_option("kind", arguments.kind, "scene, suite, ensemble or cylinder; left out: all")
      ->check(one_of({"scene", "suite", "ensemble", "cylinder"}));
}

}  // namespace

Command keys_command() {
  return make_command("keys", "explain every key of input files: unit, default, range, meaning", add_keys,
                      run_keys);
}

}  // namespace rockstack
