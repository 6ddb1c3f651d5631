#pragma once

#include "analytic/scene/input/key.hpp"
#include "analytic/scene/pattern.hpp"

namespace rockstack {

// Keys of forces at points of blocks besides contact and weight: pushes and restraints.

inline const KeysOf<Push> push_keys{
    "[[push]]",
    "a force on a block, or an impulse; not with small-angle equations",
    {{"block", "1", "", whole_numbers(1, max_blocks), required_key, "that is pushed, from the bottom up",
      part(&Push::point, &BlockPoint::block)},
     {"height", "0.5", "m", "from 0 to the block's", "half of the block's",
      "of the point that is pushed over the block's lower face, in its middle"},
     {"direction", "0.0", "rad", any_number, "0 to the right, π/2 up; it stays, however the block turns",
      &Push::direction, UsualNumbers{-3.15, 3.15}},
     {"force", "500.0", "N", "a number, or a table of samples or a pulse, as [ground.horizontal] has",
      required_key, "over time; in a table N stand for m/s²"},
     {"from", "0.0", "s", "≥ 0, beside no table", "0", "when the force begins, or the impulse acts"},
     {"to", "1.0", "s", "later, beside a number", "the end of the scene", "when the force ends"},
     {"impulse", "100.0", "N·s", "any number", "instead of force", "at an instant"}}};

/// A point in a file: two numbers.
inline void read_point(const Node& node, BlockPoint& point) {
  const std::vector<double> place = numbers(node);
  if (place.size() != 2) throw wrong_value(node, "[x, y] in m");
  point.x = place[0];
  point.y = place[1];
}

inline const std::vector<NamedChoice> tendons{{"tendon"}}, dampers{{"damper"}};

/// Keys of a kind of restraints: where it is, and its own.
inline KeysOf<Restraint> restraint_table(const char* meaning, const char* example,
                                         const std::vector<NamedChoice>& kinds,
                                         const std::vector<Key<Restraint>>& own) {
  std::vector<Key<Restraint>> rows{
      {"kind", example, kinds, "what it is"},
      {"block", "1", "", whole_numbers(1, max_blocks), required_key, "that it holds, from the bottom up",
       part(&Restraint::from, &BlockPoint::block)},
      {{"point", "[0.0, 1.0]", "m", "[x, y]", required_key,
        "of that block, from the middle of its lower face, to the right and up"},
       [](const Node& node, Restraint& restraint) { read_point(node, restraint.from); }},
      {"to_block", "0", "", whole_numbers(0, max_blocks), "the other block; 0: the ground",
       part(&Restraint::to, &BlockPoint::block)},
      {{"to_point", "[0.0, -1.0]", "m", "[x, y], elsewhere where the stack stands upright", required_key,
        "of the other block; of the ground from the middle of the lowest block's place"},
       [](const Node& node, Restraint& restraint) { read_point(node, restraint.to); }}};
  rows[2].needed = rows[4].needed = "[x, y] in m";
  rows.insert(rows.end(), own.begin(), own.end());
  return {"[[restraint]]", meaning, rows};
}

inline const KeysOf<Restraint> tendon_keys = restraint_table(
    "a tendon between points of two blocks, or of a block and the ground; nonlinear equations, not law compliant",
    "\"tendon\"", tendons,
    {{"stiffness", "1e5", "N/m", above_zero, required_key, "of its force over its length",
      &Restraint::stiffness, UsualNumbers{1e4, 1e9, true}},
     {"prestress", "0.0", "N", from_zero, "its force where the stack stands upright", &Restraint::prestress,
      UsualNumbers{0, 1e6}},
     {"yield", "inf", "N", by_itself("> prestress, or inf"), "force at which it yields", &Restraint::yield}});

inline const KeysOf<Restraint> damper_keys = restraint_table(
    "a damper between such points, whose restraint is viscous", "\"damper\"", dampers,
    {{"damping", "1e4", "N·s/m", above_zero, required_key, "of its force over the rate of its length",
      &Restraint::damping, UsualNumbers{1, 1e6, true}}});

inline const KeysOf<Restraint>& keys_of(RestraintKind kind) {
  return kind == RestraintKind::tendon ? tendon_keys : damper_keys;
}

}  // namespace rockstack
