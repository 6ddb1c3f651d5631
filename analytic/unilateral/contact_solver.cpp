#include "analytic/unilateral/contact_solver.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "analytic/polynomials/crossing.hpp"
#include "analytic/polynomials/maximum.hpp"

namespace rockstack {
namespace {

constexpr double shortest_moment = 1e-7;  // of √(H/g)
constexpr double longest_moment = 1e-4;
constexpr double level = 1e-14;  // rad: what is less is flat

/// p(first + (1 − first) u) as a polynomial in u.
Series from(const Series& polynomial, double first) {
  Series shifted = polynomial;
  for (std::size_t i = 0; i + 1 < shifted.terms; ++i) {
    for (std::size_t j = shifted.terms - 1; j > i; --j) shifted[j - 1] += first * shifted[j];
  }
  rescale(shifted, 1 - first);
  return shifted;
}

bool same(const std::vector<Joint>& first, const std::vector<Joint>& second) {
  return std::equal(first.begin(), first.end(), second.begin(),
                    [](const Joint& a, const Joint& b) { return a.same_mode(b); });
}

/// The lowest interface that differs, from 1, and how.
int lowest_change(const std::vector<Joint>& from, const std::vector<Joint>& to) {
  std::size_t k = 0;
  while (k + 1 < from.size() && from[k].same_mode(to[k])) ++k;
  return static_cast<int>(k) + 1;
}

ContactEventKind kind_of(const std::vector<Joint>& from, const std::vector<Joint>& to) {
  const auto any = [&](const auto& changed) {
    for (std::size_t k = 0; k < from.size(); ++k)
      if (changed(from[k], to[k])) return true;
    return false;
  };
  if (any([](const Joint& a, const Joint& b) { return a.touches() && !b.touches(); }))
    return ContactEventKind::lift_off;
  if (any([](const Joint& a, const Joint& b) { return a.touch != b.touch; }))
    return ContactEventKind::opening;
  if (any([](const Joint& a, const Joint& b) { return a.slip == 0 && b.slip != 0; }))
    return ContactEventKind::slip;
  return ContactEventKind::stick;
}

/// Whether a corner is on its face, to rounding, and not about to pass its end.
bool is_inside(const Series& within, double s, double rounding) {
  const auto [distance, slope] = tangent(within, s);
  return distance > rounding || (distance >= -rounding && slope >= 0);
}

/// Whether a corner that meets a face is the one that the block above leans to, and on the face.
bool lands(const ModeSeries& series, const Course& course, double s) {
  const auto k = static_cast<std::size_t>(course.interface);
  const double angle = value(series.bodies[k].angle, s) - (k > 0 ? value(series.bodies[k - 1].angle, s) : 0);
  if (course.side * angle < -level) return false;
  return course.within.terms == 0 ||
         (is_inside(course.within, s, course.rounding) && is_inside(course.within_other, s, course.rounding));
}

bool is_still(const std::vector<Joint>& joints) {
  return std::all_of(joints.begin(), joints.end(),
                     [](const Joint& joint) { return joint.touch == Touch::flat && joint.slip == 0; });
}

}  // namespace

ContactSolver::ContactSolver(const Scene& scene, const ContactOptions& options)
    : scene_(scene),
      stack_(scene.blocks, friction_of(scene)),
      smooth_(scene.blocks, std::vector<double>(scene.blocks.size(), 0)),
      pieces_(scene),
      chatter_(stack_, scene.gravity, options.resolution),
      sample_times_(options.sample_times) {
  double height = 0;
  for (int k = 0; k < stack_.size(); ++k) {
    height += 2 * stack_.blocks[static_cast<std::size_t>(k)].half_height;
    toppling_angles_.push_back(toppling_angle(scene, k));
  }
  unit_time_ = std::sqrt(height / scene.gravity);
  moment_ = shortest_moment * unit_time_;
  longest_ = unit_time_ / 8;
  if (options.validity) demands_.emplace(scene, scene.blocks.size());
  if (options.peaks) history_.peaks.assign(scene.blocks.size(), 0);
  start();
}

void ContactSolver::start() {
  const std::size_t size = scene_.blocks.size();
  bodies_.at.resize(size);
  bodies_.rate.resize(size);
  joints_.resize(size);
  fresh_.assign(size, -1);
  slid_ = fresh_;
  fresh_of_ = joints_;
  std::vector<double> slip_rates = scene_.initial.slip_velocities;
  slip_rates.resize(size, 0);
  double below = 0;
  double below_rate = 0;
  for (std::size_t k = 0; k < size; ++k) {
    const double angle = scene_.initial.angles[k];
    const double rate = scene_.initial.velocities[k];
    const double deciding = angle != below ? angle - below : rate - below_rate;
    Joint& joint = joints_[k];
    joint.touch = deciding > 0 ? Touch::right : deciding < 0 ? Touch::left : Touch::flat;
    joint.corner_below = joint.pivots() && corner_is_below(stack_, static_cast<int>(k), 0, joint.side());
    bodies_.at[k].angle = below = angle;
    bodies_.rate[k].angle = below_rate = rate;
  }
  place(stack_.blocks, joints_, bodies_);
  // Slip rates add to the velocities of all that is above.
  BodyPlacement carried;
  for (std::size_t k = 0; k < size; ++k) {
    Joint& joint = joints_[k];
    joint.slip = (slip_rates[k] > 0) - (slip_rates[k] < 0);
    const CornerOnFace point = held_point(stack_.blocks, static_cast<int>(k), joint);
    const double angle = point.face < 0 ? 0 : bodies_.at[static_cast<std::size_t>(point.face)].angle;
    carried.x += slip_rates[k] * std::cos(angle);
    carried.y -= slip_rates[k] * std::sin(angle);
    bodies_.rate[k].x += carried.x;
    bodies_.rate[k].y += carried.y;
  }
}

void ContactSolver::run() {
  decide(std::vector<Joint>(joints_), bodies_, 0);
  while (!ended_ && !pieces_.finished()) advance();
  if (!ended_ && next_sample_ < sample_times_.size() &&
      sample_times_[next_sample_] <= scene_.duration * (1 + 1e-12))
    note_sample(sample_times_[next_sample_], bodies_);
}

ContactHistory ContactSolver::history() && {
  if (demands_) {
    history_.forces = demands_->forces();
    history_.impulses = demands_->impulses();
  }
  history_.last = bodies_;
  history_.end_time = pieces_.finished() ? scene_.duration : time();
  return std::move(history_);
}

FreeVector ContactSolver::free_acceleration(double later) const {
  const Point<double> ground = pieces_.current().at(offset_ + later);
  const double weight = gravity_of(scene_).across;
  FreeVector result(Eigen::Index{3} * stack_.size());
  for (int k = 0; k < stack_.size(); ++k)
    result.segment<3>(Eigen::Index{3} * k) << -ground.x(), -(weight + ground.y()), 0.0;
  return result;
}

void ContactSolver::advance() {
  const GroundPiece<double>& piece = pieces_.current();
  const double remaining = piece.length - offset_;
  const auto next_piece = [&] {
    pieces_.advance();
    offset_ = 0;
  };
  if (!(remaining > 0)) return next_piece();
  const double length = std::min({remaining, longest_, longest_series(piece)});
  const ScaledBodyForce<double> body_force =
      scaled_body_force(gravity_of(scene_).across, piece, offset_, length);
  const ModeStep step = mode_step(stack_, joints_, bodies_, body_force, length);
  if (step.lengthens && length == longest_) longest_ *= 1.25;
  if (step.series.length < length) longest_ = step.series.length;
  const Found found = find(step.series);
  const bool whole = found.s == 1 && step.series.length >= remaining;
  Bodies next = step.series.at(found.s);
  for (const BodyPlacement& rate : next.rate)
    if (!std::isfinite(rate.x) || !std::isfinite(rate.y) || !std::isfinite(rate.angle))
      throw std::runtime_error(
          "velocities have become too large for numbers at t = " + std::to_string(time()) + " s");
  note_step(step.series, found.s);
  bodies_ = std::move(next);
  place(stack_.blocks, joints_, bodies_);
  offset_ += found.s * step.series.length;
  if (found.s > 0) decided_ = false;
  if (!found.courses.empty()) {
    handle(found, step.series);
  } else if (whole) {
    next_piece();
  }
}

/// Whether a course may start at zero because of the last decision.
bool ContactSolver::is_fresh(const Course& course) const {
  const auto k = static_cast<std::size_t>(course.interface);
  switch (course.change) {
    case Change::force:
    case Change::corner:
      return decided_;
    case Change::halt:
      return slid_[k] == time();
    case Change::closing:
      return fresh_[k] == time();
    case Change::landing:
      return fresh_[k] == time() && (!fresh_of_[k].pivots() || fresh_of_[k].side() == course.side);
    default:
      return false;
  }
}

ContactSolver::Found ContactSolver::find(const ModeSeries& series) const {
  Found found;
  const double skipped = std::min(moment_ / series.length, 1.0);
  for (Course& course : courses_of(stack_, joints_, toppling_angles_, series)) {
    Series& whole = course.series;
    const bool fresh = is_fresh(course);
    if (course.change == Change::landing) {
      if (whole[0] < -course.rounding) continue;
      // A corner that has not just parted may come down from within rounding above the face.
      if (whole[0] <= (fresh ? course.rounding : 0)) whole[0] = 0;
    }
    const double first = fresh ? skipped : 0;
    std::optional<double> crossing = first_crossing(fresh ? from(whole, first) : whole);
    if (crossing) *crossing = first + (1 - first) * *crossing;
    if (!crossing || *crossing > found.s) continue;
    if (course.change == Change::landing && !lands(series, course, *crossing)) continue;
    if (*crossing < found.s) found = {*crossing, {}};
    found.courses.push_back(std::move(course));
  }
  return found;
}

void ContactSolver::land(const Course& course, std::vector<Joint>& joints) const {
  const auto k = static_cast<std::size_t>(course.interface);
  Joint& joint = joints[k];
  const double angle = bodies_.at[k].angle - (k > 0 ? bodies_.at[k - 1].angle : 0);
  joint.slip = 0;
  if (std::abs(angle) <= level) {
    joint.touch = Touch::flat;
  } else {
    joint.touch = angle > 0 ? Touch::right : Touch::left;
    joint.corner_below = course.below;
  }
  joint.offset = offset_of(stack_.blocks, bodies_, course.interface, joint);
}

/// True where the new corner meets the face.
bool ContactSolver::pass_corner(int interface, std::vector<Joint>& joints) {
  Joint& joint = joints[static_cast<std::size_t>(interface)];
  if (!joint.pivots()) return false;
  joint.corner_below = !joint.corner_below;
  joint.offset = offset_of(stack_.blocks, bodies_, interface, joint);
  const PointRows rows = rows_of(stack_.blocks, bodies_, held_point(stack_.blocks, interface, joint));
  const FreeVector rates = vector_of(bodies_.rate);
  const double speed = rows.gap_row.dot(rates);
  const double rounding = 1e-13 * (rows.gap_row.cwiseAbs().dot(rates.cwiseAbs()));
  if (speed > rounding) {
    joint.touch = Touch::apart;
    joint.slip = 0;
  }
  return speed < -rounding;
}

void ContactSolver::land_negligible(int interface, std::vector<Joint>& joints) const {
  const auto k = static_cast<std::size_t>(interface);
  const double angle = bodies_.at[k].angle - (k > 0 ? bodies_.at[k - 1].angle : 0);
  for (const bool below : {true, false}) {
    if (below && interface == 0) continue;
    for (const int side : {-1, 1}) {
      if (side * angle < -level) continue;
      const CornerOnFace corner =
          below ? lower_corner(stack_.blocks, interface, side) : upper_corner(stack_.blocks, interface, side);
      const PointRows rows = rows_of(stack_.blocks, bodies_, corner);
      const double rounding = 1e-13 * half_width_of(stack_.blocks, interface);
      if (std::abs(rows.gap) <= rounding &&
          std::abs(rows.slip) <= half_width_of(stack_.blocks, corner.face) + rounding)
        land({{}, Change::landing, interface, side, below, {}, {}, 0}, joints);
    }
  }
}

/// Closes what is open by rounding, so that all that meets at one instant is one impact.
void ContactSolver::close_negligible(std::vector<Joint>& joints) const {
  for (std::size_t k = 0; k < joints.size(); ++k) {
    if (!joints[k].touches()) land_negligible(static_cast<int>(k), joints);
    const double angle = bodies_.at[k].angle - (k > 0 ? bodies_.at[k - 1].angle : 0);
    const double rate = bodies_.rate[k].angle - (k > 0 ? bodies_.rate[k - 1].angle : 0);
    if (chatter_.negligibly_open(joints[k], angle, rate)) joints[k].touch = Touch::flat;
  }
}

/// Changes joints as the courses that end say; true where blocks meet.
bool ContactSolver::apply(const Found& found, std::vector<Joint>& joints) {
  bool meets = false;
  for (const Course& course : found.courses) {
    Joint& joint = joints[static_cast<std::size_t>(course.interface)];
    switch (course.change) {
      case Change::closing:
        joint.touch = Touch::flat;
        meets = true;
        break;
      case Change::landing:
        if (!joint.touches()) land(course, joints);
        meets = true;
        break;
      case Change::corner:
        if (pass_corner(course.interface, joints)) meets = true;
        break;
      case Change::halt:
        joint.slip = 0;
        break;
      default:
        break;
    }
  }
  return meets;
}

void ContactSolver::handle(const Found& found, const ModeSeries& series) {
  note_stall();
  const std::vector<Joint> before = joints_;
  for (const Course& course : found.courses) {
    if (course.change != Change::topple && course.change != Change::fall) continue;
    ended_ = true;
    return note(course.change == Change::topple ? ContactEventKind::topple : ContactEventKind::fall,
                course.interface + 1, before, bodies_.rate);
  }
  std::vector<Joint> touching = joints_;
  if (apply(found, touching))
    return collide(before, std::move(touching), found.courses.front().interface + 1);
  // A decision that does not last is taken for a later moment.
  moment_ = last_decision_ >= 0 && time() - last_decision_ <= 2 * moment_
                ? std::min(2 * moment_, longest_moment * unit_time_)
                : shortest_moment * unit_time_;
  last_decision_ = time();
  const auto passes = [](const Course& course) { return course.change == Change::corner; };
  joints_ = touching;
  hold();
  if (std::any_of(found.courses.begin(), found.courses.end(), passes))
    note(ContactEventKind::corner, found.courses.front().interface + 1, before, bodies_.rate);
  decide(before, series.at(found.s + moment_ / series.length), moment_);
}

/// The velocities that joints leave of these, by impulses without friction: a projection in the metric of
/// kinetic energy, which never gains any.
std::vector<BodyPlacement> ContactSolver::held_rates(const std::vector<Joint>& joints) const {
  return placements_of(respond(smooth_, joints, bodies_, vector_of(bodies_.rate), Sought::velocities).motion);
}

void ContactSolver::hold() {
  const std::vector<BodyPlacement> rates = bodies_.rate;
  place(stack_.blocks, joints_, bodies_);
  bodies_.rate = rates;
  bodies_.rate = held_rates(joints_);
  place(stack_.blocks, joints_, bodies_);
}

/// A mode after an impact in which what does not slide as it should sticks.
std::vector<Joint> ContactSolver::with_slips(std::vector<Joint> mode) const {
  const FreeVector rates = vector_of(bodies_.rate);
  for (int k = 0; k < stack_.size(); ++k) {
    Joint& joint = mode[static_cast<std::size_t>(k)];
    if (!joint.touches() || joint.slip == 0) continue;
    const PointRows rows = rows_of(stack_.blocks, bodies_, held_point(stack_.blocks, k, joint));
    const double rounding = 1e-14 * rows.slip_row.cwiseAbs().dot(rates.cwiseAbs());
    if (!(joint.slip * rows.slip_row.dot(rates) > rounding)) joint.slip = 0;
  }
  return mode;
}

void ContactSolver::collide(const std::vector<Joint>& before, std::vector<Joint> touching, int interface) {
  const std::vector<BodyPlacement> rates = bodies_.rate;
  close_negligible(touching);
  place(stack_.blocks, touching, bodies_);
  bodies_.rate = rates;
  const FreeVector free = vector_of(rates);
  const auto found = find_mode(stack_, touching, bodies_, free, Sought::velocities);
  if (!found) throw std::runtime_error("no impulses end an impact at t = " + std::to_string(time()) + " s");
  std::vector<Joint> mode = *found;
  const ModeResponse response = respond(stack_, mode, bodies_, free, Sought::velocities);
  if (demands_) demands_->note_impact(response.forces, time());
  bodies_.rate = placements_of(response.motion);
  bool closes = false;
  for (std::size_t rounds = 0; rounds <= 4 * mode.size(); ++rounds) {
    std::vector<Joint> held = with_slips(mode);
    if (same(held, mode)) {
      held = chatter_.without_slow(touching, mode, bodies_, free_acceleration(0));
      if (same(held, mode)) break;
      closes = true;
    }
    mode = held;
    bodies_.rate = held_rates(mode);
  }
  joints_ = mode;
  place(stack_.blocks, joints_, bodies_);
  note(!closes             ? ContactEventKind::impact
       : is_still(joints_) ? ContactEventKind::rest
                           : ContactEventKind::closure,
       interface, before, rates);
  decide(mode, bodies_, 0);
}

std::vector<Joint> ContactSolver::with_corners(std::vector<Joint> joints, std::vector<Joint> mode,
                                               const Bodies& moment, const FreeVector& free) const {
  // On a pair of corners the first slip decides whose face it goes along.
  for (std::size_t k = 1; k < mode.size(); ++k) {
    const Joint& joint = mode[k];
    if (!joint.pivots() || joint.slip == 0 || joints[k].slip != 0) continue;
    const auto interface = static_cast<int>(k);
    const CornerOnFace point = held_point(stack_.blocks, interface, joint);
    const double end = half_width_of(stack_.blocks, point.face);
    const double along = point.upward * rows_of(stack_.blocks, moment, point).slip;
    const bool outward = point.upward * joint.slip * joint.side() > 0;
    if (!outward || end - joint.side() * along > 1e-12 * end) continue;
    joints[k] = joint;
    joints[k].slip = 0;
    joints[k].corner_below = !joint.corner_below;
    if (const auto other = find_mode(stack_, joints, moment, free, Sought::accelerations)) mode = *other;
  }
  return mode;
}

std::vector<Joint> ContactSolver::follow_without_solution(const std::vector<Joint>& joints) {
  const std::vector<BodyPlacement> rates = bodies_.rate;
  const FreeVector velocities = vector_of(rates);
  const FreeVector kicked = velocities + shortest_moment * unit_time_ * free_acceleration(0);
  const auto mode = find_mode(stack_, joints, bodies_, kicked, Sought::velocities);
  if (!mode)
    throw std::runtime_error("no impulses let the motion go on at t = " + std::to_string(time()) + " s");
  const ModeResponse response = respond(stack_, *mode, bodies_, velocities, Sought::velocities);
  if (demands_) demands_->note_impact(response.forces, time());
  bodies_.rate = placements_of(response.motion);
  joints_ = *mode;
  note(ContactEventKind::impact, lowest_change(joints, joints_), joints, rates, Solutions::none);
  return joints_;
}

bool ContactSolver::has_others(const std::vector<Joint>& joints, const std::vector<Joint>& mode,
                               const Bodies& moment, const FreeVector& free) const {
  const auto coupled = [&](std::size_t k) {
    const PointRows rows =
        rows_of(stack_.blocks, moment, held_point(stack_.blocks, static_cast<int>(k), joints[k]));
    const auto dot = [&](const Eigen::RowVectorXd& a, const Eigen::RowVectorXd& b) {
      return (a.array() * stack_.inverse_mass.transpose().array() * b.array()).sum();
    };
    return dot(rows.gap_row, rows.gap_row) <= stack_.friction[k] * std::abs(dot(rows.gap_row, rows.slip_row));
  };
  bool any = false;
  for (std::size_t k = 0; k < joints.size(); ++k) any = any || (joints[k].pivots() && coupled(k));
  if (!any) return false;
  constexpr std::size_t most = 200;
  const FreeVector motion = respond(stack_, mode, moment, free, Sought::accelerations).motion;
  for (const auto& other : modes_that_obey(stack_, joints, moment, free, Sought::accelerations, most)) {
    const FreeVector otherwise = respond(stack_, other, moment, free, Sought::accelerations).motion;
    if ((otherwise - motion).lpNorm<Eigen::Infinity>() > 1e-6 * free.lpNorm<Eigen::Infinity>()) return true;
  }
  return false;
}

std::vector<Joint> ContactSolver::with_fresh(std::vector<Joint> joints) const {
  for (std::size_t k = 0; k < joints.size(); ++k) {
    if (fresh_[k] < 0 || time() - fresh_[k] > 2 * moment_ || joints[k].same_mode(fresh_of_[k])) continue;
    const Touch touch = fresh_of_[k].touch;
    if (touch == joints[k].touch) continue;
    joints[k].touch = touch;
    joints[k].corner_below = fresh_of_[k].corner_below;
  }
  return joints;
}

void ContactSolver::mark_fresh(const std::vector<Joint>& before) {
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    if (before[k].slip == 0 && joints_[k].slip != 0) slid_[k] = time();
    if (before[k].touch == joints_[k].touch || !before[k].touches()) continue;
    fresh_[k] = time();
    fresh_of_[k] = before[k];
  }
}

