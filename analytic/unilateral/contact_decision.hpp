#pragma once

#include <Eigen/Cholesky>
#include <bit>

#include "analytic/scene/branching.hpp"
#include "analytic/unilateral/contact_collision.hpp"
#include "analytic/unilateral/springs/spring_contacts.hpp"

namespace rockstack {

/// What a change at a soft interface is called, if histories tell it. `passes`: a slider is at a face's end.
template <class Real>
std::optional<EventKind> change_of(const Joint<Real>& before, const Joint<Real>& after, bool passes) {
  const auto ends = [](const Joint<Real>& joint) {
    return joint.touch == Contact::closed ? 2 : joint.pivots() ? 1 : 0;
  };
  if (passes) return EventKind::corner;
  if (before.touch != after.touch) return ends(after) < ends(before) ? EventKind::part : EventKind::touch;
  if (before.slip == after.slip) return std::nullopt;
  return before.slip == 0 ? EventKind::slip : EventKind::stick;
}

/// The lowest interface that differs, from 1, and how.
template <class Real>
int lowest_change(const Joints<Real>& from, const Joints<Real>& to) {
  const auto first =
      std::mismatch(from.begin(), from.end(), to.begin(), std::mem_fn(&Joint<Real>::same_mode)).first;
  return static_cast<int>(std::min(first, from.end() - 1) - from.begin()) + 1;
}

/// What a change of contacts without impact is called: the first of these that any interface does.
template <class Real>
EventKind kind_of(const Joints<Real>& from, const Joints<Real>& to) {
  bool parts = false, opens = false, slips = false;
  for (std::size_t k = 0; k < from.size(); ++k) {
    parts = parts || (from[k].touches() && !to[k].touches());
    opens = opens || from[k].touch != to[k].touch;
    slips = slips || (from[k].slip == 0 && to[k].slip != 0);
  }
  return parts   ? EventKind::lift_off
         : opens ? EventKind::opening
         : slips ? EventKind::slip
                 : EventKind::stick;
}

/// Whether friction at a point may turn it onto its face: G_NN ≤ μ |G_NT|; else one interface has one mode.
template <class Real>
bool couples(const TouchingContacts<Real>& contacts, const TouchingInterface<Real>& contact) {
  for (std::size_t i = 0; i < contact.points(); ++i) {
    const std::size_t row = contact.point(i);
    if (contacts.effect(row, row) <= contact.friction * abs(contacts.effect(row, contact.slip())))
      return true;
  }
  return false;
}

/// Whether no more than one motion obeys, whatever forces act. Of two, let each interface that does not slide
/// yet have the way s, −1 or 1, that either slides in, and write λ_T = σ − s μ λ_N. Then the differences of
/// the two motions have Δa_N Δλ_N ≤ 0 and Δa_T Δσ ≤ 0, each by itself. Where the matrix of a over λ_N and σ
/// is positive definite, for every choice of ways, their sum is above zero but for no difference.
template <class Real>
bool one_motion_obeys(const TouchingContacts<Real>& contacts, const Joints<Real>& joints) {
  const auto sticks = [&](const TouchingInterface<Real>& contact) {
    return contacts.problem().slip_before(joints[contact.interface]) == 0;
  };
  const auto& interfaces = contacts.interfaces();
  const auto ways = 1U << std::count_if(interfaces.begin(), interfaces.end(), sticks);
  for (unsigned way = 0; way < ways; ++way) {
    ContactForceRows<Real> rows;
    unsigned rest = way;
    for (const TouchingInterface<Real>& contact : interfaces) {
      add_points(contact,
                 sticks(contact) ? 2 * static_cast<int>(rest & 1U) - 1 : joints[contact.interface].slip,
                 rows);
      if (!sticks(contact)) continue;
      rows.push_back({contact.slip()});
      rest >>= 1U;
    }
    const auto size = static_cast<Eigen::Index>(rows.size());
    Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> matrix(size, size);
    for (Eigen::Index i = 0; i < size; ++i)
      for (Eigen::Index j = 0; j < size; ++j) matrix(i, j) = contacts.effect(rows[i].row, rows[j]);
    if (Eigen::LLT<decltype(matrix)>(matrix + matrix.transpose()).info() != Eigen::Success) return false;
  }
  return true;
}

/// Adds what follows where of several interfaces that have left static cones at once one alone has.
template <class Real>
void add_from_other_cones(const ContactProblem<Real>& problem, const Joints<Real>& joints,
                          OtherModes<Real>& others) {
  if (std::has_single_bit(problem.left_cones)) return;
  for (std::uint32_t rest = problem.left_cones; rest != 0 && !others.full(); rest &= rest - 1) {
    ContactProblem<Real> alone = problem;
    alone.left_cones = rest & (~rest + 1);
    const TouchingContacts<Real> contacts(alone, joints);
    const auto mode = find_mode(contacts, joints);
    if (mode && cones_left(alone, joints, *mode) == 0 && obeys(contacts, joints, *mode)) others.add(*mode);
  }
}

/// Up to `most` modes besides one that obey as well, where there are few to try: for one they are sought
/// where friction couples at a point, for more wherever there may be any.
template <class Real>
std::vector<Joints<Real>> other_modes(const TouchingContacts<Real>& contacts, const Joints<Real>& joints,
                                      const Joints<Real>& mode, std::size_t most) {
  const ContactProblem<Real>& problem = contacts.problem();
  OtherModes<Real> others(problem, mode, most);
  add_on_other_faces(problem, joints, mode, others);
  if (!problem.of_accelerations() || others.full()) return std::move(others).take();
  add_from_other_cones(problem, joints, others);
  if (others.full()) return std::move(others).take();
  const auto& interfaces = contacts.interfaces();
  const bool sought = most > 1 ? !one_motion_obeys(contacts, joints)
                               : std::any_of(interfaces.begin(), interfaces.end(),
                                             [&](const auto& contact) { return couples(contacts, contact); });
  const std::size_t most_tried = most > 1 ? 10'000 : 200;
  if (!sought) return std::move(others).take();
  // Each force by its own size: obeys() takes the largest, which may be that of a much heavier block.
  const auto in_cones = [&](const Joints<Real>& other) {
    const ShortVector<ContactForce<Real>> forces = respond(contacts, other).forces;
    return std::all_of(interfaces.begin(), interfaces.end(), [&](const auto& contact) {
      const ContactForce<Real>& force = forces[contact.interface];
      return abs(force.tangential) <= (1 + tolerance<Real>(1e-9)) * contact.friction * force.normal;
    });
  };
  const ShortVector<int> pairs = open_pairs(problem.stack, joints, problem.level);
  const auto leaves_face = [&](const Joints<Real>& other) {
    return std::any_of(pairs.begin(), pairs.end(), [&](int k) { return slides_off(other[k]); });
  };
  for (const auto& other : modes_that_obey(contacts, joints, most_tried))
    if (!others.full() && !same_modes(mode, other) && cones_left(problem, joints, other) == 0 &&
        in_cones(other) && !leaves_face(other))
      others.add(other);
  return std::move(others).take();
}

/// Whether modes besides one obey as well; where branches are followed, it becomes the one that is taken.
template <class Real>
bool choose_branch(const TouchingContacts<Real>& contacts, const Joints<Real>& joints,
                   const SpringContacts<Real>& springs, const Real& time, Branching* branching,
                   Joints<Real>& mode) {
  constexpr std::size_t most = 32;
  std::vector<Joints<Real>> ways = other_modes(contacts, joints, mode, branching != nullptr ? most : 1);
  if (branching == nullptr || ways.empty()) return !ways.empty();
  const ContactProblem<Real>& problem = contacts.problem();
  const ShortVector<int> pairs = open_pairs(problem.stack, joints, problem.level);
  for (Joints<Real>& way : ways) settle(problem, pairs, way);
  ways.insert(ways.begin(), mode);
  std::vector<Pattern> patterns;
  for (Joints<Real> way : ways) {
    for (const int k : pairs)
      if (slides_off(way[k])) way[k] = {.touch = Contact::apart};
    patterns.push_back(pattern_of(springs.shown(std::move(way))));
  }
  mode = ways[branching->take(static_cast<double>(time), std::move(patterns))];
  return true;
}

/// By how much later an event decides, s.
template <class Real>
struct LookAhead {
  Real shortest, longest, time;
  Real last = -1;  ///< decision, s; negative: none since the last impact

  /// From what is given in units of √(H/g), 0: 6.7 √ε, and that unit.
  LookAhead(double given, const Real& unit)
      : shortest((given > 0 ? Real(given) : root_tolerance<Real>(1e-7)) * unit),
        longest(Real(longest_look_ahead) * unit),
        time(shortest) {}

  /// A decision that does not last beyond its look-ahead time is taken for a later one, unless an impact
  /// ended it. What lasts longer is motion, however small: to look beyond its next event would make energy.
  void note_decision(const Real& now, const Real& longest_step) {
    const bool lasts = last < 0 || now - last > Real(1.001) * time;
    time = std::min(lasts ? shortest : std::min<Real>(2 * time, longest), longest_step);
    last = now;
  }
  void note_impact() { last = -1; }
};

}  // namespace rockstack
