#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "analytic/scene/input/scene_keys.hpp"
#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/studies/impact_laws/study.hpp"
#include "comparisons/studies/stability/study.hpp"
#include "comparisons/studies/sweep/ensemble_keys.hpp"
#include "comparisons/suites/suite_keys.hpp"

namespace rockstack {
namespace {

using Json = nlohmann::ordered_json;

/// A kind of input file with its tables.
struct FileKeys {
  const char* file;
  std::initializer_list<const KeyTable*> tables;
};

constexpr std::initializer_list<FileKeys> files{{"scene", scene_tables},
                                                {"suite", suite_tables},
                                                {"suite", stability_tables},
                                                {"suite", impact_law_tables},
                                                {"ensemble", ensemble_tables}};

void print_table(const KeyTable& table) {
  const std::string_view header = table.header;
  fmt::print("\n{}{}# {}\n", header, header.empty() ? "" : "  ", table.meaning);
  for (const InputKey& key : table.keys) {
    fmt::print("  {:<20} {:<11} {:<28} {}\n", key.name, *key.unit != '\0' ? key.unit : "-", key.standard,
               key.range);
    fmt::print("  {:<20} {}\n", "", key.meaning);
  }
}

Json table_json(const FileKeys& file, const KeyTable& table) {
  Json json{
      {"file", file.file}, {"table", table.header}, {"meaning", table.meaning}, {"keys", Json::array()}};
  for (const InputKey& key : table.keys) {
    json["keys"].push_back({{"key", key.name},
                            {"unit", key.unit},
                            {"range", key.range},
                            {"default", key.standard},
                            {"meaning", key.meaning},
                            {"example", key.example}});
  }
  return json;
}

}  // namespace

int keys_command(const KeysArguments& arguments, const Common& common) {
  refuse_overrides(common, "keys are explained, not used");
  Json list = Json::array();
  if (!common.json)
    fmt::print("  {:<20} {:<11} {:<28} {}\n", "KEY", "UNIT", "DEFAULT", "RANGE, and below it MEANING");
  for (const FileKeys& file : files) {
    if (!arguments.kind.empty() && arguments.kind != file.file) continue;
    for (const KeyTable* table : file.tables) {
      if (common.json) {
        list.push_back(table_json(file, *table));
      } else {
        print_table(*table);
      }
    }
  }
  if (common.json) fmt::print("{}\n", list.dump(2));
  return 0;
}

}  // namespace rockstack
