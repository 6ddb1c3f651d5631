#pragma once

#include "tests/analytic/paper/geometry.hpp"

namespace rockstack::paper {

// Two stacked blocks from points, velocities and Newton's laws alone: the reference that the paper's
// equations are held against. Nothing here is taken from the paper but the meaning of its angles, and nothing
// from the solver.

struct Vec {
  double x = 0, y = 0;
};

Vec operator+(Vec a, Vec b);
Vec operator-(Vec a, Vec b);
Vec operator*(double k, Vec a);

/// Clockwise moment of a force about the origin of its arm; likewise of a momentum.
double moment(Vec arm, Vec force);

/// A body as it moves. Clockwise positive, SI units per metre of depth.
struct Body {
  double mass = 0, inertia = 0;
  Vec centre, velocity, acceleration;
  double rate = 0, spin = 0;  ///< angular velocity and acceleration
};

/// On which side the pivots under the two blocks lie: +1 right, −1 left.
struct Sides {
  int base = 1, top = 1;
};

/// The two blocks as a chain of two hinges. The origin is the middle of the base's place at rest.
struct Assembly {
  Body base, top;
  Vec base_pivot, top_pivot;
  Vec top_right, top_left;  ///< O2, O2'
};

/// Blocks that turn about the given pivots.
Assembly assemble(const Geometry& q, const Sides& sides, const Motion& motion);

/// The two corners of the base: O1 (+1) and O1' (−1) at rest.
Vec ground_corner(const Geometry& q, int side);

/// Angular momentum of a body about a point, summed over two equal point masses that have the body's mass,
/// centre and inertia.
double angular_momentum(const Body& body, Vec about);
double angular_momentum(const Assembly& blocks, Vec about);

/// Kinetic energy from the same two point masses, J.
double kinetic_energy(const Body& body);
double kinetic_energy(const Assembly& blocks);

/// Newton–Euler: the moment about its pivot that would have to act on the top block for it to move as stated,
/// in addition to its weight, on ground that accelerates. Zero in free motion. N·m.
double moment_on_top(const Assembly& blocks, const Motion& motion, Vec about);

/// Moment on the base, which carries the top block's force at the top block's pivot.
double moment_on_base(const Assembly& blocks, const Motion& motion);

/// Moment on both blocks as one body, about the base's pivot.
double moment_on_both(const Assembly& blocks, const Motion& motion);

/// What may turn after an impact.
enum class Freedom { both, joined, top_only };

/// Velocities after an impact that leaves the blocks turning about `sides`: the allowed motion that is
/// nearest to the motion before in the metric of kinetic energy. `angles` are those at the impact.
Velocities nearest_in_energy(const Geometry& q, const Assembly& before, const Sides& sides,
                             const Angles& angles, Freedom freedom);

}  // namespace rockstack::paper
