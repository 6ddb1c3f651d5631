#pragma once

#include "analytic/events/rest.hpp"
#include "analytic/scene/event_limit.hpp"
#include "analytic/solver/openings.hpp"
#include "analytic/solver/validity.hpp"

namespace rockstack {

/// Keeps the history of a motion that goes by step by step: its events, and what the options ask for.
template <class Real, int N>
class Recorder {
 public:
  /// Keeps references to all.
  Recorder(const Scene& scene, const Model<Real, N>& model, const SolveOptions& options)
      : scene_(scene),
        model_(model),
        options_(options),
        openings_(options.peaks),
        event_limit_(model.stack.size(), sqrt(2 * model.stack.half_height.sum() / model.gravity)) {
    const int size = model.stack.size();
    history_.blocks = size;
    const std::size_t samples = options.sample_times.size();
    history_.times.reserve(samples);
    history_.patterns.reserve(samples);
    history_.angles.reserve(samples * static_cast<std::size_t>(size));
    history_.velocities.reserve(samples * static_cast<std::size_t>(size));
    if (options.peaks) history_.peaks.assign(static_cast<std::size_t>(size), Real(0));
    if (options.validity) {
      const std::vector<double> friction = friction_of(scene);
      friction_.assign(friction.begin(), friction.end());
      history_.forces.resize(static_cast<std::size_t>(size));
      history_.impulses.resize(static_cast<std::size_t>(size));
    }
  }

  /// A step from `offset` into a ground piece up to its event. What ends as it starts bears nothing.
  void note_step(const DenseOutput<Real, N>& output, const AngleHulls<Real, N>& hulls,
                 const GroundPiece<Real>& piece, const Real& offset, const FirstEvent<Real>& event,
                 const ExcludedEvents& cleared) {
    const Real start = piece.start + offset;
    for (const auto& [s, kind, interface] : event.grazes)
      if (s <= event.s) history_.grazes.push_back({start + s * output.length, kind, interface});
    sample(output, piece, offset, event.s);
    if (options_.validity && event.s > 0) note_forces(output, piece, offset, event.s, cleared.forces);
    if (!options_.peaks) return;
    note_peaks(output, event.s, cleared.angles);
    openings_.note_step(output, hulls, event.s, cleared.angles, history_.peaks[0]);
  }

  /// Whether there is something to keep of a stretch of time through which the stack stands still.
  bool wants(const RestingStack<Real, N>& resting, const SupportDemand<Real>& bears) const {
    if (sample_due()) return true;
    for (std::size_t k = 0; k < history_.forces.size(); ++k) {
      const BasicDemand<Real>& known = history_.forces[k];
      if (bears.tilt > known.friction || resting.mass[k] * bears.least_gravity < known.least_normal)
        return true;
    }
    return false;
  }

  /// Whether what is left of chatter from a time on may hold something to keep.
  bool wants(const RestOfChatter<Real, N>& rest, const Real& time) const {
    if (sample_due() && Real(options_.sample_times[next_sample_]) <= time + rest.duration) return true;
    if (options_.peaks && (may_peak(rest) || openings_.may_rise(rest))) return true;
    return options_.validity && may_demand_more(rest);
  }

  /// The friction that every interface has come to demand.
  Real known_friction() const {
    Real least = std::numeric_limits<Real>::infinity();
    for (const BasicDemand<Real>& demand : history_.forces) least = std::min(least, demand.friction);
    return least;
  }

  /// The impulses of an impact. One of chatter that is a millionth of the momentum that the stack has after
  /// falling its own size, or less, bears nothing.
  void note_impact(const PatternSolution<Real, N>& solution, const Real& time) {
    if (options_.validity) note_demands(history_.impulses, solution, negligible_impulse_, friction_, time);
  }

  /// Whether the impulses of an impact are to be kept.
  bool keeps(const PatternSolution<Real, N>& impact) const {
    const Reactions<Real, N>& impulse = impact.reactions;
    return options_.validity && std::max(impulse.normal.cwiseAbs().maxCoeff(),
                                         impulse.tangential.cwiseAbs().maxCoeff()) > negligible_impulse_;
  }

  /// Openings that either side would have done for; those of one interface at one time are one.
  void note_choices(const Interfaces& openings, const Real& time) {
    for (int k = 0; k < history_.blocks; ++k) {
      const auto same = [&](const BasicGraze<Real>& known) {
        return known.time == time && known.interface == k + 1;
      };
      auto& known = history_.choices;
      if (openings.test(k) && std::none_of(known.begin(), known.end(), same))
        known.push_back({time, EventKind::opening, k + 1});
    }
  }

