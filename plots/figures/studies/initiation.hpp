#pragma once

#include <string>
#include <vector>

namespace rockstack::plots {

/// A uniform block at rest that a rectangular pulse of horizontal acceleration a strikes, and in step with it
/// a vertical one of `vertical` times a, up positive.
struct StruckBlock {
  double slenderness_ratio = 0;  ///< r, height over width
  double gravity = 0;            ///< m/s²
  double vertical = 0;
};

/// The least friction coefficient with which a block of ratio r that a pulse of A times gravity tilts does
/// not slip: [A (4 + r²) + 3 r] / [1 + 4 r² + 3 A r]. Shenton 1996, Journal of Engineering Mechanics 122,
/// 690–693.
double rocking_friction(double slenderness_ratio, double push);

/// The boundaries between rest, slide, rock, slide-rock and free flight over a, in m/s², and friction, up to
/// either's largest value: gnuplot's lines of points, an empty one between lines. Vertical motion changes
/// gravity to g + `vertical` a.
std::string initiation_boundaries(const StruckBlock& block, double largest_acceleration,
                                  double largest_friction);

}  // namespace rockstack::plots
