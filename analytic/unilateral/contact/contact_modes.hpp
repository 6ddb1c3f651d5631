#pragma once

#include "analytic/unilateral/contact/complementarity.hpp"
#include "analytic/unilateral/contact/contact_laws.hpp"

namespace rockstack {

/// Adds the points of a contact that slides, or sticks, with what friction adds to their forces.
template <class Real>
void add_points(const TouchingInterface<Real>& contact, int slip, ContactForceRows<Real>& rows) {
  for (std::size_t i = 0; i < contact.points(); ++i)
    rows.push_back({contact.point(i), contact.slip(), -slip * contact.friction});
}

/// The mode in which all that sticks goes on to, if its forces allow that.
template <class Real>
std::optional<Joints<Real>> sticking_mode(const TouchingContacts<Real>& contacts,
                                          const Joints<Real>& joints) {
  const ContactProblem<Real>& problem = contacts.problem();
  ContactForceRows<Real> sticking, points;
  for (const TouchingInterface<Real>& contact : contacts.interfaces()) {
    const int slip = problem.slip_before(joints[contact.interface]);
    if (slip == 0) sticking.push_back({contact.slip()});
    add_points(contact, slip, points);
  }
  // What sticks takes tangential forces of the free motion, and of a unit of each normal force.
  const std::size_t size = points.size(), held = sticking.size();
  NumberTable<Real> tangential_per_normal(held, size), reduced(size, size);
  const LinearSystem<Real> system(
      held, [&](std::size_t i, std::size_t j) { return contacts.effect(sticking[i].row, sticking[j].row); });
  const auto answer = [&](const auto& condition) {
    ShortNumbers<Real> conditions(held);
    for (std::size_t i = 0; i < held; ++i) conditions[i] = -condition(sticking[i].row);
    return system.solve(conditions);
  };
  ShortNumbers<Real> tangential = answer([&](std::size_t row) { return contacts.told(row); });
  ShortNumbers<Real> vector(size);
  Real scale = 0, conditions = 0;
  for (const ContactForceRow<Real>& row : sticking)
    conditions = std::max<Real>(conditions, abs(contacts.told(row.row)));
  for (std::size_t j = 0; j < size; ++j) {
    const ShortNumbers<Real> column =
        answer([&](std::size_t row) { return contacts.effect(row, points[j]); });
    for (std::size_t i = 0; i < held; ++i) tangential_per_normal(i, j) = column[i];
    conditions = std::max<Real>(conditions, abs(contacts.told(points[j].row)));
    vector[j] = contacts.condition(points[j].row, sticking, tangential);
    for (std::size_t i = 0; i < size; ++i) {
      reduced(i, j) = contacts.effect(points[i].row, points[j]);
      for (std::size_t l = 0; l < held; ++l)
        reduced(i, j) += contacts.effect(points[i].row, sticking[l].row) * column[l];
    }
    scale = std::max<Real>(scale, abs(reduced(j, j)));
  }
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) reduced(i, j) /= scale;
  const auto solution = solve_complementarity<Real>(reduced, vector);
  if (!solution) return std::nullopt;
  ShortNumbers<Real> normals = solution->z;
  for (Real& normal : normals) normal /= scale;
  for (std::size_t i = 0; i < held; ++i)
    for (std::size_t j = 0; j < size; ++j) tangential[i] += tangential_per_normal(i, j) * normals[j];
  const Real parting = tolerance<Real>(1e-12) * (largest(vector) + conditions);
  const Real force_rounding = tolerance<Real>(1e-12) * (largest(normals) + largest(tangential));
  Joints<Real> mode = joints;
  std::size_t at = 0, held_at = 0;
  for (const TouchingInterface<Real>& contact : contacts.interfaces()) {
    Joint<Real>& joint = mode[contact.interface];
    ShortVector<bool> pushes;
    Real normal = 0;
    for (std::size_t i = 0; i < contact.points(); ++i, ++at) {
      pushes.push_back(!(solution->w[at] > parting));
      normal += normals[at];
    }
    const int slip = problem.slip_before(joint);
    set_mode(problem.stack, contact, pushes, slip, joint);
    if (slip == 0 && abs(tangential[held_at++]) > contact.friction * normal + force_rounding)
      return std::nullopt;
  }
  return mode;
}

/// What Lemke's method finds: a mode, and what each unknown is. For each contact these are forces at its
/// points, and where friction is sought, to the right and to the left, and the slip.
template <class Real>
struct LcpSolution {
  Joints<Real> mode;
  ShortNumbers<Real> unknowns;
};

