#pragma once

#include <fmt/format.h>

#include "comparisons/interfaces/program/commands.hpp"

namespace rockstack {

struct CheckEngineArguments {
  std::vector<std::string> engines;  ///< empty: all
  std::vector<std::string> settings{"default", "tuned"};
  std::vector<std::string> scenes;  ///< names of checks, or of the canon's scenes; empty: all
  bool canon = false;               ///< the long form: the canon's scenes in the place of the checks
  std::filesystem::path out;        ///< empty: nothing is written
};

/// Those of some names, or all. @throws InputError naming all for another name.
template <class List, class Name>
List chosen_from(List list, const std::vector<std::string>& names, const Name& name_of) {
  const auto there = mapped(list, [&](const auto& one) { return std::string(name_of(one)); });
  const auto is_in = [](const std::vector<std::string>& all, const std::string& name) {
    return std::ranges::find(all, name) != all.end();
  };
  for (const std::string& name : names)
    if (!is_in(there, name))
      throw InputError(fmt::format("--scene {}: must be one of {}{}", name, fmt::join(there, ", "),
                                   did_you_mean(name, there)));
  if (!names.empty()) std::erase_if(list, [&](const auto& one) { return !is_in(names, name_of(one)); });
  return list;
}

/// The options of both forms.
void add_check_engine(CLI::App& command, CheckEngineArguments& arguments);

/// The long form: the canon's scenes at five steps, the cheapest first for every engine.
int run_canon(const CheckEngineArguments& arguments, const Common& common);

}  // namespace rockstack
