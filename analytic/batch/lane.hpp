#pragma once

#include "analytic/batch/step_rows.hpp"
#include "analytic/solver/solver.hpp"

namespace rockstack {

/// A scene that is solved in one lane of a batch. Steps are asked for in rows, and what the kernel says of
/// them is taken from there; all else goes on as in Solver::run().
template <std::size_t N>
class Lane {
 public:
  static constexpr int blocks = static_cast<int>(N);

  /// Keeps references to `scene` and `options`. @throws as Solver().
  Lane(const Scene& scene, const SolveOptions& options) : solver_(scene, options) {}

  /// Goes on up to the first step of moving blocks, and asks for it. False where there is none: the history
  /// is complete. @throws as Solver::run().
  bool start(StepRows<N>& rows, std::size_t lane) {
    solver_.start();
    describe_scene(rows, lane);
    return request_step(rows, lane, true);
  }

  /// Goes along the step that was asked for, and on up to the next; likewise. @throws as Solver::run().
  bool advance(StepRows<N>& rows, std::size_t lane) {
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

  /// Of a motion that cannot go on, what is known of it.
  const History& so_far(const StepRows<N>& rows, std::size_t lane) {
    arrive(rows, lane);
    return solver_.recorder().so_far();
  }
  History history() && { return std::move(solver_).history(); }

 private:
  /// A step that nothing happens in; where it leads, the rows tell.
  void pass(const StepRows<N>& rows, std::size_t lane) {
    const double length = rows.length[lane];
    solver_.steps().lengthen(length, static_cast<std::size_t>(rows.orders[lane]));
    solver_.pass(length);
    passing_ = true;
  }

  /// A step that ends in the impact of one interface, and has nothing else to tell.
  void land(const StepRows<N>& rows, std::size_t lane) {
    passing_ = true;
    arrive(rows, lane);
    const double length = rows.length[lane];
    solver_.steps().lengthen(length, static_cast<std::size_t>(rows.orders[lane]));
    solver_.land(rows.landing[lane], length, static_cast<std::size_t>(rows.lander[lane]));
  }

  /// Where the steps that were passed have led.
  void arrive(const StepRows<N>& rows, std::size_t lane) {
    if (!passing_) return;
    passing_ = false;
    Vector<double, blocks> angles, velocities;
    PerBlock<double, blocks> peaks;
    for (std::size_t k = 0; k < N; ++k) {
      angles[k] = rows.angle[k][lane];
      velocities[k] = rows.velocity[k][lane];
      peaks[k] = rows.peak[k][lane];
    }
    solver_.arrive(angles, velocities, peaks);
  }

  /// A step that the kernel could not tell all about.
  void follow(const StepRows<N>& rows, std::size_t lane) {
    arrive(rows, lane);
    const auto orders = static_cast<std::size_t>(rows.orders[lane]);
    const auto read = [&](const CoefficientRows& from, std::size_t terms, Polynomial<double>& to) {
      to.terms = terms;
      for (std::size_t n = 0; n < terms; ++n) to[n] = from[n][lane];
    };
    const Cleared cleared = cleared_by_bounds(rows, lane);
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
    solver_.steps().fit(rows.excess[lane], orders, output);
    solver_.follow(output, cleared);
  }

  /// What the kernel has told of a step whose series stays as it is; what holds over all of a step holds over
  /// the part that fit() leaves of it.
  Cleared cleared_by_bounds(const StepRows<N>& rows, std::size_t lane) const {
    Cleared cleared;
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
    if (!solver_.seek_motion()) return false;
    if (changed) {
      arrive(rows, lane);
      describe_pattern(rows, lane);
      describe_state(rows, lane);
      clear_ = solver_.ties().all_clear();
      rows.clear[lane] = clear_ ? 1 : 0;
    }
    const auto step = solver_.next_step();
    rows.length[lane] = step.length;
    describe_body_force(step.body_force, rows, lane);
    return true;
  }

  void describe_scene(StepRows<N>& rows, std::size_t lane) {
    rows.tolerance[lane] = solver_.steps().tolerance();
    rows.rate[lane] = solver_.steps().rate();
    rows.rounding[lane] = solver_.recorder().rounding();
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

  void describe_pattern(StepRows<N>& rows, std::size_t lane) {
    const Pattern& pattern = solver_.state().pattern;
    const Interfaces watched = solver_.ties().may_open(solver_.state());
    for (std::size_t k = 0; k < N; ++k) {
      rows.side[k][lane] = sign(pattern[k]);
      rows.watched[k][lane] = watched.test(k) ? 1 : 0;
    }
  }

  void describe_state(StepRows<N>& rows, std::size_t lane) const {
    const State<double, blocks>& state = solver_.state();
    const History& known = solver_.recorder().so_far();
    for (std::size_t k = 0; k < N; ++k) {
      rows.angle[k][lane] = state.angles[k];
      rows.velocity[k][lane] = state.velocities[k];
      rows.peak[k][lane] = known.peaks.empty() ? std::numeric_limits<double>::infinity() : known.peaks[k];
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

  Solver<double, blocks> solver_;
  bool clear_ = false;    ///< of ties, in the step that was asked for
  bool passing_ = false;  ///< whether the rows know more of the state than the solver
  std::size_t body_force_terms_ = max_terms<double>;  ///< coefficients in the rows
};

}  // namespace rockstack
