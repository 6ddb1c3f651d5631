#include <cmath>
#include <numbers>

#include "tests/analytic/paper/checks.hpp"
#include "tests/analytic/paper/first_principles.hpp"
#include "tests/analytic/paper/transition.hpp"

namespace rockstack::paper {
namespace {

using Inequality = double (*)(const Geometry&, const Motion&, Reading);

double eq29_as_printed(const Geometry& q, const Motion& s, Reading) {
  return eq29(q, s);
}

/// The drawn motion in pattern 3 or 4, in the paper's subcase.
Motion in_subcase(Draw d, double S, Motion (*pattern)(const Draw&)) {
  d.S = S;
  return pattern(d);
}

/// From pattern 3: the blocks turn as one about `base`; the top opens about `corner` when its moment about
/// that is past zero, clockwise about the right one.
Check top_opens(Inequality inequality, int base, int corner) {
  return [=](const Draw& d, Reading reading) {
    const Motion s = in_subcase(d, base, in_pattern_3);
    const Assembly blocks = assemble(d.q, {base, corner}, s);
    const double margin = -corner * moment_on_top(blocks, s, blocks.top_pivot);
    return std::abs(d.q.m2 * d.q.r2 * inequality(d.q, s, reading) - margin) / moment_size(d.q, s);
  };
}

/// From pattern 4: the top turns about `top`; the base opens about `corner`.
Check base_opens(Inequality inequality, int top, int corner) {
  return [=](const Draw& d, Reading reading) {
    const Motion s = in_subcase(d, top, in_pattern_4);
    const double margin = -corner * moment_on_base(assemble(d.q, {corner, top}, s), s);
    return std::abs(inequality(d.q, s, reading) - margin) / moment_size(d.q, s);
  };
}

}  // namespace

void add_transition(std::map<int, Check>& all) {
  all[29] = top_opens(eq29_as_printed, 1, 1);
  all[30] = [](const Draw& d, Reading) {
    const Vec line = assemble(d.q, {1, 1}, {}).top.centre - ground_corner(d.q, 1);
    return std::abs(eq30(d.q) - std::hypot(line.x, line.y)) / d.q.d;
  };
  all[31] = [](const Draw& d, Reading) {
    const Vec line = assemble(d.q, {1, 1}, {}).top.centre - ground_corner(d.q, 1);
    return std::abs(d.q.nu - std::atan2(line.y, -line.x)) / std::numbers::pi;
  };
  all[32] = top_opens(eq32, 1, -1);
  all[33] = top_opens(eq33, -1, -1);
  all[34] = top_opens(eq34, -1, 1);
  all[35] = base_opens(eq35, 1, 1);
  all[36] = [](const Draw& d, Reading) {
    const Vec line = assemble(d.q, {1, 1}, {}).top_right - ground_corner(d.q, 1);
    return std::abs(d.q.xi + line.x) / d.q.b1;
  };
  all[37] = base_opens(eq37, -1, -1);
  all[38] = base_opens(eq38, -1, 1);
  all[39] = [](const Draw& d, Reading) {
    const Vec line = assemble(d.q, {1, 1}, {}).top_left - ground_corner(d.q, 1);
    return std::abs(d.q.xi_ + line.x) / d.q.b1;
  };
  all[40] = base_opens(eq40, 1, -1);
}

}  // namespace rockstack::paper
