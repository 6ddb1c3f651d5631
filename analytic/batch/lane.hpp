#pragma once

#include "analytic/batch/step_rows.hpp"
#include "analytic/batch/stepped_solver.hpp"

namespace rockstack {

/// A scene that is solved in one lane of a batch. Steps are asked for in rows, and what the kernel says of
/// them is taken from there; all else goes on as in Solver::run().
template <std::size_t N>
class Lane {
 public:
  static constexpr int blocks = static_cast<int>(N);

  /// Keeps references to `scene` and `options`. @throws as Solver().
  Lane(const Scene& scene, const SolveOptions& options) : solver_(scene, options) {}

  /// Goes on to the first step of moving blocks and asks for it; false at the end. @throws as Solver::run().
  bool start(StepRows<N>& rows, std::size_t lane) {
    solver_.start();
    describe_scene(rows, lane);
    return request_step(rows, lane, true);
  }

  /// Goes along the step that was asked for, and on up to the next; likewise. @throws as Solver::run().
  bool advance(StepRows<N>& rows, std::size_t lane) {
    if (rows.walked[lane] > 0) return true;
    catch_up(rows, lane);
    // No step is plain just after an opening: from zero and at rest, no bound clears the angle. So the
    // pattern that the rows have is that of the next step.
    const bool plain = rows.plain[lane] > 0;
    const bool same = plain && clear_;
    if (plain) {
      pass(rows, lane);
    } else if (rows.lands[lane] > 0) {
      land(rows, lane);
    } else {
      follow(rows, lane);
    }
    if (!request_step(rows, lane, !same)) {
      arrive(rows, lane);
      return false;
    }
    return true;
  }

  /// History so far of a motion that cannot go on.
  History so_far(StepRows<N>& rows, std::size_t lane) {
    catch_up(rows, lane);
    arrive(rows, lane);
    return solver_.recorder().so_far();
  }
  History history() && { return std::move(solver_).history(); }

 private:
  /// Along the record that the kernel has walked along.
  void catch_up(StepRows<N>& rows, std::size_t lane) {
    if (!(rows.pieces[lane] > 0)) return;
    solver_.pass_pieces(static_cast<std::ptrdiff_t>(rows.pieces[lane]));
    rows.pieces[lane] = 0;
    passing_ = true;
    body_force_terms_ = 2;
  }

  /// A step that nothing happens in; where it leads, the rows tell.
  void pass(const StepRows<N>& rows, std::size_t lane) {
    const double length = rows.length[lane];
    solver_.steps().lengthen(length, static_cast<std::size_t>(rows.orders[lane]));
    solver_.skip_step(length);
    passing_ = true;
  }

  /// A step that ends in the impact of one interface.
  void land(const StepRows<N>& rows, std::size_t lane) {
    passing_ = true;
    arrive(rows, lane);
    const double length = rows.length[lane];
    const double landing = rows.landing[lane];
    if (!(rows.silent[lane] > 0)) {
      const ExcludedEvents cleared = cleared_by_bounds(rows, lane);
      solver_.record(dense_output(rows, lane, cleared), landing, cleared);
    }
    solver_.steps().lengthen(length, static_cast<std::size_t>(rows.orders[lane]));
    const auto interface = static_cast<std::size_t>(rows.lander[lane]);
    if (!(rows.foreseen[lane] > 0)) return solver_.resolve_single_impact(landing, length, interface, nullptr);
    const auto foreseen = foreseen_impact(rows, lane, interface);
    solver_.resolve_single_impact(landing, length, interface, &foreseen);
  }

