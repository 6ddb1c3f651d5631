#include "analytic/scene/spring_checks.hpp"

#include <algorithm>
#include <limits>

#include "analytic/scene/messages/number_text.hpp"

namespace rockstack {
namespace {

/// The springs of one interface, both corners or the bed, and what names them in a scene file.
struct Foundation {
  const char* stiffness_key;
  const char* damping_key;
  double stiffness = 0, damping = 0;  ///< as given
  double whole = 0;                   ///< what a unit of them comes to in all: 2 corners, or the bed's length
  double across = 0, along = 0;       ///< tr M⁻¹K of that, a unit of stiffness
};

double at(const std::vector<double>& values, std::size_t k, double default_value) {
  return values.empty() ? default_value : values[k];
}

Foundation foundation_of(const Scene& scene, std::size_t k) {
  const CornerSprings& springs = scene.springs;
  const double half_width = interface_half_width(scene, k);
  const bool bed = std::isfinite(at(springs.bed_stiffness, k, INFINITY));
  Foundation result =
      bed ? Foundation{"contact.bed_stiffness", "contact.bed_damping", springs.bed_stiffness[k],
                       at(springs.bed_damping, k, 0), 2 * half_width}
          : Foundation{"contact.stiffness", "contact.damping", at(springs.stiffness, k, INFINITY),
                       at(springs.damping, k, 0), 2};
  // A bed's turning stiffness is a third of that of springs at its ends.
  const double reach = bed ? half_width / std::sqrt(3.0) : half_width;
  for (const std::size_t block : {k, k - 1}) {
    if (block >= scene.blocks.size()) continue;  // the ground
    const double across = spring_compliance(scene.blocks[block], reach, 0);
    result.across += result.whole * across;
    result.along +=
        result.whole * (spring_compliance(scene.blocks[block], reach, springs.tangential) - across);
  }
  return result;
}

constexpr double rigid = std::numeric_limits<double>::infinity();

void refuse(bool given, const char* key, const std::string& value, const std::string& reason) {
  if (given) throw FieldError(key, value, "left out " + reason);
}

/// The first that is not what holds where a key is left out.
void refuse_any_but(const std::vector<double>& values, double default_value, const char* key,
                    const std::string& reason) {
  const auto given =
      std::find_if(values.begin(), values.end(), [&](double value) { return value != default_value; });
  if (given != values.end()) refuse(true, key, number_text(*given), reason);
}

/// Where no interface is soft by its law.
void require_no_springs(const Scene& scene) {
  const CornerSprings& springs = scene.springs;
  if (springs == CornerSprings{} && scene.initial.preloaded) return;
  const std::string reason = std::string("under law ") + name(scene.law) + ": springs are for law compliant";
  refuse_any_but(springs.stiffness, rigid, "contact.stiffness", reason);
  refuse_any_but(springs.damping, 0, "contact.damping", reason);
  refuse_any_but(springs.bed_stiffness, rigid, "contact.bed_stiffness", reason);
  refuse_any_but(springs.bed_damping, 0, "contact.bed_damping", reason);
  refuse(springs.tangential != 1, "contact.tangential", number_text(springs.tangential), reason);
  refuse(!scene.initial.preloaded, "initial.springs", "unloaded", reason);
}

/// Values that only do something beside others. A stiffness that is infinite may be compared with others.
void require_effect(const CornerSprings& springs) {
  const bool corners = !springs.stiffness.empty();
  const bool beds = !springs.bed_stiffness.empty();
  if (!corners)
    refuse_any_but(springs.damping, 0, "contact.damping",
                   "without contact.stiffness: it is of the dashpot beside each spring");
  if (!beds)
    refuse_any_but(springs.bed_damping, 0, "contact.bed_damping",
                   "without contact.bed_stiffness: it is of the bed");
  if (!corners && !beds)
    throw FieldError("law", "compliant",
                     "another, or contact.stiffness or contact.bed_stiffness given: no interface is soft");
}

/// Stiffnesses, which are above zero or infinite, or dampings.
void validate_each(const Scene& scene, const char* key, const std::vector<double>& values, bool stiffness) {
  std::vector<double> finite = values;
  if (stiffness) std::replace(finite.begin(), finite.end(), rigid, 1.0);
  if (!values.empty()) require_one_each(key, finite, scene.blocks.size(), stiffness ? 1 / largest_number : 0);
}

/// `per_stiffness` is what an interface bears for a depth of a metre, of a unit of the key's stiffness.
void validate_depth(const Scene& scene, std::size_t interface, const char* key, double stiffness,
                    double per_stiffness) {
  double mass = 0;
  for (std::size_t k = interface; k < scene.blocks.size(); ++k) mass += scene.blocks[k].mass;
  double height = 2 * scene.blocks[interface].half_height;
  if (interface > 0) height = std::min(height, 2 * scene.blocks[interface - 1].half_height);
  const double weight = mass * scene.gravity * std::cos(scene.inclination);
  const double depth = weight / (per_stiffness * stiffness);
  constexpr double deepest_share = 0.1;
  const double least = weight / (per_stiffness * deepest_share * height);
  if (stiffness >= least) return;
  throw FieldError(entry_key(key, interface), stiffness,
                   "at least " + number_text(1.005 * least, 3) +
                       ": under the weight above it the interface would give way by " +
                       number_text(depth, 3) + " m, at most a tenth of a block's height, " +
                       number_text(height, 3) + " m, is a contact");
}

/// Bounds on how fast the springs of a stack may be, 1/s, as it stands upright: nothing swings faster than
/// √tr M⁻¹K, dies out faster than tr M⁻¹C, or relaxes faster than k/c, where sliders may move. And the scene
/// file's key of what the largest of them is due to most.
struct SpringRate {
  double rate = 0;
  std::string key;
  double value = 0;  ///< of that key
};

SpringRate fastest_spring_rate(const Scene& scene) {
  const std::vector<double> friction = friction_of(scene);
  double square = 0;
  double damped = 0;
  SpringRate swinging, dying, relaxing;  // `rate` is that of one interface here
  double across = 0, along = 0;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const Foundation soft = foundation_of(scene, k);
    if (std::isinf(soft.stiffness)) continue;
    const double sum = soft.across + soft.along;
    square += soft.stiffness * sum;
    damped += soft.damping * sum;
    across += soft.stiffness * soft.across;
    along += soft.stiffness * soft.along;
    if (soft.stiffness * sum > swinging.rate)
      swinging = {soft.stiffness * sum, entry_key(soft.stiffness_key, k), soft.stiffness};
    if (soft.damping * sum > dying.rate)
      dying = {soft.damping * sum, entry_key(soft.damping_key, k), soft.damping};
    const bool slides = friction[k] > 0 && friction[k] < largest_friction;
    if (slides && soft.damping > 0 && soft.stiffness / soft.damping > relaxing.rate)
      relaxing = {soft.stiffness / soft.damping, entry_key(soft.damping_key, k), soft.damping};
  }
  swinging.rate = std::sqrt(square);
  dying.rate = damped;
  SpringRate& fastest = swinging.rate > dying.rate ? swinging : dying;
  if (along > across && scene.springs.tangential > 1) {
    fastest.key = "contact.tangential";
    fastest.value = scene.springs.tangential;
  }
  return relaxing.rate > fastest.rate ? relaxing : fastest;
}

void validate_steps(const Scene& scene) {
  constexpr double most = 1e7;  // some minutes
  const SpringRate fastest = fastest_spring_rate(scene);
  const double steps = scene.duration * fastest.rate / steps_per_rate;
  if (steps > most)
    throw FieldError(fastest.key, fastest.value,
                     "such that springs take at most " + number_text(most) + " steps: as fast as " +
                         number_text(fastest.rate, 3) + " rad/s, they would take " + number_text(steps, 3));
}

void validate_unloaded(const Scene& scene) {
  // Depth and pressure of a bed would both be zero all along it, and its two zeros at one place.
  const auto parts = [](const std::vector<double>& values, std::size_t k) {
    return values[k] != (k == 0 ? 0 : values[k - 1]);
  };
  for (std::size_t k = 0; k < scene.springs.bed_stiffness.size(); ++k)
    if (scene.springs.bed_stiffness[k] != rigid && !parts(scene.initial.angles, k) &&
        parts(scene.initial.velocities, k) && !has_gap(scene.initial, k))
      throw FieldError(
          "initial.springs", "unloaded",
          "loaded where a block lies flat on a bed and turns, as block " + std::to_string(k + 1) + " does");
}

}  // namespace

