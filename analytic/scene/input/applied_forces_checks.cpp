#include "analytic/scene/input/applied_forces_file.hpp"
#include "analytic/scene/input/applied_forces_keys.hpp"
#include "analytic/scene/messages/number_text.hpp"

namespace rockstack {
namespace {

/// Checks a push: where it acts, and its force; keys are those of a file.
void validate_push(const Scene& scene, const Push& push, const std::string& key) {
  if (scene.equations == Equations::small_angle)
    throw FieldError("equations", name(scene.equations),
                     "another beside push: these leave no lever of its own");
  const auto blocks = static_cast<int>(scene.blocks.size());
  if (push.point.block < 1 || push.point.block > blocks)
    throw FieldError(key + ".block", std::to_string(push.point.block),
                     "one of the blocks, 1 to " + std::to_string(blocks));
  const Block& block = scene.blocks[static_cast<std::size_t>(push.point.block) - 1];
  require_between(key + ".height", push.point.y, 0, 2 * block.half_height);
  require_between(key + ".x", push.point.x, -block.half_width, block.half_width);
  require_ranges(key + ".", push_keys, push);
  if (const auto& steps = push.force.steps; !steps.empty()) {
    require_between(key + ".from", steps.front().time, 0);
    require_between(key + ".impulse", steps.front().size, -largest_number);
    return validate(push.force, key);
  }
  if (const auto& pulse = push.force.pulse; pulse && pulse->shape == PulseShape::rectangle)
    require_between(key + ".from", pulse->start, 0);
  validate(push.force, key + ".force");
}

void require_left_out(const std::string& key, double value, const char* kind) {
  if (value != 0) throw FieldError(key, value, std::string("left out beside kind = \"") + kind + "\"");
}

double upright_height(const Scene& scene, const BlockPoint& point) {
  double height = point.y;
  for (int k = 0; k + 1 < point.block; ++k)
    height += 2 * scene.blocks[static_cast<std::size_t>(k)].half_height;
  return height;
}

void require_block(const Scene& scene, const std::string& key, int block, int least) {
  const auto most = static_cast<int>(scene.blocks.size());
  if (block < least || block > most)
    throw FieldError(key, std::to_string(block),
                     "one of the blocks, " + std::to_string(least) + " to " + std::to_string(most));
}

/// Checks a restraint; keys are those of a file.
void validate_restraint(const Scene& scene, const Restraint& restraint, const std::string& key) {
  if (scene.equations != Equations::nonlinear)
    throw FieldError("equations", name(scene.equations),
                     "nonlinear beside restraint, whose length they would not know");
  if (scene.law == Law::compliant)
    throw FieldError("law", name(scene.law),
                     "another beside restraint, which springs at corners do not know");
  require_block(scene, key + ".block", restraint.from.block, 1);
  require_block(scene, key + ".to_block", restraint.to.block, 0);
  if (restraint.from.block == restraint.to.block)
    throw FieldError(key + ".to_block", std::to_string(restraint.to.block), "another block");
  require_ranges(key + ".", keys_of(restraint.kind), restraint);
  if (restraint.kind == RestraintKind::tendon) {
    require_left_out(key + ".damping", restraint.damping, "tendon");
  } else {
    require_left_out(key + ".stiffness", restraint.stiffness, "damper");
    require_left_out(key + ".prestress", restraint.prestress, "damper");
  }
  if (!(restraint.yield > restraint.prestress))
    throw FieldError(key + ".yield", restraint.yield, "> prestress, or inf");
  const double x = restraint.to.x - restraint.from.x;
  const double y = upright_height(scene, restraint.to) - upright_height(scene, restraint.from);
  if (!(std::hypot(x, y) > 1e-6 * stack_height(scene)))
    throw FieldError(key + ".to_point",
                     "[" + number_text(restraint.to.x) + ", " + number_text(restraint.to.y) + "]",
                     "elsewhere: it has no length where the stack stands upright");
}

}  // namespace

void validate_pushes(const Scene& scene) {
  if (scene.pushes.size() > max_pushes)
    throw FieldError("push", std::to_string(scene.pushes.size()) + " tables",
                     "up to " + std::to_string(max_pushes));
  for (std::size_t i = 0; i < scene.pushes.size(); ++i)
    validate_push(scene, scene.pushes[i], entry_key("push", i));
}

void validate_restraints(const Scene& scene) {
  if (scene.restraints.size() > max_restraints)
    throw FieldError("restraint", std::to_string(scene.restraints.size()) + " tables",
                     "up to " + std::to_string(max_restraints));
  for (std::size_t i = 0; i < scene.restraints.size(); ++i)
    validate_restraint(scene, scene.restraints[i], entry_key("restraint", i));
}

}  // namespace rockstack