  PredictedImpact<double, blocks> foreseen_impact(const StepRows<N>& rows, std::size_t lane,
                                                  std::size_t interface) const {
    PredictedImpact<double, blocks> impact;
    auto& [before, solution] = impact;
    solution.pattern = solver_.state().pattern;
    solution.pattern[interface] = opposite(solution.pattern[interface]);
    for (std::size_t k = 0; k < N; ++k) {
      before.directions.cosine[k] = rows.cosine[k][lane];
      before.directions.sine[k] = rows.sine[k][lane];
      before.motion.rotation[k] = rows.rotation[k][lane];
      before.motion.centre(0, k) = rows.centre_speed_x[k][lane];
      before.motion.centre(1, k) = rows.centre_speed_y[k][lane];
      solution.relative[k] = rows.after[k][lane];
      solution.rounding[k] = rows.negligible[k][lane];
      solution.reactions.normal[k] = rows.impulse_normal[k][lane];
      solution.reactions.tangential[k] = rows.impulse_tangential[k][lane];
      solution.reactions.moment[k] = rows.impulse_moment[k][lane];
    }
    return impact;
  }

  /// Where the steps that were passed have led.
  void arrive(const StepRows<N>& rows, std::size_t lane) {
    if (!passing_) return;
    passing_ = false;
    Vector<double, blocks> angles, velocities;
    PerBlock<double, blocks> peaks, openings;
    for (std::size_t k = 0; k < N; ++k) {
      angles[k] = rows.angle[k][lane];
      velocities[k] = rows.velocity[k][lane];
      peaks[k] = rows.peak[k][lane];
      openings[k] = rows.opening[k][lane];
    }
    solver_.set_state(angles, velocities, peaks, openings);
  }

  /// A step that the kernel could not tell all about.
  void follow(const StepRows<N>& rows, std::size_t lane) {
    arrive(rows, lane);
    const ExcludedEvents cleared = cleared_by_bounds(rows, lane);
    DenseOutput<double, blocks> output = dense_output(rows, lane, cleared);
    solver_.steps().fit(rows.excess[lane], static_cast<std::size_t>(rows.orders[lane]), output);
    solver_.follow(output, cleared);
  }

  DenseOutput<double, blocks> dense_output(const StepRows<N>& rows, std::size_t lane,
                                           const ExcludedEvents& cleared) const {
    const auto orders = static_cast<std::size_t>(rows.orders[lane]);
    const auto read = [&](const CoefficientRows& from, std::size_t terms, Polynomial<double>& to) {
      to.terms = terms;
      for (std::size_t n = 0; n < terms; ++n) to[n] = from[n][lane];
    };
    const bool bears = rows.forces && cleared.forces.count() < N;
    DenseOutput<double, blocks> output{rows.length[lane], solver_.state(), {}, {}};
    for (std::size_t k = 0; k < N; ++k) {
      if (rows.side[k][lane] != 0) {
        read(rows.angles[k], orders + 2, output.angles[k]);
      } else if (rows.watched[k][lane] > 0 && !cleared.contacts.test(k)) {
        read(rows.right[k], orders, output.margins[k].right);
        read(rows.left[k], orders, output.margins[k].left);
      }
      if (!bears) continue;
      read(rows.normal[k], orders, output.forces[k].normal);
      read(rows.tangential[k], orders, output.forces[k].tangential);
    }
    return output;
  }

  /// What the kernel has told of a step. What holds over all of it holds over the part that fit() leaves.
  ExcludedEvents cleared_by_bounds(const StepRows<N>& rows, std::size_t lane) const {
    ExcludedEvents cleared;
    if (!clear_) return cleared;
    for (std::size_t k = 0; k < N; ++k) {
      cleared.contacts.set(k, rows.stays[k][lane] > 0);
      cleared.angles.set(k, rows.upright[k][lane] > 0);
      cleared.forces.set(k, rows.forces && rows.borne[k][lane] > 0);
    }
    return cleared;
  }

