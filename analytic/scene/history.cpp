#include "analytic/scene/history.hpp"

#include <stdexcept>

namespace rockstack {
namespace {

/// One of the first `size` values of an enumeration.
template <class Enumeration>
Enumeration named(std::string_view text, int size) {
  for (int i = 0; i < size; ++i)
    if (name(static_cast<Enumeration>(i)) == text) return static_cast<Enumeration>(i);
  throw std::invalid_argument("\"" + std::string(text) + "\": must be a name that results have");
}

}  // namespace

std::string name(EventKind kind) {
  static constexpr std::array names{"opening", "impact",  "closure", "rest", "topple", "lift-off",
                                    "slip",    "stick",   "corner",  "fall", "touch",  "part",
                                    "strike",  "impulse", "slack",   "taut", "yield",  "unload"};
  return names[static_cast<std::size_t>(kind)];
}

std::string name(Consistency consistency) {
  static constexpr std::array names{"consistent", "other", "none", "several", "gains"};
  return names[static_cast<std::size_t>(consistency)];
}

EventKind named_event(std::string_view text) {
  return named<EventKind>(text, static_cast<int>(EventKind::unload) + 1);
}

Consistency named_consistency(std::string_view text) {
  return named<Consistency>(text, static_cast<int>(Consistency::gains) + 1);
}

}  // namespace rockstack