  /// An event from pattern `from` and relative velocities `before` to the state `after`.
  /// @throws std::runtime_error as EventLimit.
  void note_event(const Real& time, EventKind kind, int interface, const Pattern& from,
                  const Vector<Real, N>& before, const State<Real, N>& after,
                  Consistency consistency = Consistency::consistent) {
    event_limit_.note_event(time, history_.events.size());
    ++events_;
    if (!history_.events.empty())
      history_.events.back().time = std::min<Real>(history_.events.back().time, time);
    const bool summed = options_.events == EventsKept::summed;
    if (summed && sums_up(time, kind, interface, from, after.pattern, consistency)) return;
    BasicEvent<Real>& event = history_.events.emplace_back();  // moving one would cost more
    event.time = time;
    event.kind = kind;
    event.interface = interface;
    event.from = from;
    event.to = after.pattern;
    event.consistency = consistency;
    if (summed) return;
    const auto list = [&](const Vector<Real, N>& relative_values) {
      const Vector<Real, N> values = absolute(relative_values);
      return std::vector<Real>(values.begin(), values.end());
    };
    event.angles = list(after.angles);
    event.before = list(before);
    event.after = list(after.velocities);
  }

  /// Puts the last event, a closure, off by what chatter goes on after the last impact that is followed, s,
  /// as far as the end of the scene or the next event.
  void put_off_closure(const Real& chatter, const Real& end) {
    Real& time = history_.events.back().time;
    time = std::max<Real>(time, std::min<Real>(time + chatter, end));
  }

  /// The samples that are left up to the end, where the last step has led.
  void note_rest(const State<Real, N>& state, const Real& end) {
    while (sample_due() && Real(options_.sample_times[next_sample_]) <= end) record_sample(state);
    if (options_.end) add_sample(state, end);
  }

  /// Raises peaks of blocks and of interfaces to those of a whole step.
  void raise_peaks(const PerBlock<Real, N>& peaks, const PerBlock<Real, N>& openings) {
    std::copy_n(peaks.begin(), history_.peaks.size(), history_.peaks.begin());
    openings_.raise(openings);
  }

  const BasicHistory<Real>& known() const { return history_; }  ///< so far, but for uplifts
  const Openings<Real, N>& openings() const { return openings_; }
  std::size_t events() const { return events_; }      ///< so far, each by itself
  const Real& rounding() const { return rounding_; }  ///< of forces, N
  BasicHistory<Real> history() && {
    if (options_.peaks) history_.uplifts = openings_.uplifts(scene_);
    return std::move(history_);
  }
  BasicHistory<Real> so_far() const { return Recorder(*this).history(); }

 private:
  /// Whether an impact throws its interface to the other side, and changes no other.
  static bool throws_alone(EventKind kind, int interface, const Pattern& from, const Pattern& to) {
    bool alone = kind == EventKind::impact;
    for (int k = 0; k < from.size; ++k)
      alone = alone && to[k] == (k == interface - 1 ? opposite(from[k]) : from[k]);
    return alone;
  }

  /// Whether an event is one more of the impacts that the last one stands for, as which it is counted.
  bool sums_up(const Real& time, EventKind kind, int interface, const Pattern& from, const Pattern& to,
               Consistency consistency) {
    if (history_.events.empty()) return false;
    BasicEvent<Real>& last = history_.events.back();
    if (interface != last.interface || consistency != last.consistency ||
        !throws_alone(kind, interface, from, to) ||
        (last.count == 1 && !throws_alone(last.kind, last.interface, last.from, last.to)))
      return false;
    last.time = time;
    last.to = to;
    ++last.count;
    return true;
  }

  bool sample_due() const { return next_sample_ < options_.sample_times.size(); }

  /// Samples of a step up to, and without, `end` of its length.
  void sample(const DenseOutput<Real, N>& output, const GroundPiece<Real>& piece, const Real& offset,
              const Real& end) {
    while (sample_due()) {
      const Real s = ((Real(options_.sample_times[next_sample_]) - piece.start) - offset) / output.length;
      if (!(s < end)) return;
      record_sample(output.at(std::max(s, Real(0))));
    }
  }

