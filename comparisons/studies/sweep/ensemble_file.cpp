#include <fmt/format.h>

#include <set>

#include "analytic/scene/input/toml_reader.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/outcome_columns.hpp"
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
  const std::string& name = variation.group;
  if (variation.is_drawn()) {
    if (!name.empty()) throw wrong_value(*find(table, "group"), "left out where values are drawn");
    return;
  }
  for (Axis& axis : ensemble.axes) {
    if (name.empty() || axis.group != name) continue;
    if (axis.length != variation.values.size())
      throw wrong_value(*find(table, "group"),
                        fmt::format("that of tables with as many values, {} has {} and this {}",
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

/// Refuses keys of drawing where nothing is drawn, and too many runs.
void require_drawing(const Ensemble& ensemble, const Node& root) {
  const bool draws = std::ranges::any_of(ensemble.variations, &Variation::is_drawn);
  for (const char* name : {"samples", "seed", "sampling"}) {
    const Node* node = find(root, name);
    if (draws && node == nullptr && std::string_view(name) != "sampling")
      throw missing_key(root, name, "given where values are drawn");
    if (!draws && node != nullptr) throw wrong_value(*node, "left out where no values are drawn");
  }
  double runs = static_cast<double>(ensemble.samples) * static_cast<double>(sample_size(ensemble));
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

std::string read_other_axis(const Node& node, const Ensemble& ensemble) {
  std::string axis = read_axis_name(node, ensemble);
  if (axis == ensemble.summary.intensity) throw wrong_value(node, "another key than intensity is");
  return axis;
}

/// Columns of numbers that come out of runs.
std::vector<std::string> read_indices(const Node& array, const Ensemble& ensemble) {
  const std::vector<OutcomeColumn> columns = outcome_columns(block_count(ensemble));
  std::vector<const char*> names;
  for (const OutcomeColumn& column : columns)
    if (std::holds_alternative<OutcomeColumn::Measure>(column.value) ||
        std::holds_alternative<OutcomeColumn::Count>(column.value))
      names.push_back(column.name.c_str());
  std::vector<std::string> indices;
  for (const Node& child : entries(array, "an array of columns, e.g. [\"toppled\"]")) {
    place_among(child, names);
    if (std::ranges::find(indices, child.text) != indices.end()) throw wrong_value(child, "named once");
    indices.push_back(child.text);
  }
  return indices;
}

/// Indices are of drawn values, at each intensity of the grid where it has one.
void require_indices(const Ensemble& ensemble, const Node& indices) {
  if (std::ranges::none_of(ensemble.variations, &Variation::is_drawn))
    throw wrong_value(indices, "left out where no values are drawn");
  if (ensemble.samples < 2) throw wrong_value(indices, "left out where samples is 1");
  for (const Axis& axis : ensemble.axes) {
    const auto is_intensity = [&](std::size_t v) {
      return ensemble.variations[v].name() == ensemble.summary.intensity;
    };
    if (std::ranges::none_of(axis.variations, is_intensity))
      throw wrong_value(
          indices, fmt::format("left out where the grid has another direction than intensity, as {} does: "
                               "one_of draws from such values",
                               ensemble.variations[axis.variations.front()].place));
  }
}

void read_summary(Ensemble& ensemble, const Node& root) {
  const Node* table = find(root, "summary");
  if (table == nullptr) return;
  read_members(*table, summary_keys, ensemble);
  const SummaryKeys& keys = ensemble.summary;
  const bool indices_alone = !keys.indices.empty() && keys.period.empty() && keys.friction.empty();
  if (keys.intensity.empty() && !indices_alone)
    throw missing_key(*table, "intensity", "a key that is varied over numbers");
  if (!keys.period.empty() && !keys.friction.empty())
    throw wrong_value(*find(*table, "friction"), "left out where there is a period");
  if (!keys.indices.empty()) require_indices(ensemble, *find(*table, "indices"));
}

/// Makes the scene of the first value of everything, then of each value by itself; of very many, of some.
void try_values(const Ensemble& ensemble, MotionLibrary& library) {
  std::vector<Axis> axes = ensemble.axes;
  for (std::size_t v = 0; v < ensemble.variations.size(); ++v)
    if (const Variation& one = ensemble.variations[v]; one.is_drawn() && !one.values.empty())
      axes.push_back({"", {v}, one.values.size()});
  SceneDocument document = typical_document(ensemble);
  make_scene(document, library);
  const auto try_value = [&](const Axis& axis, std::size_t i) {
    for (const std::size_t v : axis.variations)
      set_values(document, ensemble.variations[v], ensemble.variations[v].values[i]);
    make_scene(document, library);
  };
  for (const Axis& axis : axes) {
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
     {"sampling",
      "\"random\"",
      {{sampling_names[0], "each value by itself"},
       {sampling_names[1],
        "of all samples one in each of as many equally likely parts of every distribution"}},
      "how values are drawn",
      &Ensemble::sampling},
     {"tolerance", "1e-9", "", tolerances(), "of the solver; 0 is rounding, more is faster",
      &Ensemble::tolerance},
     {{"demands", "\"none\"", "", "\"kept\" or \"none\"", "\"kept\"",
       "least normal forces and friction needed, of each run; none is faster"},
      [](const Node& node, Ensemble& ensemble) {
        ensemble.demands = choice<bool>(node, {{"kept", true}, {"none", false}});
      }},
     {"vary", "", "", "tables [[vary]]", required_key, "what differs from run to run"},
     {"summary", "", "", "a table [summary]", no_default, "which figures and tables are made"}}};

const KeysOf<Ensemble> summary_keys{
    "[summary]",
    "figures and tables of the whole sweep",
    {{{"intensity", "\"duration\"", "", "a key that is varied over numbers", required_key,
       "fragility and incremental dynamic analysis over it; with indices it may be left out"},
      [](const Node& node, Ensemble& ensemble) {
        ensemble.summary.intensity = read_axis_name(node, ensemble);
      }},
     {{"period", "\"duration\"", "", "a key that is varied over numbers", no_default,
       "with intensity: the overturning spectrum of a pulse"},
      [](const Node& node, Ensemble& ensemble) {
        ensemble.summary.period = read_other_axis(node, ensemble);
      }},
     {{"friction", "\"duration\"", "", "a key that is varied over numbers, without period", no_default,
       "with intensity: the map of rest, slide, rock, slide-rock and free flight"},
      [](const Node& node, Ensemble& ensemble) {
        ensemble.summary.friction = read_other_axis(node, ensemble);
      }},
     {{"indices", "[\"toppled\"]", "", "columns of numbers of runs.csv", no_default,
       "Sobol indices of these, which say which drawn value decides; a sample is then two runs and one for each key "
       "that is drawn"},
      [](const Node& node, Ensemble& ensemble) {
        ensemble.summary.indices = read_indices(node, ensemble);
      }}}};

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
  read_summary(ensemble, root);
  require_drawing(ensemble, root);
  try_values(ensemble, library);
  return ensemble;
}

}  // namespace rockstack
