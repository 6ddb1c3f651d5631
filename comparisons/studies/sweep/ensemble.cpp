#include "comparisons/studies/sweep/ensemble.hpp"

#include <algorithm>

#include "analytic/scene/input/toml_reader.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/build.hpp"

namespace rockstack {
namespace {

Value drawn_value(const Variation& variation, const DrawIndex& index) {
  Value value;
  value.node.kind = Node::Kind::number;
  value.node.place = variation.place;
  value.node.number = draw(*variation.distribution, index);
  value.text = number_text(value.node.number);
  return value;
}

void describe(const Node& node, std::string& text) {
  text +=
      node.name + "=" + std::to_string(static_cast<int>(node.kind)) + number_text(node.number) + node.text;
  text += "{";
  for (const Node& child : node.children) describe(child, text);
  text += "}\n";
}

void describe_record(const std::filesystem::path& name, MotionLibrary& library, std::string& text) {
  const auto motion = library.record(name);
  text += number_text(motion->interval);
  for (const double sample : motion->samples) text += " " + number_text(sample);
  text += "\n";
}

/// The records that the base scene names.
void describe_records(const SceneDocument& document, MotionLibrary& library, std::string& text) {
  for (const char* key : {"ground.horizontal.record", "ground.vertical.record"}) {
    const Node& node = nearest(document.root, key);
    if (node.name == "record" && node.kind == Node::Kind::text) {
      describe_record(document.folder / node.text, library, text);
    }
  }
}

}  // namespace

bool Variation::is_record(const Value& value) const {
  return value.node.kind == Node::Kind::text &&
         std::any_of(keys.begin(), keys.end(),
                     [](const std::string& key) { return key.ends_with(".record"); });
}

std::size_t run_count(const Ensemble& ensemble) {
  std::size_t count = ensemble.samples;
  for (const Axis& axis : ensemble.axes) count *= axis.length;
  return count;
}

std::vector<Value> values_of(const Ensemble& ensemble, std::size_t run) {
  std::vector<Value> values(ensemble.variations.size());
  std::size_t point = run / ensemble.samples;
  for (auto axis = ensemble.axes.rbegin(); axis != ensemble.axes.rend(); ++axis) {
    for (const std::size_t v : axis->variations) {
      values[v] = ensemble.variations[v].values[point % axis->length];
    }
    point /= axis->length;
  }
  for (std::size_t v = 0; v < values.size(); ++v) {
    const Variation& variation = ensemble.variations[v];
    if (!variation.distribution) continue;
    values[v] = drawn_value(variation, {ensemble.seed, run, static_cast<std::uint32_t>(v)});
  }
  return values;
}

void set_values(SceneDocument& document, const Variation& variation, const Value& value) {
  for (const std::string& key : variation.keys) set_value(document.root, key, value.node);
}

std::string identity(const Ensemble& ensemble, MotionLibrary& library) {
  std::string text = std::string(build::version) + "\n" + build::compiler + "\n" + build::flags + "\n";
  describe(ensemble.base.root, text);
  describe_records(ensemble.base, library, text);
  text += std::to_string(ensemble.samples) + " " + std::to_string(ensemble.seed) + " " +
          number_text(ensemble.tolerance) + "\n";
  for (const Variation& variation : ensemble.variations) {
    for (const std::string& key : variation.keys) text += key + "\n";
    for (const Value& value : variation.values) {
      text += value.text + "\n";
      if (variation.is_record(value)) {
        describe_record(ensemble.base.folder / value.node.text, library, text);
      }
    }
    if (const auto& drawn = variation.distribution) {
      text += std::to_string(static_cast<int>(drawn->kind)) + " " + number_text(drawn->first) + " " +
              number_text(drawn->second) + "\n";
    }
  }
  for (const Axis& axis : ensemble.axes) {
    for (const std::size_t v : axis.variations) text += std::to_string(v) + " ";
    text += "\n";
  }
  return text;
}

}  // namespace rockstack
