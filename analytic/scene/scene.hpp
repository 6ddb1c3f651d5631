#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "analytic/scene/ground/ground_motion.hpp"
#include "analytic/scene/messages/input_error.hpp"

namespace rockstack {

// clang-format off
//                       ___________
//      y               |           |            θ₂ > 0 is clockwise: the block leans to the right and turns about
//      ↑               |  block 2  |            its lower right corner, O₂.
//      |               |     G₂    |
//      |               |           | 2h₂        Interface k lies under block k; interface 1 is the ground.
//      |          O₂'  |___________|  O₂        Its ends are the pivots: right O, left O'.
//      |          ________________________
//      |         |                        |     Angles are absolute, from the vertical; the relative angle of
//      |         |        block 1         |     interface k is φ_k = θ_k − θ_{k−1}, with θ₀ = 0.
//      |         |           G₁           | 2h₁
//      |     O₁' |________________________|  O₁
//      +-----------------------------------------→ x
//                           2b₁
// clang-format on

/// One rigid block, uniform across its depth. SI units.
struct Block {
  double half_width = 0;   ///< b, m, > 0
  double half_height = 0;  ///< h, m, > 0
  double mass = 0;         ///< kg, > 0
  double inertia = 0;      ///< about the centre of mass, kg·m², > 0
  double offset_x = 0;     ///< of the centre of mass from the block's middle, to the right, m, within ±b
  double offset_y = 0;     ///< likewise, up, m, within ±h
};

/// Moment of inertia of a uniform rectangle about its centre, m (b² + h²)/3, kg·m².
inline double rectangle_inertia(double mass, double half_width, double half_height) {
  return mass * (half_width * half_width + half_height * half_height) / 3;
}

/// A uniform block of the given width and height in m and density in kg/m³ per metre of depth.
Block make_block(double width, double height, double density);

/// The model of contact: which pattern follows an impact, and whether blocks may do more than turn.
enum class Law {
  paper,       ///< pivots; the paper's order of trials, see analytic/mechanics/impact.hpp
  consistent,  ///< pivots; the pattern that pushing impulses can bring about, see there
  unilateral,  ///< blocks push, rub by Coulomb's law, slip and lift off, see analytic/unilateral/
  compliant,   ///< the same, with springs, dashpots and sliders at corners, see analytic/unilateral/springs/
};

/// As scene files have them.
inline constexpr std::array law_names{"paper", "consistent", "unilateral", "compliant"};
inline const char* name(Law law) {
  return law_names[static_cast<std::size_t>(law)];
}

/// What a coefficient of restitution e multiplies at contact points.
enum class RestitutionLaw {
  newton,   ///< speeds: a point that meets a face at a speed u leaves it at e u or more
  poisson,  ///< impulses: expansion gives back e of what compression took, or more where points would meet
};

/// The equations of motion between events. Impacts are the same, but that the last two have upright geometry.
enum class Equations {
  nonlinear,  ///< in full
  linear,  ///< geometry frozen upright: Spanos et al. 2001, Eqs. (19)–(28), where weight has a constant lever
  small_angle,  ///< the usual linearisation, Housner 1963: see small_angle_stack() in kinematics.hpp
};

/// As scene files have them.
inline constexpr std::array equation_names{"nonlinear", "linear", "small-angle"};
inline const char* name(Equations equations) {
  return equation_names[static_cast<std::size_t>(equations)];
}

/// The state at t = 0. Relative angles that are zero with zero relative velocity mean closed interfaces.
struct InitialState {
  std::vector<double> angles;      ///< rad, one a block, clockwise positive
  std::vector<double> velocities;  ///< rad/s, one a block
  /// Speeds of blocks along what is below them, m/s, to the right positive, or none; of laws with friction
  /// alone.
  std::vector<double> slip_velocities = {};
  bool preloaded = true;  ///< springs carry what rests on them at the start; else they are not loaded yet
  // One a block, or none; of laws with friction alone.
  std::vector<double> offsets = {};  ///< of its middle from that of what is below, along the face below, m
  std::vector<double> gaps = {};     ///< by which it is above what is below, across the face there, m, ≥ 0
  /// Velocity of the centre of a block with a gap, away from what is below, m/s, as its slip velocity is
  /// then.
  std::vector<double> gap_velocities = {};
};

/// What only laws take under which blocks leave their pivots, by its key.
inline constexpr std::pair<const char*, std::vector<double> InitialState::*> of_free_blocks[] = {
    {"gap_velocities", &InitialState::gap_velocities},
    {"gaps", &InitialState::gaps},
    {"offsets", &InitialState::offsets},
    {"slip_velocities", &InitialState::slip_velocities}};

/// Whether a block starts above what is below it.
inline bool has_gap(const InitialState& initial, std::size_t block) {
  return !initial.gaps.empty() && initial.gaps[block] > 0;
}

/// Springs and dashpots at the corners of each interface, or in a Winkler bed along it, from the ground up;
/// law `compliant` alone. An interface with neither is rigid.
struct CornerSprings {
  std::vector<double> stiffness = {};      ///< k of each corner, N/m, > 0, or infinite: no springs
  std::vector<double> damping = {};        ///< c of each corner, N·s/m, ≥ 0; none: 0
  std::vector<double> bed_stiffness = {};  ///< per length, N/m², > 0, or infinite: no bed; not beside k
  std::vector<double> bed_damping = {};    ///< per length, N·s/m², ≥ 0; none: 0
  double tangential = 1;                   ///< stiffness and damping along a face over those across it, > 0