double spring_compliance(const Block& block, double half_width, double tangential) {
  const double reach = half_width + std::abs(block.offset_x);
  const double rise = block.half_height + std::abs(block.offset_y);
  const double across = 1 / block.mass + reach * reach / block.inertia;
  const double along = 1 / block.mass + rise * rise / block.inertia;
  return across + tangential * along;
}

void require_one_each(const std::string& key, const std::vector<double>& values, std::size_t blocks,
                      double least, double most, const std::string& allowed) {
  if (values.size() != blocks)
    throw FieldError(key, "an array of " + std::to_string(values.size()), allowed + std::to_string(blocks));
  require_each_between(key, values, least, most);
}

void validate_springs(const Scene& scene) {
  if (scene.law != Law::compliant) return require_no_springs(scene);
  const CornerSprings& springs = scene.springs;
  validate_each(scene, "contact.stiffness", springs.stiffness, true);
  validate_each(scene, "contact.damping", springs.damping, false);
  validate_each(scene, "contact.bed_stiffness", springs.bed_stiffness, true);
  validate_each(scene, "contact.bed_damping", springs.bed_damping, false);
  for (std::size_t k = 0; k < std::min(springs.stiffness.size(), springs.bed_stiffness.size()); ++k)
    if (springs.stiffness[k] != rigid && springs.bed_stiffness[k] != rigid)
      throw FieldError(entry_key("contact.bed_stiffness", k), springs.bed_stiffness[k],
                       "inf where contact.stiffness is not: an interface has springs at corners or a bed");
  require_positive("contact.tangential", springs.tangential);
  require_effect(springs);
  for (std::size_t k = 0; k < springs.stiffness.size(); ++k)
    validate_depth(scene, k, "contact.stiffness", springs.stiffness[k], 2);
  for (std::size_t k = 0; k < springs.bed_stiffness.size(); ++k)
    validate_depth(scene, k, "contact.bed_stiffness", springs.bed_stiffness[k],
                   2 * interface_half_width(scene, k));
  validate_steps(scene);
  if (!scene.initial.preloaded) validate_unloaded(scene);
}

}  // namespace rockstack
