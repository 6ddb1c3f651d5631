#pragma once

#include <filesystem>
#include <vector>

#include "tests/analytic/proof/ball.hpp"

namespace rockstack::proof {

/// One block, by its fractions. SI units.
struct ExactBlock {
  Rational half_width, half_height;
  Rational mass, inertia;
  Rational offset_x, offset_y;  ///< of the centre of mass from the block's middle, to the right and up
};

/// The acceleration of the ground along one axis: samples at an interval, linear between them, or a pulse.
struct ExactMotion {
  enum class Shape { none, samples, sine, cosine, rectangle, mavroeidis_papageorgiou };
  Shape shape = Shape::none;
  Rational interval = {};              ///< s
  std::vector<Rational> samples = {};  ///< m/s²
  Rational amplitude = {}, period = {}, start = {}, cycles = {}, phase = {};

  Rational length() const { return cycles * period; }  ///< of a pulse, s
};

/// What a scene file says, its decimal texts taken as fractions.
struct ExactScene {
  bool paper = false;  ///< its order of trials after impacts; else the consistent pattern
  Rational duration = {}, gravity = {}, inclination = {};
  std::vector<ExactBlock> blocks = {};
  std::vector<Rational> angles = {}, velocities = {};  ///< absolute, rad and rad/s
  ExactMotion horizontal = {}, vertical = {};
};

/// Reads a scene file by toml++ alone, with nothing of the project's reader; records have one value a line.
/// @throws std::runtime_error for what the prover leaves out: other laws and equations, restitution,
/// synthetic motions, Ricker's pulse, records of other layouts.
ExactScene read_exact_scene(const std::filesystem::path& file);

}  // namespace rockstack::proof
