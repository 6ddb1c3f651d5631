#pragma once

#include "analytic/scene/input/fields.hpp"

namespace rockstack {

// The keys of a study of impact laws; its engines are as in a suite.

inline constexpr KeyTable impact_law_keys{
    "",
    "a study of impact laws, which is run as a suite is: how often do they differ?",
    {{"study", "\"impact-laws\"", "", "\"impact-laws\"", required_key, "what the file is"},
     {"title", "\"Laws\"", "", "a text", required_key, "heads figures"},
     {"seed", "1", "", "a whole number from 0 to 2⁵³", "1", "of drawn impacts"},
     {"samples", "400", "", "a whole number from 1 to 10⁶", "400", "impacts in each cell, for each kind"},
     {"cells", "8", "", "a whole number from 1 to 100", "8", "along either axis of the grid"},
     {"blocks", "[2, 3]", "", "of 2, 3", "[2, 3]", "in a stack"},
     {"aspect_ratio", "[0.25, 8.0]", "", "two numbers > 0", "[0.25, 8]",
      "height over width of the top block"},
     {"mass_ratio", "[0.05, 20.0]", "", "two numbers > 0", "[0.05, 20]", "of a block to the one below"},
     {"base_aspect_ratio", "[0.25, 8.0]", "", "two numbers > 0", "[0.25, 8]",
      "height over width of the others"},
     {"width_ratio", "[0.3, 1.0]", "", "two numbers > 0", "[0.3, 1]", "of a block to the one below"},
     {"largest_angle", "0.3", "rad", "> 0, up to 0.78", "0.3", "of an open interface that does not impact"},
     {"speed", "[0.05, 0.5]", "√(g/height)", "two numbers > 0", "[0.05, 0.5]",
      "largest relative rate before"},
     {"least_clearness", "0.1", "", "> 0", "0.1", "of the cases that engines are asked"},
     {"engines", "", "", "tables [[engines]], as in a suite", "none: the laws alone", "which are asked"}}};

inline constexpr std::initializer_list<const KeyTable*> impact_law_tables{&impact_law_keys};

}  // namespace rockstack
