#include <fmt/format.h>

#include <set>

#include "analytic/scene/input/toml_reader.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/studies/sweep/ensemble.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
namespace {

/// Strips what stands before the keys of a scene that is a table of another file.
void rename_keys(Node& node, std::size_t prefix) {
  node.key.erase(0, prefix);
  for (Node& child : node.children) rename_keys(child, prefix);
}

SceneDocument read_base(const Node& scene, const std::filesystem::path& folder, const std::string& title,
                        const std::vector<std::string>& overrides) {
  if (scene.kind == Node::Kind::text) return read_document(named_file(scene, "scenes", folder), overrides);
  if (scene.kind != Node::Kind::table) throw wrong_value(scene, "a scene file, or a table that is a scene");
  SceneDocument document{scene, folder, title};
  document.root.name.clear();
  document.root.key.clear();
  for (Node& child : document.root.children) rename_keys(child, std::string("scene.").size());
  for (const std::string& each : overrides) apply_override(document.root, each);
  return document;
}

/// Puts a variation on the axis of its group, or on one of its own.
void add_to_axes(Ensemble& ensemble, const Node& table) {
  const std::size_t index = ensemble.variations.size() - 1;
  const Variation& variation = ensemble.variations.back();
  const Node* group = find(table, "group");
  if (variation.distribution) {
    if (group != nullptr) throw wrong_value(*group, "left out where values are drawn");
    return;
  }
  const std::string name = group == nullptr ? "" : text(*group);
  for (Axis& axis : ensemble.axes) {
    if (name.empty() || axis.group != name) continue;
    if (axis.length != variation.values.size())
      throw wrong_value(*group, fmt::format("that of tables with as many values, {} has {} and this {}",
                                            ensemble.variations[axis.variations.front()].name(), axis.length,
                                            variation.values.size()));
    axis.variations.push_back(index);
    return;
  }
  ensemble.axes.push_back({name, {index}, variation.values.size()});
}

void require_new_keys(const Ensemble& ensemble, const Variation& variation) {
  std::set<std::string> taken;
  for (const Variation& other : ensemble.variations) taken.insert(other.keys.begin(), other.keys.end());
  for (const std::string& key : variation.keys)
    if (!taken.insert(key).second)
      throw InputError(fmt::format("{}: key = {}: must be varied only once", variation.place, one_line(key)));
}

void read_variations(Ensemble& ensemble, const Node& root, const std::filesystem::path& folder) {
  const Node& tables = required(root, "vary", "at least one table [[vary]]");
  for (const Node& table : entries(tables, "an array of tables, [[vary]]")) {
    Variation variation = read_variation(table, folder);
    require_new_keys(ensemble, variation);
    ensemble.variations.push_back(std::move(variation));
    add_to_axes(ensemble, table);
  }
}

/// What is set for all runs must not be varied too: it would be without effect.
void require_unvaried(const Ensemble& ensemble, const std::vector<std::string>& overrides) {
  for (const std::string& each : overrides) {
    std::string key = each.substr(0, each.find('='));
    std::erase(key, ' ');
    for (const Variation& variation : ensemble.variations)
      if (variation.has(key))
        throw InputError(fmt::format("--set {}: must be a key that is not varied, as {} does", one_line(each),
                                     variation.place));
  }
}

constexpr double most_runs = 1e9;

void read_drawing(Ensemble& ensemble, const Node& root) {
  const bool draws = std::ranges::any_of(
      ensemble.variations, [](const Variation& variation) { return variation.distribution.has_value(); });
  for (const char* name : {"samples", "seed"}) {
    const Node* node = find(root, name);
    if (draws && node == nullptr) throw missing_key(root, name, "given where values are drawn");
    if (!draws && node != nullptr) throw wrong_value(*node, "left out where no values are drawn");
  }
  double runs = static_cast<double>(ensemble.samples);
  for (const Axis& axis : ensemble.axes) runs *= static_cast<double>(axis.length);
  if (runs > most_runs)
    throw InputError(fmt::format("{}: {} runs: must be at most {}", root.place, number_text(runs),
                                 number_text(most_runs)));
}

/// The name of the variation that a summary's key stands for; its values must be numbers.
std::string read_axis_name(const Node& node, const Ensemble& ensemble) {
  for (const Variation& variation : ensemble.variations) {
    const bool numbers = std::ranges::all_of(
        variation.values, [](const Value& value) { return value.node.kind == Node::Kind::number; });
    if (variation.has(text(node)) && numbers) return variation.name();
  }
  throw wrong_value(node, "a key that is varied over numbers");
}

void read_summary(Ensemble& ensemble, const Node& root) {
  const Node* table = find(root, "summary");
  if (table == nullptr) return;
  require_table(*table, summary_keys);
  ensemble.summary.intensity =
      read_axis_name(required(*table, "intensity", "a key that is varied over numbers"), ensemble);
  const auto other_axis = [&](const Node& node) {
    std::string axis = read_axis_name(node, ensemble);
    if (axis == ensemble.summary.intensity) throw wrong_value(node, "another key than intensity is");
    return axis;
  };
  if (const Node* period = find(*table, "period")) ensemble.summary.period = other_axis(*period);
  if (const Node* friction = find(*table, "friction")) {
    if (!ensemble.summary.period.empty()) throw wrong_value(*friction, "left out where there is a period");
    ensemble.summary.friction = other_axis(*friction);
  }
}

/// Makes the scene of the first value of everything, then of each value by itself; of very many, of some.
void try_values(const Ensemble& ensemble, MotionLibrary& library) {
  SceneDocument document = typical_document(ensemble);
  make_scene(document, library);
  const auto try_value = [&](const Axis& axis, std::size_t i) {
    for (const std::size_t v : axis.variations)
      set_values(document, ensemble.variations[v], ensemble.variations[v].values[i]);
    make_scene(document, library);
  };
  for (const Axis& axis : ensemble.axes) {
    constexpr std::size_t most_tried = 1000;
    const std::size_t stride = 1 + axis.length / most_tried;
    for (std::size_t i = 0; i < axis.length; i += stride) try_value(axis, i);
    try_value(axis, axis.length - 1);
    try_value(axis, 0);  // for the axes that follow
  }
}

/// Tolerances of the solver: 0 is rounding.
CheckedNumber tolerances() {
  constexpr double most = 1e-3;
  return {"0 to 1e-3", "a number", [](const Node& node) {
            if (!(number(node) >= 0 && node.number <= most))
              throw wrong_value(node, "a number from 0, for rounding, to 1e-3");
            return node.number;
          }};
}

}  // namespace