/// By Lemke's method. Beside what is sought, each contact bears a normal impulse `borne`, where any is given;
/// then no slips are sought of contacts without friction.
template <class Real>
std::optional<LcpSolution<Real>> solve_coulomb_lcp(const TouchingContacts<Real>& contacts,
                                                   const Joints<Real>& joints,
                                                   const ShortNumbers<Real>& borne = {}) {
  const ContactProblem<Real>& problem = contacts.problem();
  ContactForceRows<Real> rows;
  ShortNumbers<Real> signs;  // of each row; 0 of the slip, of which there is none in the equations
  ShortVector<bool> cones;
  for (const TouchingInterface<Real>& contact : contacts.interfaces()) {
    const int slip = problem.slip_before(joints[contact.interface]);
    add_points(contact, slip, rows);
    while (signs.size() < rows.size()) signs.push_back(1);
    cones.push_back(slip == 0 && (borne.empty() || contact.friction > 0));
    if (!cones.back()) continue;
    for (const int sign : {1, -1, 0}) {
      rows.push_back({contact.slip()});
      signs.push_back(sign);
    }
  }
  const std::size_t size = rows.size();
  NumberTable<Real> matrix(size, size);
  ShortNumbers<Real> vector(size);
  Real scale = 0;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j)
      matrix(i, j) = signs[i] * signs[j] * contacts.effect(rows[i].row, rows[j]);
    vector[i] = signs[i] * contacts.told(rows[i].row);
    scale = std::max<Real>(scale, abs(matrix(i, i)));
  }
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) matrix(i, j) /= scale;
  const Real parting = tolerance<Real>(1e-12) * largest(vector);
  std::size_t at = 0;
  for (std::size_t c = 0; c < cones.size(); ++c) {
    const TouchingInterface<Real>& contact = contacts.interfaces()[c];
    const std::size_t first = at, cone = at + contact.points();
    at = cones[c] ? cone + 3 : cone;
    if (!cones[c]) continue;
    const std::size_t slack = cone + 2;
    matrix(cone, slack) = matrix(cone + 1, slack) = 1;
    matrix(slack, cone) = matrix(slack, cone + 1) = -1;
    for (std::size_t i = first; i < cone; ++i) matrix(slack, i) = contact.friction;
    if (!borne.empty()) vector[slack] = scale * contact.friction * borne[c];
  }
  auto solution = solve_complementarity(matrix, vector);
  if (!solution) return std::nullopt;
  Joints<Real> mode = joints;
  at = 0;
  for (std::size_t c = 0; c < cones.size(); ++c) {
    const TouchingInterface<Real>& contact = contacts.interfaces()[c];
    Joint<Real>& joint = mode[contact.interface];
    ShortVector<bool> pushes;
    for (std::size_t i = 0; i < contact.points(); ++i, ++at) pushes.push_back(!(solution->w[at] > parting));
    int slip = problem.slip_before(joint);
    if (cones[c]) {
      // Equality holds for that of the two conditions slack ± slip ≥ 0 which is of the way it does not slide.
      if (solution->z[at + 2] > parting) slip = solution->w[at] > solution->w[at + 1] ? 1 : -1;
      at += 3;
    }
    set_mode(problem.stack, contact, pushes, slip, joint);
  }
  for (Real& unknown : solution->z) unknown /= scale;
  return LcpSolution<Real>{std::move(mode), std::move(solution->z)};
}

