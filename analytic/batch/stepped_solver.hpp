#pragma once

#include "analytic/solver/solver.hpp"

namespace rockstack {

/// A solver whose steps somebody else makes, and which keeps all that lies between them: ground, ties,
/// impacts and what is recorded. It alone knows what is inside of Solver.
template <int N>
class SteppedSolver {
 public:
  /// Keeps references to both. @throws as Solver().
  SteppedSolver(const Scene& scene, const SolveOptions& options) : solver_(scene, options) {}

  /// @throws as Solver::run(), as all below that go on.
  void start() { solver_.start(); }
  /// Once advance_to_motion() has come to the end.
  History history() && { return std::move(solver_).history(); }

  /// Goes on up to a step in which blocks move, and true; or to the end.
  bool advance_to_motion() {
    while (!solver_.finished()) {
      if (pieces().remaining() > 0 && !is_closed(state().pattern)) return true;
      solver_.advance();
    }
    return false;
  }

  /// What the next step has besides a state and a pattern. Preconditions: not finished, not at the end of a
  /// piece.
  struct NextStep {
    double length;  ///< s
    ScaledBodyForce<double> body_force;
  };
  NextStep next_step() const {
    const double length = solver_.steps_.length(pieces().current(), solver_.longest_step());
    return {length, scaled_body_force(model().gravity, pieces().current(), pieces().offset(), length)};
  }

  /// Goes along a step up to its first event, and through that; `cleared` are known not to happen in it.
  void follow(DenseOutput<double, N>& output, const ExcludedEvents& cleared) {
    solver_.follow(output, cleared);
  }

  /// Goes along a whole step in which nothing happens, and nothing is to be recorded but peaks. Where such
  /// steps lead, the caller knows, and tells before it asks for more than them.
  void skip_step(double length) {
    solver_.ties_.note_uneventful_step();
    solver_.go(1, length);
  }

  /// Passes so many pieces of a record.
  void pass_pieces(std::ptrdiff_t pieces) {
    solver_.ties_.note_uneventful_step();
    solver_.pieces_.advance_by(pieces);
  }

  /// Where steps that were passed have led: relative angles and velocities, and all peaks so far, of blocks
  /// and of interfaces.
  void set_state(const Vector<double, N>& angles, const Vector<double, N>& velocities,
                 const PerBlock<double, N>& peaks, const PerBlock<double, N>& openings) {
    solver_.state_.angles = angles;
    solver_.state_.velocities = velocities;
    solver_.recorder_.raise_peaks(peaks, openings);
    solver_.directed_ = false;
  }

  /// Keeps what a step up to s of its length has to tell, before resolve_single_impact().
  void record(const DenseOutput<double, N>& output, double s, const ExcludedEvents& cleared) {
    FirstEvent<double> event;
    event.s = s;
    solver_.recorder_.note_step(output, angle_hulls(output), pieces().current(), pieces().offset(), event,
                                cleared);
  }

  /// Goes through the impact of an interface at s of a step, where the stack has arrived. `foreseen` is what
  /// follows if no other interface closes with it, or null.
  void resolve_single_impact(double s, double length, std::size_t interface,
                             const PredictedImpact<double, N>* foreseen) {
    solver_.require_numbers();
    FirstEvent<double> event;
    event.s = s;
    event.closing.set(interface);
    solver_.ties_.note_step(event, solver_.time());
    solver_.go(s, length);
    solver_.handle(event, foreseen);
  }

  const State<double, N>& state() const { return solver_.state_; }
  const GroundPieces<double>& pieces() const { return solver_.pieces_; }
  const TieBreaker<double>& ties() const { return solver_.ties_; }
  const Model<double, N>& model() const { return solver_.model_; }
  const Recorder<double, N>& recorder() const { return solver_.recorder_; }
  const std::array<double, max_blocks>& toppling_angles() const { return solver_.toppling_angles_; }
  TaylorSteps<double, N>& steps() { return solver_.steps_; }

 private:
  Solver<double, N> solver_;
};

}  // namespace rockstack
