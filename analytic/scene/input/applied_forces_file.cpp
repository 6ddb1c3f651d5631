#include "analytic/scene/input/applied_forces_file.hpp"

#include "analytic/scene/input/scene_keys.hpp"
#include "analytic/scene/messages/number_text.hpp"

namespace rockstack {
namespace {

/// A force that is one number from a time on, up to another.
GroundMotion constant_force(const Node& table, double force, double duration) {
  const double from = number_or(table, "from", 0), to = number_or(table, "to", duration);
  if (!(from < to))
    throw wrong_value(
        *find(table, find(table, "to") == nullptr ? "from" : "to"),
        find(table, "to") == nullptr ? "before the end of the scene" : "later than the force begins");
  GroundMotion motion;
  motion.source = number_text(force) + " N";
  motion.pulse = {.shape = PulseShape::rectangle, .amplitude = force, .period = to - from, .start = from};
  return motion;
}

/// Refuses a key of a push beside which another is not given.
void require_beside(const Node& table, const char* key, bool given, const char* words) {
  const Node* node = find(table, key);
  if (node != nullptr && !given) throw wrong_value(*node, words);
}

GroundMotion read_force(const Node& table, const std::function<GroundMotion(const Node&)>& read_motion,
                        double duration) {
  const Node* force = find(table, "force");
  const Node* impulse = find(table, "impulse");
  if (force == nullptr && impulse == nullptr)
    throw missing_key(table, "force", "given, or impulse in its place");
  if (force != nullptr && impulse != nullptr) throw excluded_key(*impulse, *force);
  const bool constant = force != nullptr && force->kind == Node::Kind::number;
  const bool known = force == nullptr || constant ||
                     (force->kind == Node::Kind::table &&
                      (find(*force, "samples") != nullptr || find(*force, "pulse") != nullptr));
  if (!known) throw wrong_value(*force, "a number, or a table of samples and interval, or of a pulse");
  require_beside(table, "from", constant || impulse != nullptr, "left out beside a table, which tells times");
  require_beside(table, "to", constant, "left out beside no constant force");
  if (constant) return constant_force(table, force->number, duration);
  GroundMotion motion;
  if (impulse != nullptr) {
    motion.source = number_text(number(*impulse)) + " N·s";
    motion.steps = {{number_or(table, "from", 0), impulse->number}};
    return motion;
  }
  return read_motion(*force);
}

}  // namespace

void read_pushes(const Node& root, const std::function<GroundMotion(const Node&)>& read_motion,
                 Scene& scene) {
  const Node* array = find(root, "push");
  if (array == nullptr) return;
  if (array->kind != Node::Kind::array) throw wrong_value(*array, "an array of tables, [[push]]");
  for (const Node& table : array->children) {
    Push& push = scene.pushes.emplace_back();
    read_members(table, push_keys, push);
    const auto block = static_cast<std::size_t>(push.point.block);
    const bool known = block <= scene.blocks.size();  // else validate() says so
    push.point.y = number_or(table, "height", known ? scene.blocks[block - 1].half_height : 0);
    push.force = read_force(table, read_motion, scene.duration);
  }
}

void read_restraints(const Node& root, Scene& scene) {
  const Node* array = find(root, "restraint");
  if (array == nullptr) return;
  if (array->kind != Node::Kind::array) throw wrong_value(*array, "an array of tables, [[restraint]]");
  for (const Node& table : array->children) {
    Restraint& restraint = scene.restraints.emplace_back();
    restraint.kind =
        choice<RestraintKind>(required(table, "kind", "\"tendon\" or \"damper\""), {"tendon", "damper"});
    read_members(table, keys_of(restraint.kind), restraint);
  }
}

}  // namespace rockstack