/// Mode whose forces change the motion least, of all modes that obey.
template <class Real>
std::optional<Joints<Real>> nearest_mode(const TouchingContacts<Real>& contacts, const Joints<Real>& joints) {
  const ContactProblem<Real>& problem = contacts.problem();
  std::optional<Joints<Real>> nearest;
  Real least = std::numeric_limits<Real>::infinity();
  for (auto& mode : modes_that_obey(contacts, joints, 100'000)) {
    const FreeVector<Real> change = respond(contacts, mode).motion - problem.free;
    const Real size = change.cwiseAbs2().cwiseQuotient(problem.stack.inverse_mass).sum();
    if (!(size < least)) continue;
    least = size;
    nearest = std::move(mode);
  }
  return nearest;
}

/// The mode on given faces of all pairs of corners; see find_mode().
template <class Real>
std::optional<Joints<Real>> mode_on_faces(const TouchingContacts<Real>& contacts,
                                          const Joints<Real>& joints) {
  if (contacts.empty()) return joints;
  if (auto mode = sticking_mode(contacts, joints)) return mode;
  auto rubbing = solve_coulomb_lcp(contacts, joints);
  if (rubbing && obeys(contacts, joints, rubbing->mode)) return std::move(rubbing->mode);
  auto other = nearest_mode(contacts, joints);
  if (!other && rubbing) other = std::move(rubbing->mode);
  return other;
}

/// The mode that obeys all laws of contact among those in which what touches may stay, part or pivot, and
/// what sticks may slide; of velocities everything may stick. Where several do, the one in which all that
/// sticks goes on to stick comes first, then the one that Lemke's method finds, then, where rounding leads
/// that astray, of all others the one nearest to the motion without contact in the metric of kinetic energy.
/// Where none does to rounding, what Lemke's method finds all the same; nothing where it finds none, which
/// happens for accelerations alone (Painlevé). Pairs of corners slide by the rule of contact_laws.hpp, found
/// as Murty's least-index method finds what is active: the first pair that changes its face does.
template <class Real>
std::optional<Joints<Real>> find_mode(const TouchingContacts<Real>& contacts, Joints<Real> joints) {
  const ContactProblem<Real>& problem = contacts.problem();
  for (Joint<Real>& joint : joints) joint.settled = joint.settled && joint.pivots();
  const ShortVector<int> pairs = open_pairs(problem.stack, joints, problem.level);
  if (Joints<Real> likely = likely_mode(contacts, joints); surely_obeys(contacts, likely, pairs)) {
    for (const int k : pairs) meet_face(problem.stack, k, likely[k]);
    return likely;
  }
  auto first = mode_on_faces(contacts, joints);
  const bool goes_on = problem.level != ContactLevel::impacts;  // else the slip passes the corner
  if (first && goes_on && unsettle(*first, joints))
    return find_mode(TouchingContacts<Real>(problem, joints), joints);
  if (pairs.empty() || !first) return first;
  auto mode = first;
  int changing = first_to_change(contacts, pairs, *mode);
  for (std::size_t changes = 0; changing >= 0 && changes < 4 * pairs.size(); ++changes) {
    bool& below = joints[changing].corner_below;
    below = !below;
    const TouchingContacts<Real> others(problem, joints);
    mode = mode_on_faces(others, joints);
    if (!mode) break;
    changing = first_to_change(others, pairs, *mode);
  }
  if (!mode || changing >= 0) mode = first;
  for (const int k : pairs) meet_face(problem.stack, k, (*mode)[k]);
  return mode;
}

template <class Real>
std::optional<Joints<Real>> find_mode(const ContactProblem<Real>& problem, const Joints<Real>& joints) {
  return find_mode(TouchingContacts<Real>(problem, joints), joints);
}

/// The mode in which what sticks has static friction until its forces leave that cone, and then kinetic: as
/// `problem` and `contacts` have it in the end.
template <class Real>
std::optional<Joints<Real>> find_mode_in_cones(ContactProblem<Real>& problem, const Joints<Real>& joints,
                                               std::optional<TouchingContacts<Real>>& contacts) {
  auto mode = find_mode(*contacts, joints);
  while (mode) {
    const std::uint32_t left = cones_left(problem, joints, *mode);
    if (left == 0) break;
    problem.left_cones |= left;
    contacts.emplace(problem, joints);
    mode = find_mode(*contacts, joints);
  }
  return mode;
}

/// Modes that obey besides one, up to a number of them, none of which moves as another.
template <class Real>
class OtherModes {
 public:
  /// Keeps references to `problem` and `mode`.
  OtherModes(const ContactProblem<Real>& problem, const Joints<Real>& mode, std::size_t most)
      : problem_(problem),
        mode_(mode),
        most_(most),
        same_(Real(1e-6) * problem.free.template lpNorm<Eigen::Infinity>()) {}

  bool full() const { return modes_.size() == most_; }
  /// Where a force has just left its cone, motions are yet alike: which of `pairs` stick tells them apart.
  void add(const Joints<Real>& other, const ShortVector<int>& pairs = {}) {
    if (motions_.empty()) motions_.push_back(respond(problem_, mode_).motion);
    const FreeVector<Real> motion = respond(problem_, other).motion;
    for (std::size_t i = 0; i < motions_.size(); ++i) {
      const Joints<Real>& known = i == 0 ? mode_ : modes_[i - 1];
      const auto parts = [&](int k) { return known[k].sticks() != other[k].sticks(); };
      if (!((motion - motions_[i]).template lpNorm<Eigen::Infinity>() > same_) &&
          std::none_of(pairs.begin(), pairs.end(), parts))
        return;
    }
    modes_.push_back(other);
    motions_.push_back(motion);
  }
  std::vector<Joints<Real>> take() && { return std::move(modes_); }

 private:
  const ContactProblem<Real>& problem_;
  const Joints<Real>& mode_;
  std::size_t most_;
  Real same_;
  std::vector<Joints<Real>> modes_;
  ShortVector<FreeVector<Real>, 2> motions_;  ///< of the first mode, then of these
};

/// Adds what other faces of few pairs of corners lead to, where it obeys, and accelerations stay on them.
template <class Real>
void add_on_other_faces(const ContactProblem<Real>& problem, Joints<Real> joints, const Joints<Real>& mode,
                        OtherModes<Real>& others) {
  const ShortVector<int> pairs = open_pairs(problem.stack, joints, problem.level);
  const auto any_pair = [&](const auto& is) {
    return std::any_of(pairs.begin(), pairs.end(), [&](int k) { return is(static_cast<std::size_t>(k)); });
  };
  constexpr std::size_t most = 7;  // 128 ways
  if (pairs.size() > most || !any_pair([&](std::size_t k) { return !mode[k].sticks(); })) return;
  for (unsigned faces = 0; faces < 1U << pairs.size() && !others.full(); ++faces) {
    for (std::size_t i = 0; i < pairs.size(); ++i) joints[pairs[i]].corner_below = (faces >> i & 1U) != 0;
    const TouchingContacts<Real> contacts(problem, joints);
    const auto other = mode_on_faces(contacts, joints);
    if (!other || !obeys(contacts, joints, *other) || cones_left(problem, joints, *other) != 0) continue;
    if (problem.of_accelerations() && any_pair([&](std::size_t k) { return slides_off((*other)[k]); }))
      continue;
    others.add(*other, pairs);
  }
}

}  // namespace rockstack
