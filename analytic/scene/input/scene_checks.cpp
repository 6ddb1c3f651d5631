#include <limits>
#include <numbers>

#include "analytic/scene/input/applied_forces_file.hpp"
#include "analytic/scene/input/scene_keys.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "analytic/scene/pattern.hpp"
#include "analytic/scene/solve_options.hpp"

namespace rockstack {
namespace {

void validate_block(const Block& block, const std::string& key) {
  require_positive(key + ".width", 2 * block.half_width);
  require_positive(key + ".height", 2 * block.half_height);
  require_positive(key + ".mass", block.mass);
  // The mass times the square of a length: of a grain below 0.1 mm it is beyond 10⁻²⁰ kg·m².
  const double square = largest_number * largest_number;
  require_between(key + ".inertia", block.inertia, block.mass / square, block.mass * square);
  const auto require_inside = [&](const char* entry, double offset, double half) {
    if (!(std::abs(offset) < half))
      throw FieldError(key + ".center_of_mass." + entry, offset,
                       "inside the block, between ±" + number_text(half) + " m");
  };
  require_inside("1", block.offset_x, block.half_width);
  require_inside("2", block.offset_y, block.half_height);
}

/// What an angle beyond its limit would be in rad, if it were meant in degrees; nothing where that is beyond.
std::string in_degrees(double given, double limit) {
  const double angle = given * std::numbers::pi / 180;
  return std::abs(angle) < limit ? "; " + number_text(given) + " degrees are " + number_text(angle, 5) : "";
}

void validate_inclination(const Scene& scene) {
  constexpr double most = 0.25 * std::numbers::pi;
  const double given = scene.inclination;
  if (std::abs(given) <= most) return;
  throw FieldError("ground.inclination", given,
                   "between ±" + number_text(most, 4) + " rad" + in_degrees(given, most));
}

/// Checks what only some equations and impacts are made for.
void validate_off_middle(const Scene& scene) {
  const auto off = std::ranges::find_if(
      scene.blocks, [](const Block& block) { return block.offset_x != 0 || block.offset_y != 0; });
  if (off == scene.blocks.end()) return;
  const std::string key = entry_key("blocks", off - scene.blocks.begin()) + ".center_of_mass";
  const std::string value = "[" + number_text(off->offset_x) + ", " + number_text(off->offset_y) + "]";
  if (scene.equations == Equations::small_angle)
    throw FieldError(key, value,
                     "[0, 0] in small-angle equations, which are those of one half diagonal a block");
  if (!scene.restitution.empty())
    throw FieldError(key, value, "[0, 0] beside restitution, whose ratio might add energy otherwise");
}

void validate_gaps(const Scene& scene) {
  const InitialState& initial = scene.initial;
  for (std::size_t k = 0; k < initial.gaps.size(); ++k) {
    const std::string key = entry_key("initial.gaps", k);
    if (initial.gaps[k] > 0 && scene.law == Law::compliant && initial.preloaded)
      throw FieldError(key, initial.gaps[k],
                       "0, or beside initial.springs = \"unloaded\": what falls bears on no spring");
  }
  for (std::size_t k = 0; k < initial.gap_velocities.size(); ++k)
    if (initial.gap_velocities[k] != 0 && !has_gap(initial, k))
      throw FieldError(entry_key("initial.gap_velocities", k), initial.gap_velocities[k],
                       "0 where initial.gaps has none: a block that touches turns and slips");
}

/// Blocks start over what is below, on it or not.
void validate_offsets(const Scene& scene) {
  for (std::size_t k = 1; k < scene.initial.offsets.size(); ++k) {
    const double reach = scene.blocks[k].half_width + scene.blocks[k - 1].half_width;
    if (!(std::abs(scene.initial.offsets[k]) < reach))
      throw FieldError(entry_key("initial.offsets", k), scene.initial.offsets[k],
                       "between ±" + number_text(reach) + " m, so that the block is over the one below");
  }
}

void validate_initial(const Scene& scene) {
  for (const auto& [key, values] : {std::pair{"initial.angles", &scene.initial.angles},
                                    {"initial.velocities", &scene.initial.velocities}})
    if (values->empty()) require_one_each(key, *values, scene.blocks.size(), 0, 0, as_long);
  require_ranges("initial.", initial_keys, scene.initial, scene.blocks.size());
  validate_gaps(scene);
  validate_offsets(scene);
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const double limit = toppling_angle(scene, k);
    if (const double given = scene.initial.angles[k]; std::abs(given) >= limit)
      throw FieldError(entry_key("initial.angles", k), given,
                       "between ±" + number_text(limit) + " for block " + std::to_string(k + 1) +
                           ", its toppling angle" + in_degrees(given, limit));
  }
}

void validate_friction(const Scene& scene) {
  const std::string key = "contact.kinetic_friction";
  if (!scene.friction.empty())
    require_one_each("contact.friction", scene.friction, scene.blocks.size(), 0, largest_friction);
  if (scene.kinetic_friction.empty()) return;
  require_one_each(key, scene.kinetic_friction, scene.blocks.size(), 0, largest_friction);
  const std::vector<double> most = friction_of(scene);
  for (std::size_t k = 0; k < most.size(); ++k) {
    const double given = scene.kinetic_friction[k];
    const auto refuse = [&](const std::string& why) { throw FieldError(entry_key(key, k), given, why); };
    if (given > most[k]) refuse("at most contact.friction, " + number_text(most[k]) + " there");
    if (given != most[k] && scene.law == Law::compliant)
      refuse(
          "that of contact.friction under law compliant, where springs along a face would jump as it slides");
  }
}

void validate_point_restitution(const Scene& scene) {
  require_ranges("contact.", contact_keys, scene);
  const double given = scene.point_restitution;
  if (given == 0 || scene.law == Law::unilateral) return;
  throw FieldError("contact.restitution", given,
                   std::string("0 under law ") + name(scene.law) +
                       (scene.law == Law::compliant ? ", where dashpots decide (contact.damping)"
                                                    : ", whose impacts have the ratio restitution"));
}

/// Checks what is made for some laws alone.
void validate_law(const Scene& scene) {
  if (!leaves_pivots(scene.law)) {
    for (const auto& [key, values] : of_free_blocks)
      if (std::ranges::any_of(scene.initial.*values, [](double value) { return value != 0; }))
        throw FieldError(std::string("initial.") + key, "not all 0",
                         std::string("all 0 under law ") + name(scene.law) +
                             ", where nothing slips or lifts: say law = \"unilateral\"");
    return;
  }
  if (scene.equations != Equations::nonlinear)
    throw FieldError("equations", name(scene.equations),
                     std::string("nonlinear under law ") + name(scene.law));
  if (!scene.restitution.empty())
    throw FieldError("restitution", "[" + number_text(scene.restitution.front()) + ", …]",
                     std::string("left out under law ") + name(scene.law) +
                         (scene.law == Law::unilateral ? ", where contact.restitution is of points"
                                                       : ", where dashpots decide"));
}

/// A wall is made for one block that turns about its corners and starts away from it.
void validate_wall(const Scene& scene) {
  const int side = scene.wall.side;
  if (side == 0) return;
  const auto refuse = [](const std::string& why) { throw FieldError("wall", "a table", "left out " + why); };
  if (scene.blocks.size() > 1)
    refuse("where a stack has " + std::to_string(scene.blocks.size()) + " blocks: a wall is beside one");
  if (leaves_pivots(scene.law))
    refuse(std::string("under law ") + name(scene.law) + ": walls are for laws of pivots");
  if (has_applied_forces(scene)) refuse("beside pushes, restraints and steps of the ground's velocity");
  if (!scene.restitution.empty()) refuse("beside restitution: wall.restitution is the ratio of its strikes");
  const Block& block = scene.blocks.front();
  if (block.offset_x != 0 || block.offset_y != 0) refuse("beside blocks.1.center_of_mass");
  if (const auto& ratio = scene.wall.restitution) require_between("wall.restitution", *ratio, 0, 1);
  const double angle = scene.initial.angles[0], rate = scene.initial.velocities[0];
  if (side * angle > 0)
    throw FieldError("initial.angles.1", angle,
                     std::string(side < 0 ? "≥ 0" : "≤ 0") + ", away from the wall");
  if (angle == 0 && side * rate > 0)
    throw FieldError("initial.velocities.1", rate,
                     std::string(side < 0 ? "≥ 0" : "≤ 0") + ", away from the wall");
}

void validate_pulse(const Pulse& pulse, const std::string& key) {
  require_ranges(key + ".", keys_of(pulse.shape), pulse);
  if (!(pulse.cycles > 1 && pulse.cycles <= 1e6) && pulse.shape == PulseShape::mavroeidis_papageorgiou)
    throw FieldError(key + ".cycles", pulse.cycles, "a number > 1, up to 1e+06");
  if (!(pulse.cycles > 0)) throw FieldError(key + ".cycles", pulse.cycles, "a number > 0, or inf");
}

void validate_steps(const GroundMotion& motion, const std::string& key) {
  double earlier = 0;
  for (std::size_t i = 0; i < motion.steps.size(); ++i) {
    const auto& [time, size] = motion.steps[i];
    if (!(i == 0 ? time >= 0 : time > earlier) || time > largest_number)
      throw FieldError(entry_key(key + ".times", i), time, i == 0 ? "≥ 0" : "later than the one before");
    require_between(entry_key(key + ".velocity_steps", i), size, -largest_number);
    earlier = time;
  }
}

void validate_duration(const Scene& scene) {
  double smallest = std::numeric_limits<double>::infinity();
  double turning = 0;  // m/s², towards the centre of what turns
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const double radius = std::hypot(scene.blocks[k].half_width, scene.blocks[k].half_height);
    smallest = std::min(smallest, radius);
    turning = std::max(turning, radius * scene.initial.velocities[k] * scene.initial.velocities[k]);
  }
  const auto strongest = [](const GroundMotion& motion) {
    return motion.pulse ? std::abs(motion.pulse->amplitude) : peak(motion);
  };
  double pushed = 0;
  for (const Push& push : scene.pushes)
    pushed += strongest(push.force) / scene.blocks[static_cast<std::size_t>(push.point.block) - 1].mass;
  const double acceleration =
      scene.gravity + strongest(scene.horizontal) + strongest(scene.vertical) + turning + pushed;
  const double longest = 1e7 * std::sqrt(smallest / acceleration);
  if (scene.duration > longest)
    throw FieldError("duration", scene.duration,
                     "at most " + number_text(longest) +
                         " s, 10⁷ √(half a diagonal of the smallest block / the largest acceleration)");
}

}  // namespace

