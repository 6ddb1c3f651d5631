#include "tests/analytic/proof/stack.hpp"

namespace rockstack::proof {
namespace {

Ball larger(const Ball& a, const Ball& b) {
  Ball result;
  arb_max(result.data(), a.data(), b.data(), working_bits);
  return result;
}
Ball smaller(const Ball& a, const Ball& b) {
  return -larger(-a, -b);
}

/// Halfway between a block on its side and its balance uphill, which is 0.02 before that side at most.
Ball toppling_angle(const ExactBlock& block, const Rational& half_width, const Rational& inclination) {
  const Ball height(block.half_height + block.offset_y);
  const Ball side = half_turn() / 2;
  const Ball balance = larger(arctangent(half_width - block.offset_x, height),
                              arctangent(half_width + block.offset_x, height));
  if (inclination.sign() == 0) return (balance + side) / 2;
  const Ball uphill = smaller(balance + magnitude(Ball(inclination)), side - Ball(decimal("0.02")));
  return (larger(balance, uphill) + side) / 2;
}

}  // namespace

std::string letters(const Pattern& pattern) {
  std::string result;
  for (const int side : pattern) result += side > 0 ? 'R' : side < 0 ? 'L' : 'C';
  return result;
}

Stack make_stack(const ExactScene& scene) {
  const SineCosine<Ball> slope = sine_cosine(Ball(scene.inclination), Ball());
  Stack stack;
  stack.gravity = Ball(scene.gravity) * slope.cosine;
  stack.downhill = Ball(scene.gravity) * slope.sine;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const ExactBlock& block = scene.blocks[k];
    const bool overhangs = k > 0 && scene.blocks[k - 1].half_width < block.half_width;
    const Rational half_width = overhangs ? scene.blocks[k - 1].half_width : block.half_width;
    stack.half_width.emplace_back(half_width);
    stack.height.emplace_back(block.half_height * 2);
    stack.centre_x.emplace_back(block.offset_x);
    stack.centre_y.emplace_back(block.half_height + block.offset_y);
    stack.mass.emplace_back(block.mass);
    stack.inertia.emplace_back(block.inertia);
    stack.toppling_angle.push_back(toppling_angle(block, half_width, scene.inclination));
    stack.overhangs.push_back(overhangs);
  }
  return stack;
}

}  // namespace rockstack::proof
