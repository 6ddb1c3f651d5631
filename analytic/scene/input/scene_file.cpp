#include "analytic/scene/input/scene_file.hpp"

#include "analytic/scene/ground/records/record_file.hpp"
#include "analytic/scene/input/applied_forces_file.hpp"
#include "analytic/scene/input/scene_keys.hpp"
#include "analytic/scene/input/toml_reader.hpp"
#include "analytic/scene/messages/number_text.hpp"

namespace rockstack {
namespace {

/// The part of a record between two of its times, where a scene asks for one.
void take_part(GroundMotion& motion, const Node& table) {
  const auto sample_at = [&](const char* key, std::size_t otherwise) {
    const Node* node = find(table, key);
    if (node == nullptr) return otherwise;
    const double sample = std::round(number(*node) / motion.interval);
    const auto last = static_cast<double>(motion.samples.size() - 1);
    if (!(sample >= 0 && sample <= last))
      throw wrong_value(*node,
                        "a time of the record, from 0 to " + number_text(last * motion.interval) + " s");
    return static_cast<std::size_t>(sample);
  };
  const std::size_t first = sample_at("from", 0), last = sample_at("to", motion.samples.size() - 1);
  if (first == 0 && last == motion.samples.size() - 1) return;
  if (first >= last) {
    const Node* to = find(table, "to");
    throw to != nullptr ? wrong_value(*to, "later than where the motion begins")
                        : wrong_value(*find(table, "from"), "before the record's end");
  }
  motion.samples = {motion.samples.begin() + static_cast<std::ptrdiff_t>(first),
                    motion.samples.begin() + static_cast<std::ptrdiff_t>(last + 1)};
  const auto time = [&](std::size_t sample) {
    return number_text(static_cast<double>(sample) * motion.interval);
  };
  motion.source += ", from " + time(first) + " s to " + time(last) + " s";
}

GroundMotion from_record(const Node& table, const Node& node, const std::filesystem::path& folder,
                         MotionLibrary& library) {
  require_table(table, record_keys);
  const std::filesystem::path name = folder / text(node);
  const std::filesystem::path file = record_file(name);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored))
    throw wrong_value(node, "a record's file, none is at " + one_line(file.string()));
  GroundMotion motion = *library.record(name);
  const Node* limits = find(table, "limits");
  if (limits == nullptr || choice<RecordLimits>(*limits, {"usual", "none"}) == RecordLimits::usual)
    check_usual(file.string(), motion.source, motion.interval, motion.samples);
  motion.source = node.text + " (" + motion.source + ")";
  take_part(motion, table);
  return motion;
}

GroundMotion from_samples(const Node& table, const Node& samples) {
  require_table(table, samples_keys);
  GroundMotion motion{required_number(table, "interval"), numbers(samples), "samples in the scene file"};
  if (motion.empty()) throw wrong_value(samples, "at least one number");
  return motion;
}

GroundMotion from_pulse(const Node& table, const Node& shape) {
  Pulse pulse;
  pulse.shape = choice<PulseShape>(
      shape, {"sine", "cosine", "half-sine", "rectangle", "ricker", "mavroeidis-papageorgiou"});
  read_members(table, keys_of(pulse.shape), pulse);
  GroundMotion motion;
  motion.source = shape.text + " pulse";
  motion.pulse = pulse;
  return motion;
}

GroundMotion from_synthetic(const Node& table, MotionLibrary& library) {
  SyntheticMotion motion;
  read_members(table, synthetic_keys, motion);
  validate(motion, table.key);
  GroundMotion result = *library.synthetic(motion);
  for (double& sample : result.samples) sample *= motion.peak;
  return result;
}

GroundMotion from_steps(const Node& table, const Node& sizes) {
  require_table(table, steps_keys);
  const Node& times = required(table, "times", "as many times as there are velocity_steps");
  const std::vector<double> given = numbers(sizes), at = numbers(times);
  if (given.empty()) throw wrong_value(sizes, "at least one number");
  if (at.size() != given.size())
    throw wrong_value(times, "as long as velocity_steps, " + std::to_string(given.size()));
  const Node* scale = find(table, "scale");
  const double factor = scale == nullptr ? 1 : number(*scale);
  GroundMotion motion;
  motion.source = "steps of the velocity" + (factor == 1 ? "" : ", times " + number_text(factor));
  motion.steps.reserve(at.size());
  for (std::size_t i = 0; i < at.size(); ++i) motion.steps.push_back({at[i], given[i] * factor});
  return motion;
}

void scale_to_peak(GroundMotion& motion, const Node& node) {
  const double wanted = number(node);
  require_positive(node.key, wanted);
  const double largest = peak(motion);
  if (largest == 0) throw wrong_value(node, "left out where every sample is zero");
  // Divided first, so that the largest sample comes out as the peak to the last bit.
  for (double& sample : motion.samples) sample = sample / largest * wanted;
  motion.source += ", scaled to a peak of " + number_text(wanted) + " m/s²";
}

double read_mass(const Node& table, const Block& block) {
  const Node* density = find(table, "density");
  const Node* mass = find(table, "mass");
  if (density == nullptr && mass == nullptr)
    throw missing_key(table, "density", "given, or mass in its place");
  if (density == nullptr) return number(*mass);
  if (mass != nullptr) throw excluded_key(*mass, *density);
  require_positive(density->key, number(*density));
  return density->number * (2 * block.half_width) * (2 * block.half_height);
}

