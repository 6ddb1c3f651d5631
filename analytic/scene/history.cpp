#include "analytic/scene/history.hpp"

#include <array>

namespace rockstack {

std::string name(EventKind kind) {
  static constexpr std::array names{"opening", "impact", "closure", "rest", "topple", "lift-off",
                                    "slip",    "stick",  "corner",  "fall", "touch",  "part"};
  return names[static_cast<std::size_t>(kind)];
}

std::string name(Consistency consistency) {
  static constexpr std::array names{"consistent", "other", "none", "several"};
  return names[static_cast<std::size_t>(consistency)];
}

}  // namespace rockstack