void ContactSolver::decide(const std::vector<Joint>& before, const Bodies& moment, double later) {
  decided_ = true;
  const std::vector<Joint> touching = joints_;
  const FreeVector free = free_acceleration(later);
  std::vector<Joint> joints = later > 0 ? with_fresh(joints_) : joints_;
  const Bodies* at = &moment;
  auto mode = find_mode(stack_, joints, *at, free, Sought::accelerations);
  if (!mode) {
    joints = follow_without_solution(joints);
    at = &bodies_;
    mode = find_mode(stack_, joints, *at, free, Sought::accelerations);
    if (!mode)
      throw std::runtime_error("no forces let the motion go on at t = " + std::to_string(time()) + " s");
  }
  mode = with_corners(joints, *mode, *at, free);
  const bool others = has_others(joints, *mode, *at, free);
  const std::vector<BodyPlacement> rates = bodies_.rate;
  joints_ = *mode;
  mark_fresh(touching);
  hold();
  if (!same(before, joints_))
    note(kind_of(before, joints_), lowest_change(before, joints_), before, rates,
         others ? Solutions::several : Solutions::one);
}

/// Keeps what was asked for of a step up to `end_s` of its length.
void ContactSolver::note_step(const ModeSeries& series, double end_s) {
  sample(series, end_s);
  if (demands_) demands_->note_step(joints_, series, end_s, time());
  if (!history_.peaks.empty()) note_peaks(series, end_s);
}

