#include "tests/analytic/paper/checks.hpp"

namespace rockstack::paper {

const std::map<int, Check>& checks() {
  static const std::map<int, Check> all = [] {
    std::map<int, Check> result;
    for (const auto add :
         {add_initiation, add_motion, add_linear, add_transition, add_momentum, add_impact_pattern_1,
          add_impact_pattern_2, add_impact_pattern_3, add_impact_pattern_4})
      add(result);
    return result;
  }();
  return all;
}

}  // namespace rockstack::paper
