#include "analytic/unilateral/contact_history.hpp"

namespace rockstack {

std::string name(ContactEventKind kind) {
  constexpr const char* names[] = {"opening", "lift-off", "slip", "stick",  "corner",
                                   "impact",  "closure",  "rest", "topple", "fall"};
  return names[static_cast<std::size_t>(kind)];
}

}  // namespace rockstack
