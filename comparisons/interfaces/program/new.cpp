#include <fmt/format.h>

#include "analytic/scene/ground/records/record_file.hpp"
#include "analytic/scene/input/scene_keys.hpp"
#include "analytic/scene/input/toml_reader.hpp"
#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/interfaces/program/record_limits.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/studies/sweep/ensemble.hpp"
#include "comparisons/suites/suite_keys.hpp"
#include "rockstack_commands_texts.hpp"

namespace rockstack {
namespace {

struct NewArguments {
  std::string kind = "scene";         ///< or "suite", "ensemble", "worker"
  std::optional<std::string> record;  ///< of a scene
  std::filesystem::path out;          ///< a file that is not there; empty: standard output
};

/// A table of a template with the values that differ from its examples.
struct Section {
  const KeyTable* table;
  std::map<std::string, std::string> values = {};  ///< empty: left out
  bool comment = false;                            ///< the whole table
};

/// The header of a table that is part of a scene in another file: "[[scene.blocks]]".
std::string header_in(const std::string& scene, std::string header) {
  if (header.empty()) return scene.empty() ? "" : "[" + scene + "]";
  if (!scene.empty()) header.insert(header.find_last_of('[') + 1, scene + ".");
  return header;
}

std::string comment_of(const InputKey& key) {
  std::string default_value;
  const std::string_view words = key.default_value;
  if (words != required_key) {
    const bool value = !words.starts_with("instead") && !words.starts_with(required_key);
    default_value = fmt::format(", {}{}", value ? "default " : "", words);
  }
  return fmt::format("{}: {}{}{}{}", key.meaning, key.unit, *key.unit != '\0' ? ", " : "", key.range,
                     default_value);
}

/// One line a key: required ones and those with a value as they are, others as comments.
std::string lines_of(const Section& section, const std::string& mark) {
  std::string text;
  for (const InputKey& key : section.table->keys) {
    const auto given = section.values.find(key.name);
    const std::string value = given != section.values.end() ? given->second : key.example;
    if (value.empty()) continue;
    const bool off = given == section.values.end() && std::string_view(key.default_value) != required_key;
    text += fmt::format("{}{:<38} # {}\n", off ? "" : mark,
                        fmt::format("{}{} = {}", off ? "# " : "", key.name, value), comment_of(key));
  }
  return text;
}

std::string text_of(const std::vector<Section>& sections, const std::string& scene = "") {
  std::string text;
  for (const Section& section : sections) {
    const std::string header = header_in(scene, section.table->header), mark = section.comment ? "# " : "";
    if (!text.empty()) text += "\n";
    if (!header.empty()) text += fmt::format("{}{:<38} # {}\n", mark, header, section.table->meaning);
    text += lines_of(section, mark);
  }
  return text;
}

/// The motion that a scene has, and the others as comments; with a record the scene lasts as long as it.
std::vector<Section> scene_sections(const std::optional<Record>& motion, const std::string& path,
                                    RecordLimits limits) {
  std::vector<Section> sections{{&scene_keys, {{"title", "\"A column\""}}}, {&block_keys}, {&block_keys}};
  sections[1].values = {{"width", "0.6"}, {"height", "1.6"}};
  sections[2].values = {{"width", "0.5"}, {"height", "1.2"}};
  if (motion) {
    const double length = motion->interval * static_cast<double>(motion->samples.size());
    sections[0].values["duration"] = fmt::format("{:.1f}", std::ceil(length) + 2);
    sections.push_back({&record_keys, {{"record", toml_text(path)}, {"scale", "1.0"}}});
    if (limits == RecordLimits::none) sections.back().values["limits"] = toml_text("none");
  } else {
    sections.push_back({&harmonic_keys, {{"amplitude", "9.0"}, {"period", "0.4"}}});
  }
  sections.push_back({&initial_keys, {{"angles", "[0.0, 0.0]"}, {"velocities", "[0.0, 0.0]"}}, true});
  for (const KeyTable* table : std::initializer_list<const KeyTable*>{
           &ground_keys, &contact_keys, &wall_keys, &push_keys, &tendon_keys, &damper_keys, &surface_keys})
    sections.push_back({table, {}, true});
  return sections;
}

std::string suite_text() {
  return text_of({{&suite_keys,
                   {{"title", "\"Two blocks\""}, {"scenes", "[\"spanos-free-rocking\"]"}, {"repeats", "1"}}},
                  {&engine_keys, {{"settings", "[\"tuned\"]"}, {"dt", "[1e-2, 1e-3]"}}},
                  {&replicates_keys},
                  {&perturbations_keys, {}, true},
                  {&print_keys, {}, true}});
}

std::string ensemble_text() {
  const std::string scene =
      text_of({{&scene_keys, {{"duration", "5.0"}}}, {&block_keys, {{"width", "0.5"}}}, {&harmonic_keys, {}}},
              "scene");
  return text_of({{&ensemble_keys, {{"scene", ""}}}}) + "\n" + scene + "\n" +
         text_of({{&vary_keys,
                   {{"key", "\"ground.horizontal.amplitude\""},
                    {"values", ""},
                    {"range", "{ from = 1.0, to = 12.0, count = 12 }"}}},
                  {&vary_keys, {{"key", "\"ground.horizontal.period\""}, {"values", "[0.5, 0.7, 1.0]"}}},
                  {&summary_keys, {{"intensity", "\"ground.horizontal.amplitude\""}}}});
}

/// A commented file of a kind to begin with. Of a worker: one in Python that answers. Input files are made of
/// the keys that their reader takes: they are accepted as they stand, and what may be left out is there as
/// comments. A scene with a record has that record, as a path from the file,
/// for its ground motion. @throws InputError where the record cannot be read.
std::string template_text(const NewArguments& arguments, const Common& common) {
  const std::string& kind = arguments.kind;
  if (arguments.record && kind != "scene")
    throw InputError(fmt::format("--record {}: must be left out of a {}", *arguments.record, kind));
  if (!arguments.record) refuse_overrides(common, "a template is edited");
  if (kind == "suite") return suite_text();
  if (kind == "ensemble") return ensemble_text();
  if (kind == "worker") return std::string(moreau_jean_py);
  if (!arguments.record) return text_of(scene_sections(std::nullopt, "", RecordLimits::usual));
  const RecordLimits limits = record_limits(common);
  const Record motion = read_record(*arguments.record, limits);
  const std::filesystem::path folder = arguments.out.parent_path();
  const auto path = std::filesystem::proximate(*arguments.record, folder.empty() ? "." : folder).string();
  return fmt::format("# {}: {}\n", one_line(path), one_line(description(motion))) +
         text_of(scene_sections(motion, path, limits));
}

int run_new(const NewArguments& arguments, const Common& common) {
  std::error_code ignored;
  if (!arguments.out.empty() && std::filesystem::exists(arguments.out, ignored))
    throw InputError(fmt::format("--out {}: must be a new file, this one is there", arguments.out.string()));
  const std::string text = template_text(arguments, common);
  if (arguments.out.empty()) {
    fmt::print("{}", text);
    return 0;
  }
  try {
    write_file(arguments.out, text);
    using std::filesystem::perms, std::filesystem::perm_options;
    if (arguments.kind == "worker")
      permissions(arguments.out, perms::owner_exec | perms::group_exec | perms::others_exec,
                  perm_options::add);
  } catch (const std::runtime_error&) {
    throw InputError(fmt::format("--out {}: must be a file that can be written, in a folder that is there",
                                 arguments.out.string()));
  }
  if (!common.quiet) {
    fmt::print("{}: {}\n", arguments.kind, one_line(arguments.out.string()));
    if (arguments.record) fmt::print("record: {}\n", text.substr(2, text.find('\n') - 2));
  }
  return 0;
}

void add_new(CLI::App& command, NewArguments& arguments) {
  command.add_option("kind", arguments.kind, "scene, suite, ensemble or worker: an engine in Python")
      ->check(one_of({"scene", "suite", "ensemble", "worker"}))
      ->capture_default_str();
  command.add_option("--record", arguments.record, "record that shakes the scene");
  command.add_option("--out", arguments.out, "new file to write; left out: standard output");
}

}  // namespace

Command new_command() {
  return make_command("new", "print a commented file to begin with", add_new, run_new);
}

}  // namespace rockstack