  bool operator==(const CornerSprings&) const = default;
};

/// A point of a block.
struct BlockPoint {
  int block = 1;  ///< from 1, bottom to top; of restraints also 0, the ground where the lowest one stands
  double x = 0, y = 0;  ///< from the middle of its lower face, in its frame, to the right and up, m
};

/// A force at a point of a block, given over time. Its direction is that of the ground's axes, however the
/// block turns.
struct Push {
  BlockPoint point;
  double direction = 0;  ///< rad; 0 to the right, π/2 up
  GroundMotion force;    ///< N; steps are impulses, N·s
};

/// What a restraint is.
enum class RestraintKind {
  tendon,  ///< elastic, pulls alone, and yields at a force where it has one
  damper,  ///< a force in proportion to the rate of its length, either way
};

/// A restraint between points of two blocks, or of a block and the ground.
struct Restraint {
  RestraintKind kind = RestraintKind::tendon;
  BlockPoint from, to{0, 0, 0};
  double stiffness = 0;                                    ///< N/m, > 0 of a tendon
  double prestress = 0;                                    ///< where the stack stands upright, N
  double yield = std::numeric_limits<double>::infinity();  ///< N
  double damping = 0;                                      ///< N·s/m, > 0 of a damper
};

/// The most restraints of a scene.
inline constexpr std::size_t max_restraints = 8;

/// The most pushes of a scene.
inline constexpr std::size_t max_pushes = 8;

/// A rigid wall at one side of the lowest block, flush with it as it stands: the block rocks to the other
/// side alone. Laws of pivots and one block alone.
struct Wall {
  int side = 0;  ///< −1 left, 1 right; 0: no wall
  /// What a strike leaves of the angular velocity, backwards, 0 … 1; none: wall_restitution() has it.
  std::optional<double> restitution = {};

