#include <fmt/format.h>

#include "analytic/scene/input/toml_reader.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/suites/shipped.hpp"
#include "comparisons/suites/suite_keys.hpp"

namespace rockstack {
namespace {

std::uint64_t mebibytes(const Node& node) {
  if (!(number(node) >= 64 && node.number <= 1e9)) throw wrong_value(node, "a number of MiB from 64 to 1e9");
  return static_cast<std::uint64_t>(node.number * 1048576);
}

constexpr std::string_view friction_key = "friction=";

/// Names of Variant::Choice; a suite may ask for the first.
constexpr std::array variant_names{"linear",     "nonlinear", "paper", "consistent",
                                   "unilateral", "",          "rk4",   "measured"};
constexpr std::array asked_variants{variant_names[0], variant_names[1], variant_names[2], variant_names[3],
                                    variant_names[4]};

Variant read_variant(const Node& node) {
  if (node.kind != Node::Kind::text || !node.text.starts_with(friction_key))
    return {choice<Variant::Choice>(node, asked_variants)};
  const auto friction = number_in(std::string_view(node.text).substr(friction_key.size()));
  if (!friction || !(*friction >= 0 && *friction <= largest_friction))
    throw wrong_value(node, fmt::format("{}MU with a number from 0 to {}", friction_key, largest_friction));
  return {Variant::Choice::friction, 0, *friction};
}

std::vector<Variant> read_variants(const Node& array) {
  if (array.kind != Node::Kind::array) throw wrong_value(array, "an array of names, e.g. [\"linear\"]");
  std::vector<Variant> variants;
  for (const Node& child : array.children) {
    const Variant variant = read_variant(child);
    if (std::ranges::find(variants, variant) != variants.end()) throw wrong_value(child, "named once");
    variants.push_back(variant);
  }
  return variants;
}

constexpr std::initializer_list<std::pair<const char*, bool ResultSelection::*>> result_names{
    {"angles", &ResultSelection::angles},       {"impacts", &ResultSelection::impacts},
    {"patterns", &ResultSelection::patterns},   {"bodies", &ResultSelection::bodies},
    {"histories", &ResultSelection::histories}, {"forces", &ResultSelection::forces}};

ResultSelection read_results(const Node& array) {
  ResultSelection wanted{false, false, false, false, false, false};
  for (const Node& child : entries(array, "an array of at least one name, e.g. [\"angles\"]")) {
    bool& one = wanted.*choice<bool ResultSelection::*>(child, result_names);
    if (one) throw wrong_value(child, "named once");
    one = true;
  }
  return wanted;
}

/// `of "a", "b"`, in the words of a key.
template <class Names>
std::string some_of(const Names& names) {
  return "of " + joined_texts(names, quoted, ", ");
}

/// Changes of a scene, and what they add to its name and title.
struct SceneChange {
  std::string name, title;
  std::vector<std::pair<std::string, std::string>>
      overrides;  ///< with the places of those in the suite's file
};

/// An error of one of them names where it stands in the suite.
NamedScene read_changed_scene(const std::filesystem::path& file, const SceneChange& change) {
  try {
    return read_named_scene(file, mapped(change.overrides, [](const auto& one) { return one.first; }));
  } catch (const InputError& error) {
    const std::string message = error.what();
    for (const auto& [text, place] : change.overrides)
      if (const std::string named = "--set " + text + ": "; !place.empty() && message.starts_with(named))
        throw InputError(place + ": " + message.substr(named.size()));
    throw;
  }
}

/// Every combination of the values of `vary`, after the changes that all scenes have.
std::vector<SceneChange> read_vary(const Node& root, SceneChange changes) {
  std::vector<SceneChange> list{std::move(changes)};
  const Node* table = find(root, "vary");
  if (table == nullptr) return list;
  if (table->kind != Node::Kind::table)
    throw wrong_value(*table, "a table of scene keys, each an array of numbers");
  for (const Node& child : table->children) {
    std::vector<SceneChange> extended;
    for (const Node& value : entries(child, "an array of numbers")) {
      const std::string text = fmt::format("{}", number(value));
      for (SceneChange change : list) {
        const std::string key = child.name.substr(child.name.rfind('.') + 1);
        change.name += fmt::format("-{}-{}", key, text);
        change.title += fmt::format(", {} {}", key, text);
        change.overrides.emplace_back(child.name + "=" + text, value.place);
        extended.push_back(std::move(change));
      }
    }
    list = std::move(extended);
  }
  return list;
}

/// The name of a scene that may stand for one of the paper's.
std::string paper_scene(const Node& node, const Suite& suite) {
  for (const NamedScene& named : suite.scenes)
    if (named.name == text(node) && named.scene.blocks.size() == 2) return node.text;
  throw wrong_value(node, "the name of a scene of the suite with two blocks");
}

void read_statements(const Node& table, Suite& suite) {
  require_table(table, statements_keys);
  for (const InputKey& key : statements_keys.keys) required(table, key.name, key.range);
  suite.statements.emplace();
  read_members(table, statements_keys, suite);
}

constexpr const char* trajectory_files = "an array of at least one CSV file";

/// The series that the tables [[trajectories]] ask for.
std::vector<EngineSeries> read_trajectories(const Node& array, const Suite& suite,
                                            const std::filesystem::path& folder) {
  std::vector<EngineSeries> list;
  for (const Node& table : entries(array, "an array of tables")) {
    TrajectoryTable asked;
    read_members(table, trajectory_keys, asked);
    const Node& name = required(table, "name", "a text");
    const Node* scene = asked.scene;
    const auto of = std::ranges::find_if(suite.scenes, [&](const NamedScene& one) {
      return scene == nullptr ? suite.scenes.size() == 1 : one.name == text(*scene);
    });
    if (of == suite.scenes.end()) {
      if (scene == nullptr) required(table, "scene", "the name of a scene of the suite, which has several");
      throw wrong_value(*scene, "the name of a scene of the suite");
    }
    required(table, "files", trajectory_files);
    for (std::filesystem::path& file : asked.named.files) file = folder / file;
    list.push_back(trajectory_series(asked.named, *of, name.place));
    for (std::size_t i = 0; i + 1 < list.size(); ++i)
      if (list[i].engine->name == text(name) && list[i].files->scene == of->name)
        throw wrong_value(name, "one that no other trajectory of the scene has");
  }
  return list;
}

/// Refuses what is of engines alone where there are none.
void require_engines(const Node& root) {
  if (find(root, "engines") != nullptr) return;
  for (const char* key : {"softness", "time_limit", "memory_limit"})
    if (const Node* node = find(root, key))
      throw wrong_value(*node, "left out where there are no [[engines]]: it is of their runs");
}

}  // namespace

const KeysOf<Suite> suite_keys{
    "",
    "a suite: scenes, each on the exact solver and on engines",
    {{"title", "\"Three drums\"", "", "a text", required_key, "heads tables and the report", &Suite::title},
     {"scenes", "[\"scene.toml\"]", "",
      "at least one file beside the suite, or name from `rockstack list scenes`", required_key,
      "what is run"},
     {"set", "[\"duration=2.0\"]", "", "key=value texts", "[]", "scene keys that are changed in every scene"},
     {"vary", "{ \"contact.friction\" = [0.1, 1.0] }", "", "scene keys, each an array of numbers", "{}",
      "every scene once for each value, in every combination"},
     {{"variants", "[\"linear\"]", "", fmt::format("{}, \"{}MU\"", some_of(asked_variants), friction_key),
       "[]", "the exact solver with one choice changed, as one more run; friction is that of law unilateral"},
      [](const Node& node, Suite& suite) { suite.variants = read_variants(node); }},
     {"tolerance", "0.01", "rad", numbers_above_zero(), "histories agree as long as angles stay that close",
      &Suite::tolerance},
     {"repeats", "5", "", whole_numbers(1), "timed runs after one to warm up", &Suite::repeats},
     {{"results", "[\"angles\", \"impacts\"]", "",
       some_of(mapped(result_names, [](const auto& one) { return std::string(one.first); })),
       "all but \"forces\"", "what is computed and written"},
      [](const Node& node, Suite& suite) { suite.wanted = read_results(node); }},
     {{"softness", "\"split\"", "", "\"whole\" or \"split\", which needs \"bodies\" in `results`",
       "\"whole\"",
       "whether differences of engines are split into contact model, contact softness and time step"},
      [](const Node& node, Suite& suite) {
        suite.softness = choice<bool>(node, {{"whole", false}, {"split", true}});
      }},
     {"time_limit", "600.0", "s", numbers_above_zero(), "of each run of an engine",
      part(&Suite::limits, &Limits::time)},
     {{"memory_limit", "4096", "MiB", "64 to 10⁹", "4096", "of each run of an engine"},
      [](const Node& node, Suite& suite) { suite.limits.memory = mebibytes(node); }},
     {"engines", "", "", "tables [[engines]]", "none: exact runs alone",
      "what is compared with the exact solver"},
     {"trajectories", "", "", "tables [[trajectories]]", "none", "motions that other programs have written"},
     {{"draws", "", "", "a table [draws]", no_default, "runs behind each number of an engine"},
      [](const Node& table, Suite& suite) { suite.replicates = read_replicates(table); }},
     {{"perturbations", "", "", "a table [perturbations]", no_default, "distributions where histories part"},
      [](const Node& table, Suite& suite) { suite.perturbations = read_perturbations(table); }},
     {{"figures", "", "", "a table [figures]", no_default, "figures for print, beside those of the report"},
      [](const Node& table, Suite& suite) {
        read_print_style(table);
        suite.print = style_text(table);
      }},
     {"statements", "", "", "a table [statements]", no_default, "scenes held against the paper"}}};

const KeysOf<TrajectoryTable> trajectory_keys{
    "[[trajectories]]",
    "a motion of a scene that another program has written, beside the engines",
    {{"name", "\"isaac\"", "", "letters, digits, - and _, no engine's name", required_key,
      "that its rows go by", part(&TrajectoryTable::named, &NamedTrajectory::name)},
     {{"files", "[\"isaac.csv\"]", "", "at least one CSV file, seen from the suite's folder", required_key,
       "a run each, see comparisons/README.md; several are replicates"},
      [](const Node& node, TrajectoryTable& asked) {
        for (const Node& file : entries(node, trajectory_files)) asked.named.files.emplace_back(text(file));
      }},
     {{"scene", "\"scene\"", "", "the name of a scene of the suite", "its only scene", "of which it is"},
      [](const Node& node, TrajectoryTable& asked) { asked.scene = &node; }}}};

const KeysOf<Suite> statements_keys{
    "[statements]",
    "the paper's two examples among the scenes, each of two blocks",
    {{{"free", "\"scene\"", "", "the name of a scene of the suite", required_key, "of Figs. 18 to 20"},
      [](const Node& node, Suite& suite) { suite.statements->free = paper_scene(node, suite); }},
     {{"shaken", "\"scene\"", "", "the name of a scene of the suite", required_key, "of Figs. 21 and 22"},
      [](const Node& node, Suite& suite) { suite.statements->shaken = paper_scene(node, suite); }}}};

Scene Variant::apply(Scene scene) const {
  if (choice == Choice::linear) scene.equations = Equations::linear;
  if (choice == Choice::nonlinear) scene.equations = Equations::nonlinear;
  if (choice == Choice::paper) scene.law = Law::paper;
  if (choice == Choice::consistent) scene.law = Law::consistent;
  if (choice == Choice::unilateral || choice == Choice::friction) scene.law = Law::unilateral;
  if (scene.law != Law::unilateral) {
    scene.point_restitution = 0;
    scene.kinetic_friction.clear();
  }
  if (scene.law != Law::compliant) {
    scene.springs = {};
    scene.initial.preloaded = true;
  }
  if (choice == Choice::friction) {
    scene.friction.assign(scene.blocks.size(), friction);
    scene.kinetic_friction.clear();
  }
  return scene;
}

std::string Variant::name() const {
  if (choice == Choice::friction) return fmt::format("{}{}", friction_key, friction);
  return variant_names.at(static_cast<std::size_t>(choice));
}

std::vector<std::string> names_of(const ResultSelection& wanted) {
  std::vector<std::string> names;
  for (const auto& [name, field] : result_names)
    if (wanted.*field) names.emplace_back(name);
  return names;
}

InputKind kind_of(const std::filesystem::path& file) {
  const Node root = read_toml(file);
  if (const Node* study = find(root, "study"))
    return study->text == "stability" ? InputKind::stability_study : InputKind::impact_law_study;
  if (find(root, "scene") != nullptr) return InputKind::ensemble;
  const bool suite = std::ranges::any_of(suite_keys.keys, [&](const InputKey& key) {
    return find(root, key.name) != nullptr && std::string_view(key.name) != "title";
  });
  return suite ? InputKind::suite : InputKind::scene;
}

Suite read_suite(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  const Node root = read_toml(file);
  Suite suite;
  read_members(root, suite_keys, suite);
  SceneChange changes;
  if (const Node* node = find(root, "set"))
    for (const Node& child : entries(*node, "an array of key=value texts"))
      changes.overrides.emplace_back(text(child), child.place);
  for (const std::string& text : overrides) changes.overrides.emplace_back(text, "");
  const std::vector<SceneChange> list = read_vary(root, std::move(changes));
  const char* scenes = "an array of at least one scene file";
  for (const Node& scene : entries(required(root, "scenes", scenes), scenes)) {
    const std::filesystem::path scene_file = named_file(scene, "scenes", file.parent_path());
    for (const SceneChange& change : list) {
      NamedScene& added = suite.scenes.emplace_back(read_changed_scene(scene_file, change));
      added.name = folder_name(added.name + change.name);
      added.scene.title += change.title;
    }
  }
  if (suite.softness && !suite.wanted.bodies)
    throw wrong_value(*find(root, "softness"),
                      "\"whole\" where `results` leaves out \"bodies\", which tell contacts");
  AskedEngines engines = read_engines(root, file.parent_path());
  suite.series = std::move(engines.series);
  suite.left_out = std::move(engines.left_out);
  if (const Node* array = find(root, "trajectories"))
    std::ranges::move(read_trajectories(*array, suite, file.parent_path()), std::back_inserter(suite.series));
  if (const Node* table = find(root, "statements")) read_statements(*table, suite);
  require_engines(root);
  return suite;
}

}  // namespace rockstack
