#include <fmt/format.h>

#include "analytic/scene/files/file_text.hpp"
#include "analytic/scene/input/json_reader.hpp"
#include "analytic/scene/input/page_scene.hpp"
#include "analytic/scene/input/toml_reader.hpp"
#include "comparisons/measures/results/provenance.hpp"
#include "comparisons/studies/stability/study.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
namespace {

/// Makes the stack one of that many blocks: cut off, or its top block over and over.
void restack(std::size_t blocks, NamedScene& scene) {
  Json page = parse_json(page_text(scene.document, scene.scene), "");
  for (const char* key : {"/blocks", "/initial/angles", "/initial/velocities"})
    if (const Json::json_pointer place(key); page.contains(place)) {
      auto& list = page[place].get_ref<Json::array_t&>();
      list.resize(blocks, list.back());
    }
  scene.text = scene_text(page);
  scene.document = scene_document(page, scene.name);
  Scene made = recorded_scene({{"page", page.dump()}}, "", scene.name);
  made.horizontal = scene.scene.horizontal;  // with their sources
  made.vertical = scene.scene.vertical;
  scene.scene = std::move(made);
}

/// Keys of a scene, each an array of its values along the axis.
const std::vector<Node>& read_set(const Node& axis, std::size_t count) {
  const Node& set = required(axis, "set", "a table of scene keys, each an array");
  if (set.kind != Node::Kind::table || set.children.empty())
    throw wrong_value(set, "a table of scene keys, each an array");
  for (const Node& child : set.children) {
    const std::vector<double> values = numbers(child);
    if (values.size() != count)
      throw wrong_value(child, fmt::format("an array of {} numbers, one for each of axis.values", count));
    for (const double value : values)
      if (child.name == "blocks" && !(value >= 1 && value <= max_blocks && value == std::floor(value)))
        throw wrong_value(child, fmt::format("whole numbers of blocks from 1 to {}", max_blocks));
  }
  return set.children;
}

StabilityAxis read_axis(const Node& table) {
  StabilityAxis axis;
  read_members(table, axis_keys, axis);
  if (axis.parameter.empty()) required(table, "values", "an array of numbers");
  return axis;
}

/// Runs of the baseline of Runge–Kutta, a row of the map each.
void add_baseline(const Node& steps, StabilityStudy& study) {
  for (const double step : numbers(steps)) {
    if (!(step > 0)) throw wrong_value(steps, "an array of steps > 0, s");
    study.suite.variants.push_back({Variant::Choice::rk4, step});
  }
}

/// The scene at each value of the axis.
std::vector<NamedScene> scenes_along(const Node& axis, const StabilityAxis& along,
                                     const std::filesystem::path& scene,
                                     const std::vector<std::string>& overrides) {
  if (!along.parameter.empty()) return {read_named_scene(scene, overrides)};
  const std::vector<Node>& set = read_set(axis, along.values.size());
  std::vector<NamedScene> scenes;
  for (std::size_t i = 0; i < along.values.size(); ++i) {
    std::vector<std::string> changes = overrides;
    std::size_t blocks = 0;
    for (const Node& key : set) {
      const double value = key.children[i].number;
      if (key.name == "blocks")
        blocks = static_cast<std::size_t>(value);
      else
        changes.push_back(fmt::format("{}={}", key.name, value));
    }
    scenes.push_back(read_named_scene(scene, changes));
    scenes.back().name += fmt::format("-{}", along.values[i]);
    if (blocks > 0) restack(blocks, scenes.back());
  }
  return scenes;
}

}  // namespace

const KeysOf<StabilityStudy> stability_keys{
    "",
    "a study of stability, which is run as a suite is: where do solvers stop being right?",
    {{"study", "\"stability\"", "", "\"stability\"", required_key, "what the file is"},
     {"title", "\"Heavy tops\"", "", "a text", required_key, "heads figures",
      part(&StabilityStudy::suite, &Suite::title)},
     {"scene", "\"scene.toml\"", "", "a file beside the study", required_key, "what is run"},
     {"set", "[\"duration=1.0\"]", "", "key=value texts", "[]", "scene keys that are changed at every value"},
     {{"rk4", "[1e-3]", "s", "numbers > 0", "[]",
       "steps of the Runge–Kutta baseline, as more rows of the map"},
      add_baseline},
     {"repeats", "1", "", whole_numbers(1), "timed runs after one to warm up",
      part(&StabilityStudy::suite, &Suite::repeats)},
     {"time_limit", "60.0", "s", numbers_above_zero(), "of each run of an engine",
      part(&StabilityStudy::suite, &Suite::limits, &Limits::time)},
     {"axis", "", "", "a table [axis]", required_key, "what varies along the map"},
     {"engines", "", "", "tables [[engines]], as in a suite", required_key, "rows of the map"},
     {{"draws", "", "", "a table [draws], as in a suite", no_default, "runs behind each number"},
      [](const Node& table, StabilityStudy& study) { study.suite.replicates = read_replicates(table); }}}};

const KeysOf<StabilityAxis> axis_keys{
    "[axis]",
    "what varies along the map: keys of the scene, or a parameter of the engines",
    {{"name", "\"height (m)\"", "", "a text", required_key, "of the axis", &StabilityAxis::name},
     {{"values", "[1.0, 2.0]", "", "at least one number", required_key, "places on the axis"},
      [](const Node& node, StabilityAxis& axis) {
        entries(node, "an array of at least one number");
        axis.values = numbers(node);
      }},
     {"set", "{ \"blocks.1.height\" = [1.0, 2.0] }", "", "scene keys, or blocks for their number",
      required_key, "an array for each key, one number for each place"},
     {"parameter", "\"erp\"", "", "a parameter with several values in every [[engines]]",
      "instead of values and set", "whose values are the places", &StabilityAxis::parameter}}};

StabilityStudy read_stability_study(const std::filesystem::path& file,
                                    const std::vector<std::string>& overrides) {
  const Node root = read_toml(file);
  StabilityStudy study;
  read_members(root, stability_keys, study);
  study.text = file_text(file);
  std::vector<std::string> changes;
  if (const Node* set = find(root, "set"))
    changes = mapped(entries(*set, "an array of key=value texts"), text);
  changes.insert(changes.end(), overrides.begin(), overrides.end());
  const Node& axis = required(root, "axis", "a table of name, values and set, or name and parameter");
  study.axis = read_axis(axis);
  if (const Node* steps = find(root, "rk4"); steps != nullptr && !study.axis.parameter.empty())
    throw wrong_value(*steps, "no key where engines' parameters vary");
  study.suite.scenes = scenes_along(
      axis, study.axis, named_file(required(root, "scene", "a scene file"), "scenes", file.parent_path()),
      changes);
  study.suite.series = read_engines(root, file.parent_path()).series;
  for (const EngineSeries& series : study.suite.series)
    if (!study.axis.parameter.empty() && !series.parameters.contains(study.axis.parameter))
      throw wrong_value(axis, fmt::format("about a parameter that {} has", series.engine->name));
  return study;
}

}  // namespace rockstack
