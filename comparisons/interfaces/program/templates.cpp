#include "comparisons/interfaces/program/templates.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <string_view>
#include <vector>

#include "analytic/scene/ground/records/record_file.hpp"
#include "analytic/scene/input/document.hpp"
#include "analytic/scene/input/scene_keys.hpp"
#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/studies/sweep/ensemble_keys.hpp"
#include "comparisons/suites/suite_keys.hpp"

namespace rockstack {
namespace {

/// A table of a template with the values that differ from its examples.
struct Part {
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
  std::string standard;
  const std::string_view words = key.standard;
  if (words != required_key) {
    const bool value = !words.starts_with("instead") && !words.starts_with(required_key);
    standard = fmt::format(", {}{}", value ? "default " : "", words);
  }
  return fmt::format("{}: {}{}{}{}", key.meaning, key.unit, *key.unit != '\0' ? ", " : "", key.range,
                     standard);
}

/// One line a key: required ones and those with a value as they are, others as comments.
std::string lines_of(const Part& part) {
  std::string text;
  for (const InputKey& key : part.table->keys) {
    const auto given = part.values.find(key.name);
    const std::string value = given != part.values.end() ? given->second : key.example;
    if (value.empty()) continue;
    const bool off = given == part.values.end() && std::string_view(key.standard) != required_key;
    text += fmt::format("{:<38} # {}\n", fmt::format("{}{} = {}", off ? "# " : "", key.name, value),
                        comment_of(key));
  }
  return text;
}

std::string commented(const std::string& text) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin) + 1;
    const std::string line = text.substr(begin, end - begin);
    result += (line.starts_with('#') || line == "\n" ? "" : "# ") + line;
    begin = end;
  }
  return result;
}

std::string text_of(const std::vector<Part>& parts, const std::string& scene = "") {
  std::string text;
  for (const Part& part : parts) {
    const std::string header = header_in(scene, part.table->header);
    const std::string table =
        (header.empty() ? "" : fmt::format("{:<38} # {}\n", header, part.table->meaning)) + lines_of(part);
    text += (text.empty() ? "" : "\n") + (part.comment ? commented(table) : table);
  }
  return text;
}

/// The motion that a scene has, and the others as comments; with a record the scene lasts as long as it.
std::vector<Part> scene_parts(const std::optional<std::filesystem::path>& record,
                              const std::filesystem::path& folder) {
  std::vector<Part> parts{{&scene_keys, {{"title", "\"A column\""}}}, {&block_keys}, {&block_keys}};
  parts[1].values = {{"width", "0.6"}, {"height", "1.6"}};
  parts[2].values = {{"width", "0.5"}, {"height", "1.2"}};
  if (!record) {
    parts.push_back({&harmonic_keys, {{"amplitude", "9.0"}, {"period", "0.4"}}});
    parts.push_back({&initial_keys, {{"angles", "[0.0, 0.0]"}, {"velocities", "[0.0, 0.0]"}}, true});
    parts.push_back({&surface_keys, {}, true});
    return parts;
  }
  const Record motion = read_record(*record);
  const double length = motion.interval * static_cast<double>(motion.samples.size());
  parts[0].values["duration"] = fmt::format("{:.1f}", std::ceil(length) + 2);
  const std::string path = std::filesystem::proximate(*record, folder).string();
  parts.push_back({&record_keys, {{"record", toml_text(path)}, {"scale", "1.0"}}});
  parts.push_back({&surface_keys, {}, true});
  return parts;
}

std::string suite_text() {
  return text_of({{&suite_keys,
                   {{"title", "\"Two blocks\""}, {"scenes", "[\"spanos-free-rocking\"]"}, {"repeats", "1"}}},
                  {&engine_keys, {{"settings", "[\"tuned\"]"}, {"dt", "[1e-2, 1e-3]"}}},
                  {&draws_keys},
                  {&perturbations_keys, {}, true}});
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

}  // namespace

std::string template_text(const std::string& kind, const std::optional<std::filesystem::path>& record,
                          const std::filesystem::path& folder) {
  if (record && kind != "scene")
    throw InputError(fmt::format("--record {}: must be left out of a {}", record->string(), kind));
  if (kind == "suite") return suite_text();
  if (kind == "ensemble") return ensemble_text();
  return text_of(scene_parts(record, folder));
}

}  // namespace rockstack
