#include "analytic/scene/input/scene_file.hpp"

#include "analytic/scene/input/fields.hpp"
#include "analytic/scene/input/ground_reader.hpp"
#include "analytic/scene/input/scene_keys.hpp"
#include "analytic/scene/input/toml_reader.hpp"

namespace rockstack {
namespace {

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
  std::vector<Block> blocks;
  for (const Node& table : array->children) blocks.push_back(read_block(table));
  return blocks;
}

/// An array with a number for each block; whether there are as many, validate() says.
std::vector<double> one_each(const Node& array) {
  if (array.kind == Node::Kind::array) entries(array, "a number for each block");
  return numbers(array);
}

InitialState read_initial(const Node& root, std::size_t size) {
  InitialState initial{std::vector<double>(size), std::vector<double>(size)};
  const Node* table = find(root, "initial");
  if (table == nullptr) return initial;
  require_table(*table, initial_keys);
  if (const Node* angles = find(*table, "angles")) initial.angles = numbers(*angles);
  if (const Node* velocities = find(*table, "velocities")) initial.velocities = numbers(*velocities);
  const std::pair<const char*, std::vector<double>*> of_free_blocks[] = {
      {"slip_velocities", &initial.slip_velocities},
      {"offsets", &initial.offsets},
      {"gaps", &initial.gaps},
      {"gap_velocities", &initial.gap_velocities}};
  for (const auto& [key, values] : of_free_blocks)
    if (const Node* array = find(*table, key)) *values = one_each(*array);
  if (const Node* springs = find(*table, "springs"))
    initial.preloaded = choice<bool>(*springs, {{"loaded", true}, {"unloaded", false}});
  return initial;
}

void read_ground(const SceneDocument& document, MotionLibrary& library, Scene& scene) {
  const Node* ground = find(document.root, "ground");
  if (ground == nullptr) return;
  require_table(*ground, ground_keys);
  scene.inclination = number_or(*ground, "inclination", scene.inclination);
  if (const Node* table = find(*ground, "horizontal")) {
    scene.horizontal = read_ground_motion(*table, document.folder, library);
  }
  if (const Node* table = find(*ground, "vertical")) {
    scene.vertical = read_ground_motion(*table, document.folder, library);
  }
}

/// Of each interface: the numbers given, or the one number for all; none where the key is left out.
std::vector<double> read_each(const Node& table, std::string_view key, std::size_t size) {
  const Node* node = find(table, key);
  if (node == nullptr) return {};
  return node->kind == Node::Kind::array ? one_each(*node) : std::vector<double>(size, number(*node));
}

/// The same of stiffnesses, where `inf` is a rigid interface.
std::vector<double> read_stiffness(const Node& table, std::string_view key, std::size_t size) {
  const Node* node = find(table, key);
  if (node == nullptr || node->kind != Node::Kind::array) return read_each(table, key, size);
  std::vector<double> values;
  for (const Node& entry : entries(*node, "a number for each block")) values.push_back(number(entry));
  return values;
}

void read_contact(const Node& root, Scene& scene) {
  const Node* table = find(root, "contact");
  if (table == nullptr) return;
  require_table(*table, contact_keys);
  const std::size_t size = scene.blocks.size();
  scene.friction = read_each(*table, "friction", size);
  scene.point_restitution = number_or(*table, "restitution", 0);
  if (const Node* law = find(*table, "restitution_law")) {
    scene.restitution_law = choice<RestitutionLaw>(
        *law, {{"newton", RestitutionLaw::newton}, {"poisson", RestitutionLaw::poisson}});
    if (scene.restitution_law != RestitutionLaw::newton && find(*table, "restitution") == nullptr)
      throw wrong_value(*law, "left out where contact.restitution is, whose law it is");
  }
  scene.springs.stiffness = read_stiffness(*table, "stiffness", size);
  scene.springs.damping = read_each(*table, "damping", size);
  scene.springs.bed_stiffness = read_stiffness(*table, "bed_stiffness", size);
  scene.springs.bed_damping = read_each(*table, "bed_damping", size);
  scene.springs.tangential = number_or(*table, "tangential", scene.springs.tangential);
}

EngineSurface read_engine(const Node& root) {
  EngineSurface surface;
  const Node* table = find(root, "engine");
  if (table == nullptr) return surface;
  require_table(*table, surface_keys);
  const Node* contact = find(root, "contact");
  const Node* friction = find(*table, "friction");
  const Node* of_contacts = contact == nullptr ? nullptr : find(*contact, "friction");
  if (friction != nullptr && of_contacts != nullptr)
    throw wrong_value(*friction, "left out where contact.friction is given (" + of_contacts->place +
                                     "), which engines take too");
  surface.friction = number_or(*table, "friction", surface.friction);
  surface.depth = number_or(*table, "depth", surface.depth);
  return surface;
}

Scene scene_from(const SceneDocument& document, MotionLibrary& library) {
  const Node& root = document.root;
  require_table(root, scene_keys);
  Scene scene;
  const Node* title = find(root, "title");
  scene.title = title == nullptr ? document.title : text(*title);
  scene.duration = required_number(root, "duration");
  scene.gravity = number_or(root, "gravity", scene.gravity);
  if (const Node* law = find(root, "law")) {
    scene.law = choice<Law>(*law, {{"paper", Law::paper},
                                   {"consistent", Law::consistent},
                                   {"unilateral", Law::unilateral},
                                   {"compliant", Law::compliant}});
  }
  if (const Node* equations = find(root, "equations")) {
    scene.equations = choice<Equations>(*equations, {{"nonlinear", Equations::nonlinear},
                                                     {"linear", Equations::linear},
                                                     {"small-angle", Equations::small_angle}});
  }
  if (const Node* restitution = find(root, "restitution")) {
    scene.restitution = one_each(*restitution);
  }
  scene.blocks = read_blocks(root);
  scene.initial = read_initial(root, scene.blocks.size());
  read_ground(document, library, scene);
  read_contact(root, scene);
  scene.engine = read_engine(root);
  return scene;
}

}  // namespace

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