void ContactSolver::note_peaks(const ModeSeries& series, double end_s) {
  for (std::size_t k = 0; k < history_.peaks.size(); ++k) {
    double& peak = history_.peaks[k];
    for (const double side : {1.0, -1.0}) {
      Series lean;
      add(series.bodies[k].angle, side, lean);
      rescale(lean, end_s);
      if (const auto top = maximum(lean, peak)) peak = top->height;
    }
  }
}

void ContactSolver::sample(const ModeSeries& series, double end_s) {
  for (; next_sample_ < sample_times_.size(); ++next_sample_) {
    const double s = (sample_times_[next_sample_] - time()) / series.length;
    if (s >= end_s) return;
    Bodies bodies = series.at(std::max(s, 0.0));
    note_sample(sample_times_[next_sample_], std::move(bodies));
  }
}

void ContactSolver::note_sample(double time, Bodies bodies) {
  ContactHistory::Sample sample{time, std::move(bodies), joints_, {}, {}};
  place(stack_.blocks, sample.joints, sample.bodies);
  for (int k = 0; k < stack_.size(); ++k) {
    const Joint& joint = sample.joints[static_cast<std::size_t>(k)];
    double gap = joint.touches() ? 0 : std::numeric_limits<double>::infinity();
    if (!joint.touches()) {
      for (const bool below : {false, true}) {
        for (const int side : {-1, 1}) {
          if (below && k == 0) continue;
          const CornerOnFace point =
              below ? lower_corner(stack_.blocks, k, side) : upper_corner(stack_.blocks, k, side);
          const PointRows rows = rows_of(stack_.blocks, sample.bodies, point);
          if (std::abs(rows.slip) <= half_width_of(stack_.blocks, point.face) * (1 + 1e-12))
            gap = std::min(gap, rows.gap);
        }
      }
    }
    sample.slips.push_back(joint.offset);
    sample.gaps.push_back(gap);
  }
  history_.samples.push_back(std::move(sample));
}