const KeysOf<Ensemble> ensemble_keys{
    "",
    "an ensemble: one scene many times, some of its keys varied",
    {{"title", "\"Fragility\"", "", "a text", required_key, "heads figures", &Ensemble::title},
     {"scene", "\"scene.toml\"", "",
      "a file beside the ensemble, or a table [scene] with the keys of a scene", required_key, "what is run"},
     {"samples", "100", "", whole_numbers(1, most_runs), "required where values are drawn",
      "runs at each point of the grid, each with values drawn anew", &Ensemble::samples},
     {"seed", "1", "", whole_numbers(0, largest_seed), "required where values are drawn", "of drawn values",
      &Ensemble::seed},
     {"tolerance", "1e-9", "", tolerances(), "of the solver; 0 is rounding, more is faster",
      &Ensemble::tolerance},
     {{"demands", "\"none\"", "", "\"kept\" or \"none\"", "\"kept\"",
       "least normal forces and friction needed, of each run; none is faster"},
      [](const Node& node, Ensemble& ensemble) {
        ensemble.demands = choice<bool>(node, {{"kept", true}, {"none", false}});
      }},
     {"vary", "", "", "tables [[vary]]", required_key, "what differs from run to run"},
     {"summary", "", "", "a table [summary]", no_default, "which figures and tables are made"}}};

const KeyTable summary_keys{
    "[summary]",
    "figures and tables of the whole sweep",
    {{"intensity", "\"duration\"", "", "a key that is varied over numbers", required_key,
      "fragility and incremental dynamic analysis over it"},
     {"period", "\"duration\"", "", "a key that is varied over numbers", no_default,
      "with intensity: the overturning spectrum of a pulse"},
     {"friction", "\"duration\"", "", "a key that is varied over numbers, without period", no_default,
      "with intensity: the map of rest, slide, rock, slide-rock and free flight"}}};

Ensemble read_ensemble(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                       MotionLibrary& library) {
  return make_ensemble(read_toml(file), file, overrides, library);
}

Ensemble make_ensemble(const Node& root, const std::filesystem::path& file,
                       const std::vector<std::string>& overrides, MotionLibrary& library) {
  Ensemble ensemble;
  read_members(root, ensemble_keys, ensemble);
  ensemble.base = read_base(required(root, "scene", "a scene file, or a table that is a scene"),
                            file.parent_path(), ensemble.title, overrides);
  read_variations(ensemble, root, file.parent_path());
  require_unvaried(ensemble, overrides);
  read_drawing(ensemble, root);
  read_summary(ensemble, root);
  try_values(ensemble, library);
  return ensemble;
}

}  // namespace rockstack
