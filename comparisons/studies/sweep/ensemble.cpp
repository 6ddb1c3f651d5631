#include "comparisons/studies/sweep/ensemble.hpp"

#include "analytic/scene/input/page_scene.hpp"
#include "analytic/scene/input/toml_reader.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/build.hpp"
#include "comparisons/measures/statistics/latin_hypercube.hpp"

namespace rockstack {
namespace {

// Places in a sample of Saltelli's design: A comes first.
constexpr std::size_t matrix_b = 1, first_exchanged = 2;

/// A sample's draw with that number: those of B have the numbers of the variations behind those of A.
double draw_of(const Ensemble& ensemble, std::size_t sample, std::size_t number) {
  const Distribution& distribution = *ensemble.variations[number % ensemble.variations.size()].distribution;
  const DrawIndex index{ensemble.seed, sample, static_cast<std::uint32_t>(number)};
  return ensemble.sampling == Sampling::latin_hypercube ? latin_draw(distribution, index, ensemble.samples)
                                                        : draw(distribution, index);
}

void describe_record(const std::filesystem::path& name, MotionLibrary& library, std::string& text) {
  const auto motion = library.record(name);
  text += number_text(motion->interval);
  for (const double sample : motion->samples) text += " " + number_text(sample);
  text += "\n";
}

}  // namespace

std::size_t run_count(const Ensemble& ensemble) {
  std::size_t count = ensemble.samples * sample_size(ensemble);
  for (const Axis& axis : ensemble.axes) count *= axis.length;
  return count;
}

std::size_t block_count(const Ensemble& ensemble) {
  return find(ensemble.base.root, "blocks")->children.size();
}

std::size_t sample_size(const Ensemble& ensemble) {
  if (ensemble.summary.indices.empty()) return 1;
  const auto drawn = std::ranges::count_if(ensemble.variations, &Variation::is_drawn);
  return first_exchanged + static_cast<std::size_t>(drawn);
}

std::string matrix_of(const Ensemble& ensemble, std::size_t run) {
  std::vector<std::string> matrices{"A", "B"};
  for (const Variation& variation : ensemble.variations)
    if (variation.is_drawn()) matrices.push_back(variation.name());
  return matrices.at(run % sample_size(ensemble));
}

std::vector<Value> values_of(const Ensemble& ensemble, std::size_t run) {
  std::vector<Value> values(ensemble.variations.size());
  const std::size_t sample = run / sample_size(ensemble), place = run % sample_size(ensemble);
  std::size_t point = sample / ensemble.samples;
  for (auto axis = ensemble.axes.rbegin(); axis != ensemble.axes.rend(); ++axis) {
    for (const std::size_t v : axis->variations)
      values[v] = ensemble.variations[v].values[point % axis->length];
    point /= axis->length;
  }
  std::size_t exchanged = first_exchanged;
  for (std::size_t v = 0; v < values.size(); ++v) {
    const Variation& variation = ensemble.variations[v];
    if (!variation.is_drawn()) continue;
    const bool is_of_b = place == matrix_b || place == exchanged++;
    values[v] = drawn_value(variation, draw_of(ensemble, sample, is_of_b ? v + values.size() : v));
  }
  return values;
}

void set_values(SceneDocument& document, const Variation& variation, const Value& value) {
  for (const std::string& key : variation.keys) set_value(document.root, key, value.node);
}

std::string identity(const Ensemble& ensemble, MotionLibrary& library) {
  std::string text = std::string(build::version) + "\n" + build::compiler + "\n" + build::flags + "\n";
  text += page_scene(ensemble.base.root).dump() + "\n";
  for (const char* key : {"ground.horizontal.record", "ground.vertical.record"}) {
    const Node& node = nearest(ensemble.base.root, key);
    if (node.name == "record" && node.kind == Node::Kind::text)
      describe_record(ensemble.base.folder / node.text, library, text);
  }
  text += std::to_string(ensemble.samples) + " " + std::to_string(ensemble.seed) + " " +
          number_text(ensemble.tolerance) + (ensemble.demands ? "\n" : " without demands\n");
  if (ensemble.sampling == Sampling::latin_hypercube) text += "Latin hypercube\n";
  if (!ensemble.summary.indices.empty()) text += "Saltelli's design\n";
  for (const Variation& variation : ensemble.variations) {
    text += json_of(variation).dump() + "\n";
    for (const Value& value : variation.values)
      if (is_record(variation, value)) describe_record(ensemble.base.folder / value.node.text, library, text);
  }
  for (const Axis& axis : ensemble.axes) text += Json(axis.variations).dump() + "\n";
  return text;
}

SceneDocument typical_document(const Ensemble& ensemble) {
  SceneDocument document = ensemble.base;
  for (const Variation& variation : ensemble.variations)
    set_values(document, variation, typical_value(variation));
  return document;
}

}  // namespace rockstack