void ContactSolver::note(ContactEventKind kind, int interface, const std::vector<Joint>& from,
                         const std::vector<BodyPlacement>& before, Solutions solutions) {
  history_.events.push_back(
      {time(), kind, interface, from, joints_, bodies_.at, before, bodies_.rate, solutions});
}

void ContactSolver::note_stall() {
  if (time() - burst_start_ > unit_time_ / 1000) {
    burst_start_ = time();
    burst_ = 0;
  }
  if (++burst_ > 10000 * stack_.size())
    throw std::runtime_error("events do not come to an end after t = " + std::to_string(burst_start_) + " s");
}

std::string name(ContactEventKind kind) {
  constexpr const char* names[] = {"opening", "lift-off", "slip", "stick",  "corner",
                                   "impact",  "closure",  "rest", "topple", "fall"};
  return names[static_cast<std::size_t>(kind)];
}

ContactHistory solve_unilateral(const Scene& scene, const ContactOptions& options) {
  validate(scene);
  if (!(options.resolution >= 0)) throw std::invalid_argument("resolution: must be ≥ 0");
  ContactSolver solver(scene, options);
  try {
    solver.run();
  } catch (const std::runtime_error& failure) {
    throw UnfinishedContacts(failure.what(), std::move(solver).history());
  }
  return std::move(solver).history();
}

double energy(const Scene& scene, const Bodies& bodies) {
  const Gravity gravity = gravity_of(scene);
  double sum = 0;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const Block& block = scene.blocks[k];
    const BodyPlacement& rate = bodies.rate[k];
    sum += block.mass * (rate.x * rate.x + rate.y * rate.y) / 2 +
           block.inertia * rate.angle * rate.angle / 2 +
           block.mass * (gravity.across * bodies.at[k].y - gravity.along * bodies.at[k].x);
  }
  return sum;
}

}  // namespace rockstack
