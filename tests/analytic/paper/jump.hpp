#pragma once

#include "tests/analytic/paper/checks.hpp"
#include "tests/analytic/paper/first_principles.hpp"
#include "tests/analytic/paper/impact.hpp"

namespace rockstack::paper {

/// How the blocks move before an impact: on their own, as one (pattern 3), or the top alone (pattern 4).
enum class Coming { both, joined, top_only };

/// An impact of the paper: pivots before and after, what may turn, and the angles at which it happens.
struct Jump {
  Sides before, after;
  Coming coming = Coming::both;
  Freedom leaving = Freedom::both;
  Angles (*angles)(const Draw&) = nullptr;
};

// Angles at an impact of subcase a.
Angles base_hits_from_1(const Draw& d);
Angles base_hits_from_2(const Draw& d);
Angles blocks_meet(const Draw& d);
Angles flat(const Draw& d);

/// What is conserved: momentum of the system about the base's pivot after the impact, and of the top block
/// about its.
enum class About { system, top };

/// The drawn velocities before an impact, as far as its pattern allows them.
Velocities coming(const Jump& jump, const Draw& d);

/// Momentum by first principles, for velocities before or after.
double momentum(const Jump& jump, const Draw& d, When when, About about, const Velocities& rates);

/// An angular momentum of the paper against first principles.
double momentum_error(const Jump& jump, const Draw& d, const Momentum& printed, When when, About about);

/// One coefficient against the momentum of a unit velocity.
double coefficient_error(const Jump& jump, const Draw& d, double printed, When when, About about,
                         const Velocities& unit);

/// Change of a momentum across the impact, with velocities after by the least kinetic energy of change.
double conservation_error(const Jump& jump, const Draw& d, About about);

/// Velocities after an impact against those nearest in energy. `minus` as coming() gives it.
struct Errors {
  double base, top;
};
Errors velocity_errors(const Jump& jump, const Draw& d, const Velocities& minus, const Velocities& printed);

}  // namespace rockstack::paper
