#pragma once

#include "analytic/unilateral/contact/complementarity.hpp"
#include "analytic/unilateral/contact/contact_laws.hpp"

namespace rockstack {

/// A mode from what is active: which points push, and which way the interface slides.
template <class Real>
void set_mode(const ContactModel<Real>& stack, const TouchingPoints<Real>& contact,
              const std::vector<bool>& pushes, int slip, Joint<Real>& joint) {
  const bool any = std::find(pushes.begin(), pushes.end(), true) != pushes.end();
  if (!any) {
    joint.touch = Touch::apart;
    joint.slip = 0;
    return;
  }
  joint.slip = slip;
  if (joint.touch != Touch::flat || (pushes[0] && pushes[1])) return;
  joint.touch = pushes[0] ? Touch::left : Touch::right;
  joint.corner_below = corner_is_below(stack, contact.interface, joint.offset, joint.side(), slip);
}

/// Adds the points of a contact that slides, or sticks, with what friction adds to their forces.
template <class Real>
void add_points(const TouchingPoints<Real>& contact, int slip, ContactProblem<Real>& problem) {
  for (std::size_t i = 0; i < contact.normals.size(); ++i)
    problem.add(contact.normals[i], contact.normals[i] - contact.friction * slip * contact.slip,
                contact.normal_biases[i]);
}

/// The mode in which all that sticks goes on to, if its forces allow that.
template <class Real>
std::optional<Joints<Real>> sticking_mode(const ContactQuestion<Real>& question, const Joints<Real>& joints,
                                          const std::vector<TouchingPoints<Real>>& contacts) {
  ContactProblem<Real> problem;  // what is held, then points
  std::vector<Eigen::Index> held_at;
  for (const TouchingPoints<Real>& contact : contacts) {
    const bool sticks = question.slip_before(joints[contact.interface]) == 0;
    held_at.push_back(sticks ? problem.size() : -1);
    if (sticks) problem.add(contact.slip, contact.slip, contact.slip_bias);
  }
  const Eigen::Index held_size = problem.size();
  for (const TouchingPoints<Real>& contact : contacts)
    add_points(contact, question.slip_before(joints[contact.interface]), problem);
  const SquareMatrix<Real> matrix = problem.matrix(question.stack);
  const FreeVector<Real> vector = problem.free(question.free);
  const Eigen::Index size = problem.size() - held_size;
  SquareMatrix<Real> reduced = matrix.bottomRightCorner(size, size);
  FreeVector<Real> reduced_vector = vector.tail(size);
  SquareMatrix<Real> tangential_per_normal(held_size, size);
  FreeVector<Real> tangential(held_size);
  if (held_size > 0) {
    const Eigen::PartialPivLU<SquareMatrix<Real>> lu(matrix.topLeftCorner(held_size, held_size));
    tangential_per_normal = -lu.solve(matrix.topRightCorner(held_size, size));
    tangential = -lu.solve(vector.head(held_size));
    reduced += matrix.bottomLeftCorner(size, held_size) * tangential_per_normal;
    reduced_vector += matrix.bottomLeftCorner(size, held_size) * tangential;
  }
  const Real scale = reduced.diagonal().cwiseAbs().maxCoeff();
  const auto solution = solve_complementarity<Real>(reduced / scale, reduced_vector);
  if (!solution) return std::nullopt;
  const FreeVector<Real> normals = solution->z / scale;
  tangential += tangential_per_normal * normals;
  const Real parting = tolerance<Real>(1e-12) * (reduced_vector.template lpNorm<Eigen::Infinity>() +
                                                 vector.template lpNorm<Eigen::Infinity>());
  const Real force_rounding =
      tolerance<Real>(1e-12) * (normals.template lpNorm<Eigen::Infinity>() +
                                (held_size > 0 ? tangential.template lpNorm<Eigen::Infinity>() : Real(0)));
  Joints<Real> mode = joints;
  Eigen::Index at = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const TouchingPoints<Real>& contact = contacts[c];
    Joint<Real>& joint = mode[contact.interface];
    std::vector<bool> pushes;
    Real normal = 0;
    for (std::size_t i = 0; i < contact.normals.size(); ++i, ++at) {
      pushes.push_back(!(solution->w[at] > parting));
      normal += normals[at];
    }
    const int slip = question.slip_before(joint);
    set_mode(question.stack, contact, pushes, slip, joint);
    using std::abs;
    if (slip == 0 && abs(tangential[held_at[c]]) > contact.friction * normal + force_rounding)
      return std::nullopt;
  }
  return mode;
}

