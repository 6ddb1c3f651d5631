#include "engines/conformance/check.hpp"

#include <fmt/format.h>

#include <utility>

namespace rockstack {
namespace {

/// An empty text stands for all; engines and checks have blanks between them.
struct Limit {
  std::string_view engines, solver, settings;
  const char* reason;
  std::string_view checks;
};

constexpr std::array limits{
    Limit{"", "mlcp-lemke", "",
          "Bullet's Lemke solver takes the coefficient of friction for a bound on the impulse",
          "SlidingBlockStops EachInterfaceHasItsFriction WithoutFrictionBlocksSlideOn"},
    Limit{"", "mlcp-lemke", "default", "with its defaults, Bullet's Lemke solver throws resting blocks about",
          ""},
    Limit{"bullet bullet-single ode", "", "default",
          "by default an overlap goes into the velocities: the block bounces by a fifth, without restitution",
          "FlatLandingDoesNotBounce"},
    Limit{
        "dart", "", "default",
        "FCL, DART's own choice of a detector, takes boxes for meshes: corners of faces on each other lack a normal",
        "EachInterfaceHasItsFriction WithoutFrictionBlocksSlideOn PairMeetsTheGroundInTime"},
    Limit{"mujoco mujoco-js", "", "default",
          "by default contacts are damped so little that a block bounces by an eighth (solref_dampratio 1)",
          "FlatLandingDoesNotBounce"},
    Limit{"mujoco mujoco-js", "pgs", "default",
          "with blocks of tonnes MuJoCo's PGS takes small friction in elliptic cones for none",
          "EachInterfaceHasItsFriction"},
    // With solimp at 0.995 alone these checks hold, with solref_dampratio at 6 a block lands flat, and with
    // masses a hundredth as large PGS has its friction.
    Limit{"mujoco mujoco-js", "", "default",
          "by default contacts give way by a tenth, whatever the step (solimp 0.9)",
          "FirstStepIsFreeFallOrAHinge WithoutFrictionBlocksSlideOn WeakPushDoesNotRock StrongPushRocks "
          "QuarterPeriodIsHousners QuarterPeriodErrorIsOfFirstOrder ImpactLosesHousnersShare "
          "PairMeetsTheGroundInTime"},
    Limit{"mujoco mujoco-js", "", "default",
          "by default a contact takes 20 ms to carry a block, which sinks by 0.4 mm (solref_timeconst)",
          "StackKeepsItsHeight"},
    Limit{"ode", "quickstep", "default",
          "after 20 iterations QuickStep's contacts still let a block turn, twice as far as one step's fall",
          "WeakPushDoesNotRock"},
    Limit{"ode", "quickstep", "default",
          "after 20 iterations QuickStep's planar joints still let blocks out of the plane, by 0.2 mm",
          "MotionStaysInThePlane"},
    Limit{
        "box2d planck", "", "default",
        "by default, not with polygonRadius = 0, Box2D's polygons have a skin of 1 cm: blocks that touch overlap "
        "by 2 cm and are pushed apart",
        "FreeFallIsTheSchemes BlockAtRestStays StackAtRestStays StackKeepsItsHeight "
        "WithoutFrictionBlocksSlideOn WeakPushDoesNotRock QuarterPeriodIsHousners "
        "QuarterPeriodErrorIsOfFirstOrder ImpactLosesHousnersShare PairMeetsTheGroundInTime"},
    Limit{"chipmunk", "", "default",
          "after 10 iterations, not after 50, Chipmunk's contacts still let a flat block turn: it slides "
          "on down that slope",
          "WithoutFrictionBlocksSlideOn"},
    Limit{"siconos", "nsgs", "default",
          "Gauss–Seidel's own tolerance of 1e-4 leaves the block 5 µm off; with 1e-8 it is 0.6 nm",
          "WithoutFrictionBlocksSlideOn"},
    // Each holds, or fails, where this alone is changed in the default or the tuned set (README.md of each
    // engine).
    Limit{
        "simbody", "", "default",
        "by default Simbody's friction fades below 1 cm/s of slip: what sticks creeps (transition_velocity)",
        "FirstStepIsFreeFallOrAHinge QuarterPeriodIsHousners QuarterPeriodErrorIsOfFirstOrder"},
    Limit{
        "simbody", "", "default",
        "by default a contact is a spring of 1e8 N/m, in which a block of tonnes sinks by 0.1 mm (stiffness)",
        "StackKeepsItsHeight WithoutFrictionBlocksSlideOn WeakPushDoesNotRock StrongPushRocks "
        "ImpactLosesHousnersShare"},
    Limit{"simbody", "", "default",
          "by default contacts are damped so little that a block bounces by half (dissipation)",
          "FlatLandingDoesNotBounce PairMeetsTheGroundInTime"},
    Limit{"simbody", "", "default",
          "an accuracy of 1e-3, Simbody's own, parts a motion from its mirror image; 1e-7 alone does not",
          "MirroredSceneMirrorsMotion"},
    Limit{
        "physx", "", "default",
        "by default, not with frictionOffsetThreshold = 1 mm, a corner 4 cm above the ground brakes in PhysX",
        "MirroredSceneMirrorsMotion QuarterPeriodIsHousners QuarterPeriodErrorIsOfFirstOrder "
        "ImpactLosesHousnersShare"},
    Limit{"physx", "pgs", "",
          "after one velocity iteration, not after 50, PhysX's PGS still lets a block sink on one side",
          "FirstStepIsFreeFallOrAHinge WeakPushDoesNotRock StrongPushRocks"},
    Limit{"physx", "tgs", "tuned", "4 position iterations, not 32, leave PhysX's TGS 0.25 % off",
          "FirstStepIsFreeFallOrAHinge"},
    Limit{"rapier", "", "default",
          "by default, not with lengthUnit = 5 cm, Rapier leaves overlaps of millimetres alone",
          "QuarterPeriodIsHousners QuarterPeriodErrorIsOfFirstOrder ImpactLosesHousnersShare "
          "PairMeetsTheGroundInTime"},
    Limit{"rapier", "", "default", "after 4 iterations, not after 20, Rapier's contacts still give way",
          "StackKeepsItsHeight WeakPushDoesNotRock StrongPushRocks"},
    Limit{
        "rapier", "", "",
        "in single precision a place is rounded in each substep: with 50 of them by 80 µm in the end, with one not",
        "WithoutFrictionBlocksSlideOn"},
    Limit{
        "cannon-es", "", "default",
        "by default contacts of cannon-es are springs that are soft for tonnes (unitMass, "
        "contactEquationStiffness, iterations)",
        "FirstStepIsFreeFallOrAHinge StackKeepsItsHeight PushedBlockDoesNotSlide WithoutFrictionBlocksSlideOn "
        "WeakPushDoesNotRock StrongPushRocks QuarterPeriodIsHousners QuarterPeriodErrorIsOfFirstOrder "
        "ImpactLosesHousnersShare PairMeetsTheGroundInTime"},
    Limit{
        "cannon-es", "", "",
        "cannon-es takes friction's bound of a contact point, μ m g, for an impulse: at 1 ms a thousand times as "
        "much",
        "SlidingBlockStops EachInterfaceHasItsFriction"},
    Limit{
        "cannon-es", "", "default",
        "with contactEquationRelaxation = 3, not with 10, cannon-es lets a block bounce by a fifth and more",
        "FlatLandingDoesNotBounce"},
    Limit{"havok", "", "", "until it moves at 0.1 m/s, a body in Havok has 31/32 of what gravity gives it",
          "FreeFallIsTheSchemes FirstStepIsFreeFallOrAHinge"},
    // With either idealStepTime, at any step; the binary is closed.
    Limit{"havok", "", "", "Havok's blocks turn late about a corner, by a sixth of the time that it takes",
          "StrongPushRocks QuarterPeriodIsHousners QuarterPeriodErrorIsOfFirstOrder ImpactLosesHousnersShare "
          "TopplesFromItsSlenderness PairMeetsTheGroundInTime"},
    Limit{"havok", "", "default",
          "with its idealStepTime of 1/60 s, not with 0, Havok's contacts are soft at 1 ms",
          "StackAtRestStays StackKeepsItsHeight WithoutFrictionBlocksSlideOn WeakPushDoesNotRock"},
    Limit{"havok", "", "tuned",
          "with idealStepTime = 0, not with 1/60 s, a block in Havok bounces by a tenth",
          "FlatLandingDoesNotBounce"},
    Limit{"havok", "", "", "Havok has no locks, and nothing holds its blocks in the plane",
          "MotionStaysInThePlane"},
    Limit{"havok", "", "",
          "two blocks of Havok that fly lose 0.3 % of what they exchange, and miss each other with "
          "idealStepTime = 0; the binary is closed",
          "PairKeepsItsMomentum"},
};

/// Whether words with blanks between them have this one among them, or are none at all.
bool fits(std::string_view words, const std::string& word) {
  return words.empty() || fmt::format(" {} ", words).find(" " + word + " ") != std::string::npos;
}

}  // namespace

Scene at_rest(std::vector<Block> blocks, double duration) {
  Scene scene;
  scene.duration = duration;
  scene.initial.angles.assign(blocks.size(), 0);
  scene.initial.velocities.assign(blocks.size(), 0);
  scene.blocks = std::move(blocks);
  return scene;
}

GroundMotion constant(double value) {
  GroundMotion motion;
  motion.interval = 10;
  motion.samples = {value, value};
  return motion;
}

Scene slender_block(double duration) {
  Scene scene = at_rest({make_block(0.4, 2, 2500)}, duration);
  scene.initial.angles = {0.5 * std::atan(0.2)};
  return scene;
}

Scene paper_scene(double duration) {
  Scene scene = at_rest({make_block(1.25, 1.25, 2500), make_block(1, 2.5, 2500)}, duration);
  scene.initial.angles = {0.15, 0.15};
  return scene;
}

ObservedMotion run(const Adapter& adapter, const Scene& scene, double dt) {
  const Setup setup = set_up(scene, dt, adapter.parameters);
  Trajectory trajectory = adapter.run(setup, adapter.parameters);
  std::vector<BodyState> bodies = trajectory.bodies;
  return {account_of(scene, setup, std::move(trajectory), false).history, std::move(bodies)};
}

Adapter by_force(Adapter adapter) {
  if (adapter.parameters.count("shaking") != 0) adapter.parameters["shaking"] = 0;
  return adapter;
}

double rounding(const Adapter& adapter) {
  return adapter.single_precision ? std::numeric_limits<float>::epsilon()
                                  : std::numeric_limits<double>::epsilon();
}

double short_step(const Adapter& adapter) {
  return rounding(adapter) > 1e-10 ? 1e-3 : 1e-4;
}

double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

Housner::Housner() : slenderness(std::atan(0.2)), frequency(std::sqrt(3 * 9.81 / (4 * std::hypot(0.2, 1)))) {}

double Housner::speed_at_ground(double angle) const {
  return frequency * std::sqrt(2 * (std::cos(slenderness - angle) - std::cos(slenderness)));
}

double quarter_period(const Housner& block, double start) {
  // Simpson's rule with θ = start − u², which takes the root singularity away; 200 pieces leave less than
  // 1e-9 s.
  const auto integrand = [&](double u) {
    const double lean = block.slenderness - start;
    // (cos(lean) − cos(lean + u²)) / u², by the product of sines, with its limit at u = 0
    const double half = 0.5 * u * u;
    const double ratio = half > 0 ? std::sin(half) / half : 1;
    return 2 / (block.frequency * std::sqrt(2 * std::sin(lean + half) * ratio));
  };
  const int pieces = 200;
  const double width = std::sqrt(start) / pieces;
  double sum = 0;
  for (int i = 0; i < pieces; ++i)
    sum += integrand(i * width) + 4 * integrand((i + 0.5) * width) + integrand((i + 1) * width);
  return sum * width / 6;
}

double first_ground_impact(const History& history) {
  for (std::size_t i = 1; i < history.size(); ++i) {
    const double before = history.angles_at(i - 1)[0];
    const double after = history.angles_at(i)[0];
    if (after > 0) continue;
    return history.times[i - 1] + (history.times[i] - history.times[i - 1]) * before / (before - after);
  }
  return std::nan("");
}

const std::vector<Check>& checks() {
  static const std::vector<Check> list{
      {"InitialStateIsTheScenes", initial_state_is_the_scenes},
      {"SameRunGivesTheSameBits", same_run_gives_the_same_bits},
      {"HistoryEndsWhereABlockTopples", history_ends_where_a_block_topples},
      {"FreeFallIsTheSchemes", free_fall_is_the_schemes},
      {"FirstStepIsFreeFallOrAHinge", first_step_is_free_fall_or_a_hinge},
      {"BlockAtRestStays", block_at_rest_stays},
      {"StackAtRestStays", stack_at_rest_stays},
      {"StackKeepsItsHeight", stack_keeps_its_height},
      {"PushedBlockDoesNotSlide", pushed_block_does_not_slide},
      {"SlidingBlockStops", sliding_block_stops},
      {"EachInterfaceHasItsFriction", each_interface_has_its_friction},
      {"WithoutFrictionBlocksSlideOn", without_friction_blocks_slide_on},
      {"WeakPushDoesNotRock", weak_push_does_not_rock},
      {"StrongPushRocks", strong_push_rocks},
      {"MirroredSceneMirrorsMotion", mirrored_scene_mirrors_motion},
      {"FallingGroundIsWeakerGravity", falling_ground_is_weaker_gravity},
      {"QuarterPeriodIsHousners", quarter_period_is_housners},
      {"QuarterPeriodErrorIsOfFirstOrder", quarter_period_error_is_of_first_order},
      {"ImpactLosesHousnersShare", impact_loses_housners_share},
      {"FlatLandingDoesNotBounce", flat_landing_does_not_bounce},
      {"TopplesFromItsSlenderness", topples_from_its_slenderness},
      {"PairKeepsItsMomentum", pair_keeps_its_momentum},
      {"PairMeetsTheGroundInTime", pair_meets_the_ground_in_time},
      {"MotionStaysInThePlane", motion_stays_in_the_plane},
  };
  return list;
}

std::string known_limit(const std::string& engine, const std::string& solver, const std::string& settings,
                        const std::string& check) {
  for (const Limit& limit : limits)
    if (fits(limit.engines, engine) && fits(limit.solver, solver) && fits(limit.settings, settings) &&
        fits(limit.checks, check))
      return limit.reason;
  return "";
}

}  // namespace rockstack