void validate(const GroundMotion& motion, const std::string& key) {
  if (motion.empty()) return;
  if (motion.pulse) return validate_pulse(*motion.pulse, key);
  if (!motion.steps.empty()) return validate_steps(motion, key);
  require_positive(key + ".interval", motion.interval);
  require_each_between(key + ".samples", motion.samples, -largest_number);
}

void validate(const Scene& scene) {
  if (scene.blocks.empty() || scene.blocks.size() > static_cast<std::size_t>(max_blocks))
    throw FieldError("blocks", std::to_string(scene.blocks.size()) + " blocks",
                     "1 to " + std::to_string(max_blocks) + " blocks");
  for (std::size_t k = 0; k < scene.blocks.size(); ++k)
    validate_block(scene.blocks[k], entry_key("blocks", k));
  validate_off_middle(scene);
  require_ranges("", scene_keys, scene, scene.blocks.size());
  validate_law(scene);
  validate_initial(scene);
  validate_wall(scene);
  validate_friction(scene);
  validate_point_restitution(scene);
  validate_springs(scene);
  validate_inclination(scene);
  validate(scene.horizontal, "ground.horizontal");
  validate(scene.vertical, "ground.vertical");
  validate_pushes(scene);
  validate_restraints(scene);
  validate_duration(scene);
  require_ranges("engine.", surface_keys, scene);
}

void validate(const SolveOptions& options) {
  const auto refuse = [](const char* name, double value, const char* range) {
    throw std::invalid_argument(std::string(name) + " = " + std::to_string(value) + ": must be " + range);
  };
  if (!(options.resolution >= 0)) refuse("resolution", options.resolution, "≥ 0 rad");
  if (!(options.tolerance >= 0)) refuse("tolerance", options.tolerance, "≥ 0");
  if (!(options.step > 0)) refuse("step", options.step, "> 0 s");
  double earlier = 0;
  for (const double time : options.sample_times) {
    if (!(time >= earlier && time <= std::numeric_limits<double>::max()))
      refuse("sample time", time, "finite, ≥ 0 and no earlier than the one before, s");
    earlier = time;
  }
}

}  // namespace rockstack
