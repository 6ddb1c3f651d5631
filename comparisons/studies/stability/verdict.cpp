#include "comparisons/studies/stability/study.hpp"

#include <fmt/format.h>

namespace rockstack {
namespace {

/// What measures of a scene are shares of.
struct Scale {
  double height = std::numeric_limits<double>::infinity();       ///< of the smallest block, m
  double width = std::numeric_limits<double>::infinity();        ///< of the narrowest interface, m
  double slenderness = std::numeric_limits<double>::infinity();  ///< of the most slender block, rad
  double rate = 0;                                               ///< √(g/H), 1/s
  double tipping = 0;  ///< energy that tips the stack over as one block, of weight times height of centre
};

Scale scale_of(const Scene& scene) {
  Scale scale;
  double mass = 0;
  double moment = 0;
  double height = 0;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const Block& block = scene.blocks[k];
    const double half_width = interface_half_width(scene, static_cast<int>(k));
    scale.height = std::min(scale.height, 2 * block.half_height);
    scale.width = std::min(scale.width, 2 * half_width);
    scale.slenderness = std::min(scale.slenderness, slenderness(scene, static_cast<int>(k)));
    mass += block.mass;
    moment += block.mass * (height + block.half_height);
    height += 2 * block.half_height;
  }
  scale.rate = std::sqrt(scene.gravity / height);
  scale.tipping = std::hypot(1, interface_half_width(scene, 0) * mass / moment) - 1;
  return scale;
}

/// A measure in a unit, and how many of it are too much.
struct Check {
  const char* label;
  std::optional<double> value;
  double unit, limit;
};

/// The first measure beyond its limit, in words; empty where there is none.
std::string first_beyond(std::initializer_list<Check> checks) {
  for (const Check& one : checks) {
    if (!one.value) continue;
    const double share = std::abs(*one.value) / one.unit;
    if (!(share <= one.limit)) return fmt::format("{} {:.3g}, limit {:g}", one.label, share, one.limit);
  }
  return "";
}

}  // namespace

std::string name(Soundness soundness) {
  constexpr std::array names{"sound", "inexact", "unstable", "failed"};
  return names.at(static_cast<std::size_t>(soundness));
}

StabilityVerdict judge_stability(const RunMetrics& row, const Scene& scene) {
  constexpr StabilityLimits limits = stability_limits;
  if (row.status != RunStatus::done) return {Soundness::failed, name(row.status) + ": " + row.reason};
  const Scale scale = scale_of(scene);
  std::string unstable = first_beyond(
      {{"energy gained, of what tips the stack over,", row.energy_gain, scale.tipping,
        limits.unstable_energy},
       {"a block thrown up, of the smallest height,", row.gap, scale.height, limits.unstable_gap},
       {"tilt out of the plane", row.out_of_plane_tilt, 1, limits.unstable_tilt}});
  if (unstable.empty() && row.toppling_verdict == TopplingVerdict::engine_alone)
    unstable = "topples though the exact solution does not";
  if (!unstable.empty()) return {Soundness::unstable, unstable};
  if (row.toppling_verdict == TopplingVerdict::exact_alone)
    return {Soundness::inexact, "stands though the exact solution topples"};
  const std::string inexact = first_beyond(
      {{"energy gained, of what tips the stack over,", row.energy_gain, scale.tipping, limits.energy},
       {"penetration, of the smallest height,", row.penetration, scale.height, limits.penetration},
       {"slip, of the narrowest width,", row.slip, scale.width, limits.slip},
       {"way out of the plane, of the narrowest width,", row.out_of_plane, scale.width, limits.out_of_plane},
       {"motion left at rest, of sqrt(g/H),", row.residual_motion, scale.rate, limits.residual},
       {"angle off, of the least slenderness,", row.largest_angle_difference, scale.slenderness,
        limits.angle}});
  if (!inexact.empty()) return {Soundness::inexact, inexact};
  return {};
}

}  // namespace rockstack