/// What Lemke's method finds: a mode, and what each row of a problem takes. For each contact its rows are
/// those of its points, and where friction is sought, to the right and to the left, and of slip.
template <class Real>
struct RubbingSolution {
  Joints<Real> mode;
  ContactProblem<Real> problem;
  FreeVector<Real> forces;
  std::vector<Eigen::Index> cones;  ///< of each contact: where its friction stands, or −1
};

/// By Lemke's method. Beside what is sought, each contact bears a normal impulse `borne`, where any is given;
/// then no slips are sought of contacts without friction.
template <class Real>
std::optional<RubbingSolution<Real>> rub(const ContactQuestion<Real>& question, const Joints<Real>& joints,
                                         const std::vector<TouchingPoints<Real>>& contacts,
                                         const std::vector<Real>& borne = {}) {
  ContactProblem<Real> problem;
  std::vector<Eigen::Index> cones;
  const FreeRow<Real> none = FreeRow<Real>::Zero(Eigen::Index{3} * question.stack.size());
  for (const TouchingPoints<Real>& contact : contacts) {
    const int slip = question.slip_before(joints[contact.interface]);
    add_points(contact, slip, problem);
    const bool rubs = slip == 0 && (borne.empty() || contact.friction > 0);
    cones.push_back(rubs ? problem.size() : -1);
    if (!rubs) continue;
    problem.add(contact.slip, contact.slip, contact.slip_bias);
    problem.add(-contact.slip, -contact.slip, -contact.slip_bias);
    problem.add(none, none, 0);
  }
  SquareMatrix<Real> matrix = problem.matrix(question.stack);
  const Real scale = matrix.diagonal().cwiseAbs().maxCoeff();
  matrix /= scale;
  FreeVector<Real> vector = problem.free(question.free);
  const Real parting = tolerance<Real>(1e-12) * vector.template lpNorm<Eigen::Infinity>();
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (cones[c] < 0) continue;
    const Eigen::Index slack = cones[c] + 2;
    const auto points = static_cast<Eigen::Index>(contacts[c].normals.size());
    matrix(cones[c], slack) = matrix(cones[c] + 1, slack) = 1;
    matrix(slack, cones[c]) = matrix(slack, cones[c] + 1) = -1;
    for (Eigen::Index i = 1; i <= points; ++i) matrix(slack, cones[c] - i) = contacts[c].friction;
    if (!borne.empty()) vector[slack] = scale * contacts[c].friction * borne[c];
  }
  const auto solution = solve_complementarity(matrix, vector);
  if (!solution) return std::nullopt;
  Joints<Real> mode = joints;
  Eigen::Index at = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    Joint<Real>& joint = mode[contacts[c].interface];
    std::vector<bool> pushes;
    for (std::size_t i = 0; i < contacts[c].normals.size(); ++i, ++at)
      pushes.push_back(!(solution->w[at] > parting));
    int slip = question.slip_before(joint);
    if (cones[c] >= 0) {
      // Of the two conditions slack ± slip ≥ 0, that of the way it does not slide is met with equality.
      if (solution->z[at + 2] > parting) slip = solution->w[at] > solution->w[at + 1] ? 1 : -1;
      at += 3;
    }
    set_mode(question.stack, contacts[c], pushes, slip, joint);
  }
  return RubbingSolution<Real>{std::move(mode), std::move(problem), solution->z / scale, std::move(cones)};
}

/// Of all modes that obey, the one whose forces change the motion least.
template <class Real>
std::optional<Joints<Real>> nearest_mode(const ContactQuestion<Real>& question, const Joints<Real>& joints) {
  constexpr std::size_t most = 100000;
  std::optional<Joints<Real>> nearest;
  Real least = std::numeric_limits<Real>::infinity();
  for (auto& mode : modes_that_obey(question, joints, most)) {
    const FreeVector<Real> change = respond(question, mode).motion - question.free;
    const Real size = change.cwiseAbs2().cwiseQuotient(question.stack.inverse_mass).sum();
    if (!(size < least)) continue;
    least = size;
    nearest = std::move(mode);
  }
  return nearest;
}

