#include "comparisons/suites/suite.hpp"

#include <fmt/format.h>

#include <tuple>

#include "analytic/scene/input/toml_reader.hpp"
#include "comparisons/suites/suite_keys.hpp"

namespace rockstack {
namespace {

std::vector<double> read_steps(const Node& table) {
  const Node* node = find(table, "dt");
  if (node == nullptr) return default_steps;
  for (const Node& child : entries(*node, "an array of at least one step > 0, s")) number_above_zero(child);
  return numbers(*node);
}

std::vector<std::string> read_settings(const Node& table) {
  const Node* node = find(table, "settings");
  if (node == nullptr) return {"default", "tuned"};
  return mapped(entries(*node, "an array of \"default\" and \"tuned\""), [](const Node& child) {
    return choice<std::string>(child, {{"default", "default"}, {"tuned", "tuned"}});
  });
}

const WorkerEngine& read_engine(const Node& table, const std::filesystem::path& folder) {
  const Node* worker = find(table, "worker");
  const Node* name = find(table, "name");
  const Node& given = worker != nullptr ? *worker : required(table, "name", "an engine, e.g. \"bullet\"");
  try {
    if (worker == nullptr) return find_engine(text(given));
    return find_engine_at(folder / text(*worker), name != nullptr ? text(*name) : "");
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", given.place, error.what()));
  }
}

/// A parameter's value, which may be given by its name.
double read_value(const Node& node, const std::string& name, const WorkerEngine& engine) {
  try {
    const Setting& setting = find_setting(engine.name, engine.settings, name);
    const bool named = node.kind == Node::Kind::text;
    const double value = named ? choice_value(engine.name, setting, node.text) : number(node);
    check_value(engine.name, engine.settings, name, value);
    return value;
  } catch (const InputError&) {
    throw;
  } catch (const std::invalid_argument& error) {
    throw InputError(fmt::format("{}: {}", node.place, error.what()));
  }
}

/// Every combination of the values of [engines.parameters], each one value or an array.
std::vector<Parameters> read_changes(const Node& table, const WorkerEngine& engine) {
  std::vector<Parameters> list{{}};
  const Node* node = find(table, "parameters");
  if (node == nullptr) return list;
  if (node->kind != Node::Kind::table) throw wrong_value(*node, "a table of the engine's parameters");
  for (const Node& child : node->children) {
    const bool several = child.kind == Node::Kind::array;
    std::vector<Parameters> extended;
    for (const Node& given :
         several ? entries(child, "a value, or an array of some") : std::vector<Node>{child}) {
      const double value = read_value(given, child.name, engine);
      for (Parameters changes : list) {
        changes[child.name] = value;
        extended.push_back(std::move(changes));
      }
    }
    constexpr std::size_t most = 10'000;
    if (extended.size() > most)
      throw wrong_value(*node, fmt::format("of at most {} combinations of values", most));
    list = std::move(extended);
  }
  return list;
}

/// The engine that a table names and this build leaves out.
std::optional<std::string> left_out_engine(const Node& table) {
  const Node* name = find(table, "name");
  if (name == nullptr || find(table, "worker") != nullptr) return {};
  const std::string engine = text(*name).substr(0, text(*name).find(':'));
  const std::vector<std::string> left_out = engines_left_out();
  return std::ranges::find(left_out, engine) == left_out.end() ? std::nullopt : std::optional(engine);
}

std::vector<EngineSeries> read_series(const Node& table, const std::filesystem::path& folder) {
  const WorkerEngine& engine = read_engine(table, folder);
  std::vector<EngineSeries> list;
  for (const std::string& settings : read_settings(table))
    for (const Parameters& changes : read_changes(table, engine))
      list.push_back(make_series(engine, settings, read_steps(table), changes));
  return list;
}

}  // namespace

const KeyTable engine_keys{
    "[[engines]]",
    "an engine and how it runs: one series for each parameter set and value",
    {{"name", "\"ode\"", "", "ENGINE or ENGINE:SOLVER, see `rockstack list engines`", required_key,
      "of the engine; beside `worker`, one of its engines, its first if left out"},
     {"worker", "\"./my_engine.py\"", "", "a program, seen from the file's folder",
      "instead of `name`, or beside it", "an engine's own worker, see engines/README.md"},
     {"settings", "[\"tuned\"]", "", "of \"default\", \"tuned\"", "[\"default\", \"tuned\"]",
      "its parameter sets"},
     {"dt", "[1e-3]", "s", "at least one number > 0", "[1e-2, 1e-3, 1e-4]", "time steps"},
     {"parameters", "{ erp = [0.1, 0.2] }", "", "names of the engine's parameters, each a value or an array",
      "{}", "changes of its parameter set, in every combination"}}};

EngineSeries make_series(const WorkerEngine& engine, const std::string& settings, std::vector<double> steps,
                         const Parameters& changes) {
  EngineSeries series{&engine, settings,
                      settings == "tuned" ? engine.tuned_parameters() : engine.default_parameters(),
                      std::move(steps)};
  for (const auto& [name, value] : changes) {
    check_value(engine.name, engine.settings, name, value);
    series.parameters[name] = value;
    const std::vector<std::string>& choices = find_setting(engine.name, engine.settings, name).choices;
    series.settings +=
        fmt::format("+{}={}", name,
                    choices.empty() ? fmt::format("{}", value) : choices[static_cast<std::size_t>(value)]);
  }
  return series;
}

Parameters read_parameters(const std::vector<std::string>& texts, const WorkerEngine& engine) {
  Parameters changes;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    Node node;
    node.place = "--parameter " + one_line(text);
    if (equals == 0 || equals >= text.size() - 1)
      throw InputError(node.place + ": must be of the form name=value");
    const std::string name = text.substr(0, equals), value = text.substr(equals + 1);
    node.key = name;
    node.kind = Node::Kind::text;
    node.text = value;
    const Node given = parse_toml_value(value, node).value_or(node);
    if (!changes.emplace(name, read_value(given, name, engine)).second)
      throw InputError(node.place + ": must be given once");
  }
  return changes;
}

AskedEngines read_engines(const Node& root, const std::filesystem::path& folder) {
  AskedEngines asked;
  const Node* engines = find(root, "engines");
  if (engines == nullptr) return asked;
  std::set<std::tuple<std::string, std::string, std::string, double>> runs;
  for (const Node& table : entries(*engines, "an array of tables")) {
    require_table(table, engine_keys);
    if (const auto name = left_out_engine(table)) {
      found_or_added(
          asked.left_out, [&](const std::string& known) { return known == *name; }, *name);
      continue;
    }
    for (EngineSeries& series : read_series(table, folder)) {
      for (const double dt : series.steps)
        if (!runs.emplace(series.engine->name, series.engine->solver, series.settings, dt).second)
          throw InputError(fmt::format("{}: {}: must not name a run twice: {}:{}, {}, dt = {} s", table.place,
                                       table.key, series.engine->name, series.engine->solver, series.settings,
                                       dt));
      asked.series.push_back(std::move(series));
    }
  }
  return asked;
}

}  // namespace rockstack
