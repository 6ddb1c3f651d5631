#include "analytic/scene/spring_checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analytic/scene/messages/number_text.hpp"
#include "analytic/scene/spring_rates.hpp"

namespace rockstack {
namespace {

constexpr double rigid = std::numeric_limits<double>::infinity();

void refuse(bool given, const char* key, const std::string& value, const std::string& reason) {
  if (given) throw FieldError(key, value, "left out " + reason);
}

/// The first that is not what holds where a key is left out.
void refuse_any_but(const std::vector<double>& values, double standard, const char* key,
                    const std::string& reason) {
  const auto given =
      std::find_if(values.begin(), values.end(), [&](double value) { return value != standard; });
  if (given != values.end()) refuse(true, key, number_text(*given), reason);
}

/// Where no interface is soft by its law.
void require_no_springs(const Scene& scene) {
  const CornerSprings& springs = scene.springs;
  const std::string reason = std::string("under law ") + name(scene.law) + ": springs are for law compliant";
  refuse_any_but(springs.stiffness, rigid, "contact.stiffness", reason);
  refuse_any_but(springs.damping, 0, "contact.damping", reason);
  refuse_any_but(springs.bed_stiffness, rigid, "contact.bed_stiffness", reason);
  refuse_any_but(springs.bed_damping, 0, "contact.bed_damping", reason);
  refuse(springs.tangential != 1, "contact.tangential", number_text(springs.tangential), reason);
  refuse(!scene.initial.settled, "initial.springs", "unloaded", reason);
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

void validate_stiffness(const std::string& key, double value) {
  if (value != rigid) require_positive(key, value);
}

void validate_damping(const std::string& key, double value) {
  require_between(key, value, 0);
}

void validate_each(const Scene& scene, const char* key, const std::vector<double>& values,
                   void (*validate_one)(const std::string&, double)) {
  if (!values.empty()) require_one_each(key, values, scene.blocks.size());
  for (std::size_t k = 0; k < values.size(); ++k)
    validate_one(std::string(key) + "." + std::to_string(k + 1), values[k]);
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
  const double least = weight / (per_stiffness * deepest_share * height);
  if (stiffness >= least) return;
  throw FieldError(std::string(key) + "." + std::to_string(interface + 1), number_text(stiffness),
                   "at least " + number_text(1.005 * least, 3) +
                       ": under the weight above it the interface would give way by " +
                       number_text(depth, 3) + " m, at most a tenth of a block's height, " +
                       number_text(height, 3) + " m, is a contact");
}

void validate_depths(const Scene& scene) {
  const CornerSprings& springs = scene.springs;
  for (std::size_t k = 0; k < springs.stiffness.size(); ++k)
    validate_depth(scene, k, "contact.stiffness", springs.stiffness[k], 2);
  for (std::size_t k = 0; k < springs.bed_stiffness.size(); ++k)
    validate_depth(scene, k, "contact.bed_stiffness", springs.bed_stiffness[k],
                   2 * interface_half_width(scene, static_cast<int>(k)));
}

void validate_steps(const Scene& scene) {
  const SpringRate fastest = fastest_spring_rate(scene);
  const double steps = scene.duration * fastest.rate / steps_per_rate;
  if (steps > most_spring_steps)
    throw FieldError(fastest.key, number_text(fastest.value),
                     "such that springs take at most " + number_text(most_spring_steps) +
                         " steps: as fast as " + number_text(fastest.rate, 3) + " rad/s, they would take " +
                         number_text(steps, 3));
}

void validate_unloaded(const Scene& scene) {
  // Depth and pressure of a bed would both be zero all along it, and its two zeros at one place.
  const auto parts = [](const std::vector<double>& values, std::size_t k) {
    return values[k] != (k == 0 ? 0 : values[k - 1]);
  };
  for (std::size_t k = 0; k < scene.springs.bed_stiffness.size(); ++k)
    if (scene.springs.bed_stiffness[k] != rigid && !parts(scene.initial.angles, k) &&
        parts(scene.initial.velocities, k))
      throw FieldError(
          "initial.springs", "unloaded",
          "loaded where a block lies flat on a bed and turns, as block " + std::to_string(k + 1) + " does");
}

}  // namespace

void require_one_each(const char* key, const std::vector<double>& values, std::size_t blocks) {
  if (values.size() != blocks)
    throw FieldError(key, "an array of " + std::to_string(values.size()),
                     "a number, or as many as there are blocks, " + std::to_string(blocks));
}

void validate_springs(const Scene& scene) {
  if (scene.law != Law::compliant) return require_no_springs(scene);
  const CornerSprings& springs = scene.springs;
  validate_each(scene, "contact.stiffness", springs.stiffness, validate_stiffness);
  validate_each(scene, "contact.damping", springs.damping, validate_damping);
  validate_each(scene, "contact.bed_stiffness", springs.bed_stiffness, validate_stiffness);
  validate_each(scene, "contact.bed_damping", springs.bed_damping, validate_damping);
  for (std::size_t k = 0; k < std::min(springs.stiffness.size(), springs.bed_stiffness.size()); ++k)
    if (springs.stiffness[k] != rigid && springs.bed_stiffness[k] != rigid)
      throw FieldError("contact.bed_stiffness." + std::to_string(k + 1),
                       number_text(springs.bed_stiffness[k]),
                       "inf where contact.stiffness is not: an interface has springs at corners or a bed");
  require_positive("contact.tangential", springs.tangential);
  require_effect(springs);
  validate_depths(scene);
  validate_steps(scene);
  if (!scene.initial.settled) validate_unloaded(scene);
}

}  // namespace rockstack
