#include "engines/conformance/known_limits.hpp"

#include <array>
#include <string_view>

namespace rockstack {
namespace {

/// An empty text stands for all.
struct Limit {
  std::string_view engine, solver, settings, check;
  const char* reason;
};

constexpr const char* impulse_bound =
    "Bullet's Lemke solver takes the coefficient of friction for a bound on the impulse";
constexpr const char* restless = "with its defaults, Bullet's Lemke solver throws resting blocks about";
constexpr const char* bounce =
    "by default an overlap goes into the velocities: the block bounces by a fifth, without restitution";
/// With solimp at 0.995 alone these checks hold, with solref_dampratio at 6 a block lands flat, and with
/// masses a hundredth as large PGS has its friction.
constexpr const char* yielding = "by default contacts give way by a tenth, whatever the step (solimp 0.9)";
constexpr const char* skin =
    "by default, not with polygonRadius = 0, Box2D's polygons have a skin of 1 cm: blocks that touch overlap "
    "by 2 cm and are pushed apart";

constexpr const char* normals =
    "FCL, DART's own choice of a detector, takes boxes for meshes: corners of faces on each other lack a normal";

/// Each holds, or fails, where this alone is changed in the default or the tuned set (README.md of each
/// engine).
constexpr const char* creeping =
    "by default Simbody's friction fades below 1 cm/s of slip: what sticks creeps (transition_velocity)";
constexpr const char* hard_for_kilograms =
    "by default a contact is a spring of 1e8 N/m, in which a block of tonnes sinks by 0.1 mm (stiffness)";
constexpr const char* undamped =
    "by default contacts are damped so little that a block bounces by half (dissipation)";

constexpr std::array limits{
    Limit{"", "mlcp-lemke", "", "SlidingBlockStops", impulse_bound},
    Limit{"", "mlcp-lemke", "", "EachInterfaceHasItsFriction", impulse_bound},
    Limit{"", "mlcp-lemke", "", "WithoutFrictionBlocksSlideOn", impulse_bound},
    Limit{"", "mlcp-lemke", "default", "", restless},
    Limit{"bullet", "", "default", "FlatLandingDoesNotBounce", bounce},
    Limit{"bullet-single", "", "default", "FlatLandingDoesNotBounce", bounce},
    Limit{"dart", "", "default", "EachInterfaceHasItsFriction", normals},
    Limit{"dart", "", "default", "WithoutFrictionBlocksSlideOn", normals},
    Limit{"dart", "", "default", "PairMeetsTheGroundInTime", normals},
    Limit{"mujoco", "", "default", "FlatLandingDoesNotBounce",
          "by default contacts are damped so little that a block bounces by an eighth (solref_dampratio 1)"},
    Limit{"mujoco", "pgs", "default", "EachInterfaceHasItsFriction",
          "with blocks of tonnes MuJoCo's PGS takes small friction in elliptic cones for none"},
    Limit{"mujoco", "", "default", "FirstStepIsFreeFallOrAHinge", yielding},
    Limit{"mujoco", "", "default", "StackKeepsItsHeight",
          "by default a contact takes 20 ms to carry a block, which sinks by 0.4 mm (solref_timeconst)"},
    Limit{"mujoco", "", "default", "WithoutFrictionBlocksSlideOn", yielding},
    Limit{"mujoco", "", "default", "WeakPushDoesNotRock", yielding},
    Limit{"mujoco", "", "default", "StrongPushRocks", yielding},
    Limit{"mujoco", "", "default", "QuarterPeriodIsHousners", yielding},
    Limit{"mujoco", "", "default", "QuarterPeriodErrorIsOfFirstOrder", yielding},
    Limit{"mujoco", "", "default", "ImpactLosesHousnersShare", yielding},
    Limit{"mujoco", "", "default", "PairMeetsTheGroundInTime", yielding},
    Limit{"ode", "", "default", "FlatLandingDoesNotBounce", bounce},
    Limit{"ode", "quickstep", "default", "WeakPushDoesNotRock",
          "after 20 iterations QuickStep's contacts still let a block turn, twice as far as one step's fall"},
    Limit{"ode", "quickstep", "default", "MotionStaysInThePlane",
          "after 20 iterations QuickStep's planar joints still let blocks out of the plane, by 0.2 mm"},
    Limit{"box2d", "", "default", "FreeFallIsTheSchemes", skin},
    Limit{"box2d", "", "default", "BlockAtRestStays", skin},
    Limit{"box2d", "", "default", "StackAtRestStays", skin},
    Limit{"box2d", "", "default", "StackKeepsItsHeight", skin},
    Limit{"box2d", "", "default", "WithoutFrictionBlocksSlideOn", skin},
    Limit{"box2d", "", "default", "WeakPushDoesNotRock", skin},
    Limit{"box2d", "", "default", "QuarterPeriodIsHousners", skin},
    Limit{"box2d", "", "default", "QuarterPeriodErrorIsOfFirstOrder", skin},
    Limit{"box2d", "", "default", "ImpactLosesHousnersShare", skin},
    Limit{"box2d", "", "default", "PairMeetsTheGroundInTime", skin},
    Limit{"chipmunk", "", "default", "WithoutFrictionBlocksSlideOn",
          "after 10 iterations, not after 50, Chipmunk's contacts still let a flat block turn: it slides on "
          "down that slope"},
    Limit{"siconos", "nsgs", "default", "WithoutFrictionBlocksSlideOn",
          "Gauss–Seidel's own tolerance of 1e-4 leaves the block 5 µm off; with 1e-8 it is 0.6 nm"},
    Limit{"simbody", "", "default", "FirstStepIsFreeFallOrAHinge", creeping},
    Limit{"simbody", "", "default", "QuarterPeriodIsHousners", creeping},
    Limit{"simbody", "", "default", "QuarterPeriodErrorIsOfFirstOrder", creeping},
    Limit{"simbody", "", "default", "StackKeepsItsHeight", hard_for_kilograms},
    Limit{"simbody", "", "default", "WithoutFrictionBlocksSlideOn", hard_for_kilograms},
    Limit{"simbody", "", "default", "WeakPushDoesNotRock", hard_for_kilograms},
    Limit{"simbody", "", "default", "StrongPushRocks", hard_for_kilograms},
    Limit{"simbody", "", "default", "ImpactLosesHousnersShare", hard_for_kilograms},
    Limit{"simbody", "", "default", "FlatLandingDoesNotBounce", undamped},
    Limit{"simbody", "", "default", "PairMeetsTheGroundInTime", undamped},
    Limit{"simbody", "", "default", "MirroredSceneMirrorsMotion",
          "an accuracy of 1e-3, Simbody's own, parts a motion from its mirror image; 1e-7 alone does not"},
};

bool fits(std::string_view pattern, const std::string& text) {
  return pattern.empty() || pattern == text;
}

}  // namespace

std::string known_limit(const std::string& engine, const std::string& solver, const std::string& settings,
                        const std::string& check) {
  for (const Limit& limit : limits) {
    if (fits(limit.engine, engine) && fits(limit.solver, solver) && fits(limit.settings, settings) &&
        fits(limit.check, check))
      return limit.reason;
  }
  return "";
}

}  // namespace rockstack
