#pragma once

#include <functional>
#include <map>

#include "tests/analytic/paper/draw.hpp"

namespace rockstack::paper {

/// How far an equation, in a reading, is from first principles on a draw, relative to the size of its terms:
/// round-off where it is right.
using Check = std::function<double(const Draw&, Reading)>;

/// The checks of all equations that state physics, by number.
const std::map<int, Check>& checks();

// The parts of that map, by section of the paper.
void add_initiation(std::map<int, Check>& all);        ///< Section 2.2
void add_motion(std::map<int, Check>& all);            ///< Section 2.3, Eqs. (6)–(18)
void add_linear(std::map<int, Check>& all);            ///< Section 2.3, Eqs. (19)–(28)
void add_transition(std::map<int, Check>& all);        ///< Section 2.4
void add_momentum(std::map<int, Check>& all);          ///< Section 3.2, Eqs. (41)–(45)
void add_impact_pattern_1(std::map<int, Check>& all);  ///< Section 3.2, Eqs. (46)–(86)
void add_impact_pattern_2(std::map<int, Check>& all);  ///< Section 3.3
void add_impact_pattern_3(std::map<int, Check>& all);  ///< Section 4.1
void add_impact_pattern_4(std::map<int, Check>& all);  ///< Section 4.2

}  // namespace rockstack::paper
