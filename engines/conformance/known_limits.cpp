#include "engines/conformance/known_limits.hpp"

namespace rockstack {

std::string known_limit(const std::string& /*engine*/, const std::string& solver, const std::string& settings,
                        const std::string& check) {
  const bool slides = check == "SlidingBlockStops" || check == "EachInterfaceHasItsFriction" ||
                      check == "WithoutFrictionBlocksSlideOn";
  if (slides && solver == "mlcp-lemke") {
    return "Bullet's Lemke solver takes the coefficient of friction for a bound on the impulse";
  }
  if (settings != "default") return "";
  if (solver == "mlcp-lemke") {
    return "with its defaults, Bullet's Lemke solver throws resting blocks about";
  }
  if (check == "FlatLandingDoesNotBounce") {
    return "by default an overlap goes into the velocities: the block bounces by a fifth, without "
           "restitution";
  }
  if (solver == "quickstep" && check == "WeakPushDoesNotRock") {
    return "after 20 iterations QuickStep's contacts still let a block turn, twice as far as one step's fall";
  }
  if (solver == "quickstep" && check == "MotionStaysInThePlane") {
    return "after 20 iterations QuickStep's planar joints still let blocks out of the plane, by 0.2 mm";
  }
  return "";
}

}  // namespace rockstack