  bool operator==(const Wall&) const = default;
};

/// One question: a stack of blocks, how it starts, how the ground moves, and for how long. SI units.
struct Scene {
  std::string title;
  double duration = 0;    ///< s, > 0, at most 10⁷ √(R/a), see validate()
  double gravity = 9.81;  ///< m/s², > 0
  /// By which the ground is turned from the level, rad, clockwise positive, at most π/4: it falls to the
  /// right. Angles, x and y are the ground's, and so are both components of its motion.
  double inclination = 0;
  Law law = Law::consistent;  ///< engines follow it; `paper` is that of Spanos et al. 2001
  Equations equations = Equations::nonlinear;
  /// Ratios of interfaces, or none: what an impact leaves of the relative angular velocity, 0 … 1, where that
  /// interface alone was open before and no other opens, so that all above it rocks as one body. Other
  /// impacts, and all without it, have the ratio of the law.
  std::vector<double> restitution = {};
  std::vector<Block> blocks;  ///< bottom to top, 1 … max_blocks
  /// Coulomb's coefficient of each interface, upwards, 0 … largest_friction; none: largest_friction.
  std::vector<double> friction = {};
  /// Coefficient of each interface that slides, 0 … its friction; none: its friction. Not law `compliant`.
  std::vector<double> kinetic_friction = {};
  double point_restitution = 0;  ///< coefficient e of all contact points, 0 … 1; law `unilateral` alone
  RestitutionLaw restitution_law = RestitutionLaw::newton;  ///< of that coefficient
  CornerSprings springs;
  Wall wall;
  InitialState initial;
  GroundMotion horizontal;                 ///< ẍg, positive to the right
  GroundMotion vertical;                   ///< ÿg, positive up
  std::vector<Push> pushes = {};           ///< at most max_pushes
  std::vector<Restraint> restraints = {};  ///< at most max_restraints
  double depth = 1;                        ///< size of blocks out of the plane, which engines need, m, > 0
};

/// Whether more acts than weight, contact and the acceleration of the ground.
inline bool has_applied_forces(const Scene& scene) {
  return !scene.pushes.empty() || !scene.restraints.empty() || !scene.horizontal.steps.empty() ||
         !scene.vertical.steps.empty();
}

/// More friction than this is not told from it.
inline constexpr double largest_friction = 1000;

/// Whether blocks may slip and lift off, so that angles do not tell where they are.
inline bool leaves_pivots(Law law) {
  return law == Law::unilateral || law == Law::compliant;
}

/// Coulomb's coefficient of each interface, from the ground up.
inline std::vector<double> friction_of(const Scene& scene) {
  return scene.friction.empty() ? std::vector<double>(scene.blocks.size(), largest_friction) : scene.friction;
}

/// The coefficient of each interface where it slides, from the ground up.
inline std::vector<double> kinetic_friction_of(const Scene& scene) {
  return scene.kinetic_friction.empty() ? friction_of(scene) : scene.kinetic_friction;
}

/// Gravity in the ground's axes, along it to the right and across it downwards, m/s².
struct Gravity {
  double along, across;
};

inline Gravity gravity_of(const Scene& scene) {
  return {scene.gravity * std::sin(scene.inclination), scene.gravity * std::cos(scene.inclination)};
}

/// Half-width of interface k, from 0: that of the narrower block that meets there; the ground is endless.
double interface_half_width(const Scene& scene, int interface);

/// How far off the face below it the far corner of a block's lower face is where the block has turned by an
/// angle over the end of the interface, no more than a right angle, b of the block and w of the interface:
/// (b + w) sin |φ|. m.
double corner_rise(const Scene& scene, int interface, double angle);

/// Height of all blocks on each other, H, m.
double stack_height(const Scene& scene);

/// The angle of a block's unstable balance over its pivot on level ground, atan(w/h) with w that of its lower
/// interface; the larger one where the centre of mass is off the middle. rad.
double slenderness(const Scene& scene, int block);

/// Angle of balance on one side: 1 where the block leans right, −1 left. rad.
double balance_angle(const Scene& scene, int block, int side);

/// The angle at which a block counts as toppled, rad: halfway between lying on its side, π/2, and its balance
/// uphill, slenderness + |inclination|, or 0.02 before that side where the balance lies beyond it. Past it
/// free motion does not come back, or lies down within 10 mrad; an engine's block on the floor has passed it.
double toppling_angle(const Scene& scene, int block);

/// Checks a motion's numbers; `key` is the motion's own. @throws FieldError.
void validate(const GroundMotion& motion, const std::string& key);

/// Checks every number of a scene, from a file or not, against the range of its key (input/scene_keys.hpp).
/// The duration is at most 10⁷ √(R/a), with R the least half diagonal of a block and a the largest
/// acceleration that gravity, ground and the turning at the start may add up to: blocks that do not come to
/// rest would be followed for ever.
/// @throws FieldError whose text is "key = value: must be …".
void validate(const Scene& scene);

}  // namespace rockstack
