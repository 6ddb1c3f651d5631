#include "comparisons/suite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "analytic/scene/fields.hpp"
#include "analytic/scene/scene_file.hpp"
#include "analytic/scene/toml_reader.hpp"

namespace rockstack {
namespace {

const std::vector<double> default_steps{1e-2, 1e-3, 1e-4};

bool left_out(const std::string& name) {
  const auto missing = engines_left_out();
  return std::any_of(missing.begin(), missing.end(), [&](const std::string& engine) {
    return name == engine || name.starts_with(engine + ":");
  });
}

double positive(const Node& node) {
  if (!(number(node) > 0)) throw wrong_value(node, "a number > 0");
  return node.number;
}

std::vector<double> read_steps(const Node& table) {
  const Node* node = find(table, "dt");
  if (node == nullptr) return default_steps;
  std::vector<double> steps = numbers(*node);
  for (const Node& child : node->children) positive(child);
  return steps;
}

std::vector<std::string> read_settings(const Node& table) {
  const Node* node = find(table, "settings");
  if (node == nullptr) return {"default", "tuned"};
  if (node->kind != Node::Kind::array) throw wrong_value(*node, "an array of \"default\" and \"tuned\"");
  std::vector<std::string> settings;
  for (const Node& child : node->children) {
    settings.push_back(choice<std::string>(child, {{"default", "default"}, {"tuned", "tuned"}}));
  }
  return settings;
}

std::vector<Variant> read_variants(const Node& array) {
  if (array.kind != Node::Kind::array) throw wrong_value(array, "an array of names, e.g. [\"linear\"]");
  std::vector<Variant> variants;
  for (const Node& child : array.children) {
    variants.push_back({choice<std::string>(child, {{"linear", "linear"},
                                                    {"nonlinear", "nonlinear"},
                                                    {"paper", "paper"},
                                                    {"consistent", "consistent"}})});
  }
  return variants;
}

const Engine& read_engine(const Node& name) {
  try {
    return find_engine(text(name));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", name.place, error.what()));
  }
}

std::vector<EngineSeries> read_series(const Node& table) {
  require_table(table, {"name", "settings", "dt"});
  const Node& name = required(table, "name", "an engine, e.g. \"bullet\"");
  if (left_out(text(name))) return {};
  const Engine& engine = read_engine(name);
  std::vector<EngineSeries> list;
  for (const std::string& settings : read_settings(table)) {
    list.push_back(make_series(engine, settings, read_steps(table)));
  }
  return list;
}

}  // namespace

Scene Variant::apply(Scene scene) const {
  if (name == "linear") scene.equations = Equations::linear;
  if (name == "nonlinear") scene.equations = Equations::nonlinear;
  if (name == "paper") scene.law = Law::paper;
  if (name == "consistent") scene.law = Law::consistent;
  return scene;
}

EngineSeries make_series(const Engine& engine, const std::string& settings, std::vector<double> steps) {
  return {&engine, settings, settings == "tuned" ? engine.tuned_parameters() : engine.default_parameters(),
          std::move(steps)};
}

NamedScene read_named_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  Scene scene = read_scene(file, overrides);
  std::ifstream stream(file, std::ios::binary);
  return {file.stem().string(), {std::istreambuf_iterator<char>(stream), {}}, std::move(scene)};
}

bool is_suite(const std::filesystem::path& file) {
  return find(read_toml(file), "scenes") != nullptr;
}

Suite read_suite(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  const Node root = read_toml(file);
  require_table(root, {"title", "scenes", "variants", "engines", "exact_step", "tolerance", "repeats"});
  Suite suite;
  suite.title = text(required(root, "title", "a text"));
  for (const Node& scene : required(root, "scenes", "an array of scene files").children) {
    suite.scenes.push_back(read_named_scene(file.parent_path() / text(scene), overrides));
  }
  if (suite.scenes.empty()) throw wrong_value(*find(root, "scenes"), "an array of at least one scene file");
  if (const Node* node = find(root, "exact_step")) suite.exact_step = positive(*node);
  if (const Node* node = find(root, "tolerance")) suite.tolerance = positive(*node);
  if (const Node* node = find(root, "repeats")) {
    suite.repeats = static_cast<int>(number(*node));
    if (suite.repeats != number(*node) || suite.repeats < 1) throw wrong_value(*node, "a whole number ≥ 1");
  }
  if (const Node* variants = find(root, "variants")) suite.variants = read_variants(*variants);
  if (const Node* engines = find(root, "engines")) {
    for (const Node& table : engines->children) {
      for (EngineSeries& series : read_series(table)) suite.series.push_back(std::move(series));
    }
  }
  return suite;
}

Suite suite_for(NamedScene scene) {
  Suite suite;
  suite.title = scene.scene.title;
  suite.scenes.push_back(std::move(scene));
  for (const auto& engine : engines()) {
    for (const char* settings : {"default", "tuned"}) {
      suite.series.push_back(make_series(*engine, settings, default_steps));
    }
  }
  return suite;
}

}  // namespace rockstack
