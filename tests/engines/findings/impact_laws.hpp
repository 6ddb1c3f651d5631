#pragma once

namespace rockstack {

// Laws of one impact: the share of its angular velocity that a block of height over width r keeps as it
// lands, by the coefficient of friction. Without weight.

using ImpactLaw = double (*)(double r, double friction);

/// Friction in the cone that the impulse itself opens.
double left_by_coulomb(double r, double friction);

/// Friction up to a coefficient times the normal impulse that there would be without friction.
double left_by_frictionless(double r, double friction);

/// Friction of a convex cone: a corner that slips at v also leaves the ground, at μ|v| (Anitescu,
/// "Optimization-based simulation of nonsmooth rigid multibody dynamics", Math. Program. 105, 2006, 113-143).
double left_by_convex_cone(double r, double friction);

/// Coulomb's friction against the slip of every moment of the impact (Routh), for a landing corner that
/// slides towards the other one at `slip`, half widths times the angular velocity before. Friction turns
/// round where the corner does. Precondition: it does, and the friction does not stop it. Others take the
/// slip at the end.
double left_by_routh(double r, double friction, double slip);

}  // namespace rockstack