  void record_sample(const State<Real, N>& state) {
    add_sample(state, Real(options_.sample_times[next_sample_++]));
  }

  void add_sample(const State<Real, N>& state, const Real& time) {
    history_.times.push_back(time);
    const Vector<Real, N> angles = absolute(state.angles);
    const Vector<Real, N> velocities = absolute(state.velocities);
    history_.angles.insert(history_.angles.end(), angles.begin(), angles.end());
    history_.velocities.insert(history_.velocities.end(), velocities.begin(), velocities.end());
    history_.patterns.push_back(state.pattern);
  }

  /// Whether a block may come to lean more within chatter than before it and after it.
  bool may_peak(const RestOfChatter<Real, N>& rest) const {
    const Vector<Real, N> angles = absolute(rest.angles);
    const Vector<Real, N> velocities = absolute(rest.closure.relative);
    const Vector<Real, N> thrown = absolute(rest.velocity_jump());
    const Real gain = rest.fastest * static_cast<Real>(history_.blocks) * rest.duration;
    for (int k = 0; k < history_.blocks; ++k) {
      const Real change = 2 * abs(thrown[k]) + gain;
      const Real reach = abs(angles[k]) + (abs(velocities[k]) + change) * rest.duration;
      if (reach > history_.peaks[k] && abs(velocities[k]) <= change) return true;
    }
    return false;
  }

  /// Whether flights or impacts of chatter may ask more of an interface, to a hundredth of what is known.
  bool may_demand_more(const RestOfChatter<Real, N>& rest) const {
    const Real near = Real(1) / 100;
    if (keeps(rest.closure)) return true;
    for (const PatternSolution<Real, N>& flight : rest.flights)
      for (int k = 0; k < history_.blocks; ++k) {
        const BasicDemand<Real>& known = history_.forces[k];
        const Real normal = flight.reactions.normal[k];
        const Real tangential = abs(flight.reactions.tangential[k]);
        if (normal - near * abs(normal) < known.least_normal ||
            tangential * (1 + near) > known.friction * normal)
          return true;
      }
    return false;
  }

  /// The largest angles of a step up to s of its length.
  void note_peaks(const DenseOutput<Real, N>& output, const Real& s, const Interfaces& cleared) {
    if (cleared.count() == history_.peaks.size()) return;
    Polynomial<Real> angle;  // absolute
    for (std::size_t k = 0; k < history_.peaks.size(); ++k) {
      add(output.angles[k], Real(1), angle);
      if (angle.terms == 0 || cleared.test(k) || hull(angle).size() <= history_.peaks[k]) continue;
      Polynomial<Real> part = angle;
      rescale(part, s);
      if (hull(part).size() <= history_.peaks[k]) continue;
      for (const Polynomial<Real>& lean : {part, times(-1, part)})
        if (const auto top = maximum(lean, history_.peaks[k])) history_.peaks[k] = top->height;
    }
  }

  /// The demands of a step up to s of its length; at its start alone where the integrator tells no forces.
  void note_forces(const DenseOutput<Real, N>& output, const GroundPiece<Real>& piece, const Real& offset,
                   const Real& s, const Interfaces& cleared) {
    if (cleared.count() == history_.forces.size()) return;
    const Real start = piece.start + offset;
    if (output.forces[0].normal.terms == 0)
      return note_demands(history_.forces, accelerate(model_, output.start, piece.at(offset)), rounding_,
                          friction_, start);
    for (std::size_t k = 0; k < history_.forces.size(); ++k)
      if (!cleared.test(k))
        note_demand_along(history_.forces[k], output.forces[k], s, rounding_, friction_[k], start,
                          output.length);
  }

  const Scene& scene_;
  const Model<Real, N>& model_;
  const SolveOptions& options_;
  std::vector<Real> friction_;  ///< that each interface has, with validity
  Openings<Real, N> openings_;
  /// Rounding of forces, N.
  Real rounding_ = 1024 * std::numeric_limits<Real>::epsilon() * (model_.gravity * model_.stack.mass.sum());
  Real negligible_impulse_ =  ///< N·s
      Real(1e-6) * model_.stack.mass.sum() * sqrt(2 * model_.gravity * model_.stack.half_height.sum());
  EventLimit<Real> event_limit_;
  std::size_t next_sample_ = 0;
  std::size_t events_ = 0;
  BasicHistory<Real> history_;
};

}  // namespace rockstack