Block read_block(const Node& table) {
  require_table(table, block_keys);
  Block block;
  block.half_width = 0.5 * required_number(table, "width");
  block.half_height = 0.5 * required_number(table, "height");
  block.mass = read_mass(table, block);
  block.inertia =
      number_or(table, "inertia", rectangle_inertia(block.mass, block.half_width, block.half_height));
  if (const Node* centre = find(table, "center_of_mass")) {
    const std::vector<double> offset = numbers(*centre);
    if (offset.size() != 2) throw wrong_value(*centre, "[x, y] in m, from the block's middle");
    if ((offset[0] != 0 || offset[1] != 0) && find(table, "inertia") == nullptr)
      throw missing_key(table, "inertia", "given beside center_of_mass: such a block is not uniform");
    block.offset_x = offset[0];
    block.offset_y = offset[1];
  }
  return block;
}

std::vector<Block> read_blocks(const Node& root) {
  const Node* array = find(root, "blocks");
  if (array == nullptr) return {};  // validate() says how many there must be
  if (array->kind != Node::Kind::array) throw wrong_value(*array, "an array of tables, [[blocks]]");
  return mapped(array->children, read_block);
}

InitialState read_initial(const Node& root, std::size_t size) {
  InitialState initial{std::vector<double>(size), std::vector<double>(size)};
  if (const Node* table = find(root, "initial")) read_members(*table, initial_keys, initial);
  return initial;
}

void read_ground(const SceneDocument& document, MotionLibrary& library, Scene& scene) {
  const Node* ground = find(document.root, "ground");
  if (ground == nullptr) return;
  read_members(*ground, ground_keys, scene);
  for (const auto& [axis, motion] :
       {std::pair("horizontal", &scene.horizontal), {"vertical", &scene.vertical}})
    if (const Node* table = find(*ground, axis))
      *motion = read_ground_motion(*table, document.folder, library);
}

void read_contact(const Node& root, Scene& scene) {
  const Node* table = find(root, "contact");
  if (table == nullptr) return;
  read_members(*table, contact_keys, scene);
  if (scene.restitution_law != RestitutionLaw::newton && find(*table, "restitution") == nullptr)
    throw wrong_value(required(*table, "restitution_law", ""),
                      "left out where contact.restitution is, whose law it is");
}

void read_engine(const Node& root, Scene& scene) {
  const Node* table = find(root, "engine");
  if (table == nullptr) return;
  const Node* contact = find(root, "contact");
  const Node* friction = find(*table, "friction");
  const Node* of_contacts = contact == nullptr ? nullptr : find(*contact, "friction");
  if (friction != nullptr && of_contacts != nullptr)
    throw wrong_value(*friction, "left out where contact.friction is given (" + of_contacts->place +
                                     "), which engines take too");
  read_members(*table, surface_keys, scene);
}

Scene scene_from(const SceneDocument& document, MotionLibrary& library) {
  const Node& root = document.root;
  Scene scene;
  read_members(root, scene_keys, scene);
  const Node* title = find(root, "title");
  scene.title = title == nullptr ? document.title : text(*title);
  scene.blocks = read_blocks(root);
  scene.initial = read_initial(root, scene.blocks.size());
  read_ground(document, library, scene);
  read_contact(root, scene);
  read_pushes(
      root, [&](const Node& table) { return read_ground_motion(table, document.folder, library); }, scene);
  if (const Node* wall = find(root, "wall")) read_members(*wall, wall_keys, scene.wall);
  read_restraints(root, scene);
  read_engine(root, scene);
  return scene;
}

}  // namespace

GroundMotion read_ground_motion(const Node& table, const std::filesystem::path& folder,
                                MotionLibrary& library) {
  if (const Node* pulse = find(table, "pulse")) return from_pulse(table, *pulse);
  if (find(table, "synthetic") != nullptr) return from_synthetic(table, library);
  if (const Node* steps = find(table, "velocity_steps")) return from_steps(table, *steps);
  const Node* record = find(table, "record");
  const Node* samples = find(table, "samples");
  if (record == nullptr && samples == nullptr)
    throw missing_key(table, "record",
                      "given, or samples and interval, a pulse, synthetic or velocity_steps in its place");
  GroundMotion motion =
      record != nullptr ? from_record(table, *record, folder, library) : from_samples(table, *samples);
  const Node* scale = find(table, "scale");
  const Node* wanted_peak = find(table, "peak");
  if (scale != nullptr && wanted_peak != nullptr) throw excluded_key(*wanted_peak, *scale);
  if (scale != nullptr) {
    require_between(scale->key, number(*scale), -largest_number);
    for (double& sample : motion.samples) sample *= scale->number;
    motion.source += ", times " + number_text(scale->number);
  }
  if (wanted_peak != nullptr) scale_to_peak(motion, *wanted_peak);
  const double time_scale = number_or(table, "time_scale", 1);
  require_positive(table.key + ".time_scale", time_scale);
  motion.interval *= time_scale;
  if (time_scale != 1) motion.source += ", time times " + number_text(time_scale);
  return motion;
}

SceneDocument read_document(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  SceneDocument document{read_toml(file), file.parent_path(), file.stem().string()};
  for (const std::string& each : overrides) apply_override(document.root, each);
  if (const Node* measured = find(document.root, "measured")) {
    document.measured = *measured;
    std::erase_if(document.root.children, [](const Node& child) { return child.name == "measured"; });
  }
  return document;
}

Scene make_scene(const SceneDocument& document, MotionLibrary& library) {
  try {
    Scene scene = scene_from(document, library);
    validate(scene);
    return scene;
  } catch (const FieldError& error) {
    throw InputError(nearest(document.root, error.key).place + ": " + error.what());
  }
}

Scene read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  MotionLibrary library;
  return make_scene(read_document(file, overrides), library);
}

}  // namespace rockstack