  /// `changed` tells whether more may have changed since a step was asked for than the rows know.
  bool request_step(StepRows<N>& rows, std::size_t lane, bool changed) {
    if (!solver_.advance_to_motion()) return false;
    if (changed) {
      arrive(rows, lane);
      describe_state(rows, lane);
      clear_ = solver_.ties().all_clear();
      rows.clear[lane] = clear_ ? 1 : 0;
    }
    const auto step = solver_.next_step();
    rows.length[lane] = step.length;
    rows.sample[lane] = static_cast<double>(solver_.pieces().sample());
    rows.remaining[lane] = solver_.pieces().remaining();
    rows.longest[lane] = solver_.steps().longest();
    describe_body_force(step.body_force, rows, lane);
    return true;
  }

  void describe_scene(StepRows<N>& rows, std::size_t lane) {
    rows.tolerance[lane] = solver_.steps().tolerance();
    rows.rate[lane] = solver_.steps().rate();
    rows.rounding[lane] = solver_.recorder().rounding();
    rows.gravity[lane] = solver_.model().gravity;
    rows.negligible_change[lane] = negligible_change(solver_.model().gravity);
    const auto record = solver_.pieces().record();
    rows.last[lane] = record ? static_cast<double>(record->last) : 0;
    rows.samples[lane] = record ? record->samples : nullptr;
    rows.interval[lane] = record ? record->interval : 1;
    rows.constant[lane] = record ? record->constant : 0;
    rows.pieces[lane] = rows.walked[lane] = 0;
    const Stack<double, blocks>& stack = solver_.model().stack;
    for (std::size_t k = 0; k < N; ++k) {
      rows.half_width[k][lane] = stack.half_width[k];
      rows.half_height[k][lane] = stack.half_height[k];
      rows.mass[k][lane] = stack.mass[k];
      rows.inertia[k][lane] = stack.inertia[k];
      rows.centre_x[k][lane] = stack.centre_x[k];
      rows.centre_y[k][lane] = stack.centre_y[k];
      rows.toppling[k][lane] = solver_.toppling_angles()[k];
      rows.face[k][lane] = stack.overhangs[k] ? 1 : 0;
    }
  }

  void describe_state(StepRows<N>& rows, std::size_t lane) const {
    const State<double, blocks>& state = solver_.state();
    const Interfaces watched = solver_.ties().may_open(state);
    const History& known = solver_.recorder().known();
    for (std::size_t k = 0; k < N; ++k) {
      rows.side[k][lane] = sign(state.pattern[k]);
      rows.watched[k][lane] = watched.test(k) ? 1 : 0;
      rows.angle[k][lane] = state.angles[k];
      rows.velocity[k][lane] = state.velocities[k];
      rows.peak[k][lane] = known.peaks.empty() ? std::numeric_limits<double>::infinity() : known.peaks[k];
      rows.opening[k][lane] = solver_.recorder().openings().angles()[k];
      if (known.forces.empty()) continue;
      rows.least_normal[k][lane] = known.forces[k].least_normal;
      rows.friction[k][lane] = known.forces[k].friction;
    }
  }

  /// What has no coefficients is −0, so that its opposite adds nothing.
  void describe_body_force(const ScaledBodyForce<double>& body_force, StepRows<N>& rows, std::size_t lane) {
    const std::size_t terms = std::max(body_force.x.terms, body_force.y.terms);
    const std::size_t filled = std::max(terms, body_force_terms_);
    for (std::size_t n = 0; n < filled; ++n) {
      rows.body_force_x[n][lane] = n < body_force.x.terms ? body_force.x[n] : -0.0;
      rows.body_force_y[n][lane] = n < body_force.y.terms ? body_force.y[n] : -0.0;
    }
    rows.body_force_terms[lane] = static_cast<double>(terms);
    body_force_terms_ = terms;
  }

  SteppedSolver<blocks> solver_;
  bool clear_ = false;    ///< of ties, in the step that was asked for
  bool passing_ = false;  ///< whether the rows know more of the state than the solver
  std::size_t body_force_terms_ = max_terms<double>;  ///< coefficients in the rows
};

}  // namespace rockstack
