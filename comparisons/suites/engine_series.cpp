#include "comparisons/suites/suite.hpp"

#include <fmt/format.h>

#include <tuple>

#include "analytic/scene/input/toml_reader.hpp"
#include "comparisons/suites/suite_keys.hpp"

namespace rockstack {
namespace {

std::vector<double> read_steps(const Node& node) {
  for (const Node& child : entries(node, "an array of at least one step > 0, s")) number_above_zero(child);
  return numbers(node);
}

std::vector<std::string> read_settings(const Node& node) {
  return mapped(entries(node, "an array of \"default\" and \"tuned\""), [](const Node& child) {
    return choice<std::string>(child, {{"default", "default"}, {"tuned", "tuned"}});
  });
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
std::vector<Parameters> read_changes(const Node* node, const WorkerEngine& engine) {
  std::vector<Parameters> list{{}};
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

/// What a name stands for, as an error of the place that it has. @throws InputError.
template <class Find>
const WorkerEngine& found_at(const Node& given, const Find& find) {
  try {
    return find();
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", given.place, error.what()));
  }
}

/// The one engine of a table that does not stand for all.
const WorkerEngine& engine_of(const EngineTable& asked, const std::filesystem::path& folder) {
  const std::string name = asked.name != nullptr ? text(*asked.name) : "";
  if (asked.worker == nullptr)
    return found_at(
        *asked.name, [&]() -> auto& { return find_engine(name); });
  return found_at(
      *asked.worker, [&]() -> auto& { return find_engine_at(folder / text(*asked.worker), name); });
}

bool is_all(const EngineTable& asked) {
  return asked.name != nullptr && asked.name->text == all_engines;
}

/// Whether a name is that of an engine, with or without its solver.
bool is_named(const std::string& name, const std::string& engine, const std::string& solver) {
  return name == engine || name == engine + ":" + solver;
}

bool is_excepted(const EngineTable& asked, const std::string& engine, const std::string& solver) {
  return std::ranges::any_of(asked.except,
                             [&](const std::string& name) { return is_named(name, engine, solver); });
}

/// Engines of this build that a table stands for.
EngineList engines_asked(const EngineTable& asked, const std::filesystem::path& folder) {
  if (!is_all(asked)) return {engine_of(asked, folder)};
  EngineList list;
  for (const WorkerEngine& engine : engines())
    if (!is_excepted(asked, engine.name, engine.solver)) list.emplace_back(engine);
  return list;
}

/// Names of engines that a table stands for and this build leaves out.
std::vector<std::string> left_out_of(const EngineTable& asked) {
  if (asked.worker != nullptr) return {};
  std::vector<std::string> list = engines_left_out();
  const std::string name = asked.name->text.substr(0, asked.name->text.find(':'));
  std::erase_if(list, [&](const std::string& one) {
    return is_all(asked) ? is_excepted(asked, one, "") : one != name;
  });
  return list;
}

std::vector<EngineSeries> series_asked(const EngineTable& asked, const std::filesystem::path& folder) {
  std::vector<EngineSeries> list;
  for (const WorkerEngine& engine : engines_asked(asked, folder))
    for (const std::string& settings : asked.settings)
      for (const Parameters& changes : read_changes(asked.parameters, engine))
        list.push_back(make_series(engine, settings, asked.steps, changes));
  return list;
}

/// Refuses names of no engine, be it left out of this build.
void require_known(const Node& except) {
  const std::vector<std::string> left_out = engines_left_out();
  for (const Node& child : except.children) {
    const auto names = [&](const WorkerEngine& one) { return is_named(child.text, one.name, one.solver); };
    const std::string engine = child.text.substr(0, child.text.find(':'));
    if (std::ranges::none_of(engines(), names) && std::ranges::find(left_out, engine) == left_out.end())
      throw wrong_value(child, "an engine, with or without its solver, of `rockstack list engines`");
  }
}

EngineTable read_engine_table(const Node& table) {
  EngineTable asked;
  read_members(table, engine_keys, asked);
  if (asked.name == nullptr && asked.worker == nullptr) required(table, "name", "an engine, e.g. \"bullet\"");
  for (const char* key : {"worker", "parameters"})
    if (const Node* node = find(table, key); node != nullptr && is_all(asked))
      throw wrong_value(*node, "left out beside `name` = \"*\": it is of one engine");
  const Node* except = find(table, "except");
  if (except == nullptr) return asked;
  if (!is_all(asked)) throw wrong_value(*except, "left out where `name` is not \"*\"");
  require_known(*except);
  return asked;
}

}  // namespace

const KeysOf<EngineTable> engine_keys{
    "[[engines]]",
    "an engine and how it runs: one series for each parameter set and value",
    {{{"name", "\"ode\"", "",
       "ENGINE or ENGINE:SOLVER, see `rockstack list engines`; \"*\": all that there are", required_key,
       "of the engine; beside `worker`, one of its engines, its first if left out"},
      [](const Node& node, EngineTable& asked) {
        text(node);
        asked.name = &node;
      }},
     {{"except", "[\"simbody\"]", "", "names as in `name`", "[]", "engines that \"*\" does not stand for"},
      [](const Node& node, EngineTable& asked) {
        asked.except = mapped(entries(node, "an array of engines, e.g. [\"bullet\"]"), text);
      }},
     {{"worker", "\"./my_engine.py\"", "", "a program, seen from the file's folder",
       "instead of `name`, or beside it", "an engine's own worker, see engines/README.md"},
      [](const Node& node, EngineTable& asked) {
        text(node);
        asked.worker = &node;
      }},
     {{"settings", "[\"tuned\"]", "", "of \"default\", \"tuned\"", "[\"default\", \"tuned\"]",
       "its parameter sets"},
      [](const Node& node, EngineTable& asked) { asked.settings = read_settings(node); }},
     {{"dt", "[1e-3]", "s", "at least one number > 0", "[1e-2, 1e-3, 1e-4]", "time steps"},
      [](const Node& node, EngineTable& asked) { asked.steps = read_steps(node); }},
     {{"parameters", "{ erp = [0.1, 0.2] }", "", "names of the engine's parameters, each a value or an array",
       "{}", "changes of its parameter set, in every combination"},
      [](const Node& node, EngineTable& asked) { asked.parameters = &node; }}}};

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
    const EngineTable wanted = read_engine_table(table);
    const std::vector<std::string> left_out = left_out_of(wanted);
    for (const std::string& name : left_out)
      found_or_added(
          asked.left_out, [&](const std::string& known) { return known == name; }, name);
    if (!left_out.empty() && !is_all(wanted)) continue;
    for (EngineSeries& series : series_asked(wanted, folder)) {
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