/// The mode on given faces of all pairs of corners; see find_mode().
template <class Real>
std::optional<Joints<Real>> mode_on_faces(const ContactQuestion<Real>& question, const Joints<Real>& joints) {
  const std::vector<TouchingPoints<Real>> contacts = touching_points(question, joints);
  if (contacts.empty()) return joints;
  if (auto mode = sticking_mode(question, joints, contacts)) return mode;
  auto rubbing = rub(question, joints, contacts);
  if (rubbing && obeys(question, joints, rubbing->mode)) return std::move(rubbing->mode);
  auto other = nearest_mode(question, joints);
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
std::optional<Joints<Real>> find_mode(const ContactQuestion<Real>& question, Joints<Real> joints) {
  for (Joint<Real>& joint : joints) joint.settled = joint.settled && joint.pivots();
  auto first = mode_on_faces(question, joints);
  const bool goes_on = question.level != ContactLevel::impacts;  // else the slip passes the corner
  while (first && goes_on && unsettle(*first, joints)) first = mode_on_faces(question, joints);
  const std::vector<int> pairs = open_pairs(question.stack, joints, question.level);
  if (pairs.empty() || !first) return first;
  auto mode = first;
  int changing = -1;
  for (std::size_t changes = 0; changes <= 4 * pairs.size(); ++changes) {
    changing = first_to_change(question, pairs, *mode);
    if (changing < 0) break;
    bool& below = joints[changing].corner_below;
    below = !below;
    mode = mode_on_faces(question, joints);
    if (!mode) break;
  }
  if (!mode || changing >= 0) mode = first;
  for (const int k : pairs) meet_face(question.stack, k, (*mode)[k]);
  return mode;
}

/// Modes that obey besides one, up to a number of them, none of which moves as another.
template <class Real>
class OtherModes {
 public:
  /// Keeps references to `question` and `mode`.
  OtherModes(const ContactQuestion<Real>& question, const Joints<Real>& mode, std::size_t most)
      : question_(question),
        mode_(mode),
        most_(most),
        same_(Real(1e-6) * question.free.template lpNorm<Eigen::Infinity>()) {}

  bool full() const { return modes_.size() == most_; }
  /// Where a force has just left its cone, motions are yet alike, and which of `pairs` stick tells them
  /// apart.
  void add(const Joints<Real>& other, const std::vector<int>& pairs = {}) {
    if (motions_.empty()) motions_.push_back(respond(question_, mode_).motion);
    const FreeVector<Real> motion = respond(question_, other).motion;
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
  const ContactQuestion<Real>& question_;
  const Joints<Real>& mode_;
  std::size_t most_;
  Real same_;
  std::vector<Joints<Real>> modes_;
  std::vector<FreeVector<Real>> motions_;  ///< of the first mode, then of these
};

/// Adds what other faces of the pairs of corners lead to, where it obeys, of accelerations one that goes on
/// along its faces, where there are few to try.
template <class Real>
void add_on_other_faces(const ContactQuestion<Real>& question, Joints<Real> joints, const Joints<Real>& mode,
                        OtherModes<Real>& others) {
  const std::vector<int> pairs = open_pairs(question.stack, joints, question.level);
  const auto any_pair = [&](const auto& is) {
    return std::any_of(pairs.begin(), pairs.end(), [&](int k) { return is(static_cast<std::size_t>(k)); });
  };
  constexpr std::size_t most = 7;  // 128 ways
  if (pairs.size() > most || !any_pair([&](std::size_t k) { return !mode[k].sticks(); })) return;
  for (unsigned faces = 0; faces < 1U << pairs.size() && !others.full(); ++faces) {
    for (std::size_t i = 0; i < pairs.size(); ++i) joints[pairs[i]].corner_below = (faces >> i & 1U) != 0;
    const auto other = mode_on_faces(question, joints);
    if (!other || !obeys(question, joints, *other)) continue;
    if (question.of_accelerations() && any_pair([&](std::size_t k) { return slides_off((*other)[k]); }))
      continue;
    others.add(*other, pairs);
  }
}

}  // namespace rockstack
