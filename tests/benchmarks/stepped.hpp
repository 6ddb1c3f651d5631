#pragma once

#include "analytic/mechanics/impact.hpp"
#include "tests/benchmarks/guards.hpp"

namespace rockstack::benchmarks {

/// Where chatter ends: an interface closes where it would part for no longer than `time` or no wider than
/// `angle`.
struct ChatterEnd {
  double angle = 0;  ///< rad
  double time = 0;   ///< s
};

/// Solves a scene with any integrator `Method<N>` that has
///   restart(stretch, offset, values)  after an event and where the ground's course changes,
///   advance(limit)                    a step towards the offset `limit`; returns the offset reached,
///   at(offset)                        values within that step;
///   finds_roots                       whether advance() stops at a root of a guard by itself.
/// Events are sign changes of guards over a step, then found by a bracket on at(). Who makes steps otherwise
/// has rest(), pass() and conclude() instead of run(), and at() alone of its method. The motion ends where a
/// block topples.
template <template <int> class Method, int N>
class Stepped {
 public:
  using Response = typename LeanChain<N>::Response;

  template <class Setting>
  Stepped(const Scene& scene, ChatterEnd end, const Setting& setting, const std::vector<double>& samples)
      : scene_(scene),
        end_(end),
        samples_(samples),
        model_(make_model<double, N>(scene)),
        pieces_(scene),
        method_(setting) {
    for (std::size_t k = 0; k < N; ++k) {
      toppling_[k] = toppling_angle(scene, static_cast<int>(k));
      values_[k] = scene.initial.angles[k] - (k > 0 ? scene.initial.angles[k - 1] : 0);
      values_[k + N] = scene.initial.velocities[k] - (k > 0 ? scene.initial.velocities[k - 1] : 0);
    }
    const State<double, N> start = state(closed_pattern(N));
    set_pattern(pattern_of(start.angles, start.velocities));
    settle(false);
  }

  /// Relative angles at the samples, row by row, rad.
  const std::vector<double>& run() {
    while (!finished()) step();
    return rows();
  }

  const std::vector<double>& rows() {
    while (rows_.size() < samples_.size() * N) take_sample(values_);
    return rows_;
  }

  bool finished() const { return toppled_ || pieces_.finished(); }
  /// When the motion ends, s.
  double end() const { return toppled_ ? pieces_.current().start + offset_ : scene_.duration; }
  int events() const { return events_; }
  bool at_rest() const { return at_rest_; }
  const LeanChain<N>& chain() const { return chain_; }
  const GroundPiece<double>& piece() const { return pieces_.current(); }
  double offset() const { return offset_; }
  const Values<N>& values() const { return values_; }
  const std::array<double, N>& toppling() const { return toppling_; }

  /// The ground alone decides when a stack at rest opens: its line at its ends, a pulse at points 1 ms apart.
  void rest() {
    constexpr double close = 1e-3;
    const double reached = piece().straight() ? piece().length : std::min(piece().length, offset_ + close);
    conclude(reached, values_);
  }

  /// Steps up to an offset had neither events nor samples.
  void pass(double offset) { offset_ = offset; }

  /// After a step to an offset at which the values are `after`, which may have an event in it, or at its end.
  void conclude(double reached, const Values<N>& after, bool event_at_its_end = false) {
    if (event_at_its_end) {
      happen(reached, after);
    } else if (const auto guard = guards().negative(after, reached)) {
      const auto within = [this](double offset) { return at(offset); };
      const double time = guards().first(offset_, reached, *guard, within);
      happen(time, time == reached ? after : at(time));
    } else {
      arrive(reached, after);
    }
  }

  /// After a step without events.
  void arrive(double reached, const Values<N>& after) {
    take_samples(reached);
    offset_ = reached;
    values_ = after;
    if (toppled_ || offset_ < piece().length) return;
    pieces_.advance();
    offset_ = 0;
    fresh_ = true;
  }

 private:
  State<double, N> state(const Pattern& pattern) const {
    State<double, N> result{pattern, {}, {}};
    for (std::size_t k = 0; k < N; ++k) {
      result.angles[static_cast<int>(k)] = values_[k];
      result.velocities[static_cast<int>(k)] = values_[k + N];
    }
    return result;
  }

  Response respond(const Values<N>& values, double offset) const {
    return Stretch<N>{&chain_, &piece()}.respond(values, offset);
  }

  void set_pattern(const Pattern& pattern) {
    chain_ = LeanChain<N>(model_, pattern);
    at_rest_ = is_closed(pattern);
    has_closed_ = false;
    for (int k = 0; k < N; ++k) has_closed_ = has_closed_ || pattern[k] == Contact::closed;
    fresh_ = true;
  }

  void step() {
    if (at_rest_) {
      rest();
      return;
    }
    if (fresh_) method_.restart({&chain_, &piece()}, offset_, values_);
    fresh_ = false;
    const double reached = method_.advance(piece().length);
    const Values<N> after = method_.at(reached);
    bool rooted = false;
    if constexpr (Method<N>::finds_roots) rooted = method_.at_root();
    conclude(reached, after, rooted);
  }

  Guards<N> guards() const { return {{&chain_, &piece()}, toppling_}; }

  Values<N> at(double offset) { return at_rest_ ? values_ : method_.at(offset); }

  /// An event comes at an offset.
  void happen(double time, const Values<N>& values) {
    take_samples(time);
    offset_ = time;
    values_ = values;
    handle();
    arrive(offset_, values_);
  }

  void handle() {
    ++events_;
    fresh_ = true;
    const double rounding = 1e-14;
    Interfaces closing;
    double leaning = 0;
    for (std::size_t k = 0; k < N; ++k) {
      leaning += values_[k];
      toppled_ = toppled_ || toppling_[k] - std::abs(leaning) <= rounding;
      const Contact contact = chain_.pattern()[static_cast<int>(k)];
      if (contact == Contact::closed || sign(contact) * values_[k] > rounding ||
          sign(contact) * values_[k + N] > 0)
        continue;
      closing.set(k);
      values_[k] = 0;
    }
    if (toppled_) return;
    if (closing.any()) collide(closing);
    settle(closing.none());
  }

  void collide(const Interfaces& closing) {
    const Impact<double, N> impact{state(chain_.pattern()), closing};
    PatternSolution<double, N> solution =
        resolve(model_, impact, before_impact(model_, impact.before), scene_.law).solution;
    const Interfaces touching = impact.touching();
    for (Pattern slow = without_slow(solution, touching); !(slow == solution.pattern);
         slow = without_slow(solution, touching))
      solution = velocities_after(model_, impact, slow);
    for (std::size_t k = 0; k < N; ++k) values_[k + N] = solution.relative[static_cast<int>(k)];
    set_pattern(solution.pattern);
  }

  Pattern without_slow(const PatternSolution<double, N>& solution, const Interfaces& touching) const {
    Pattern pattern = solution.pattern;
    Values<N> values = values_;
    for (std::size_t k = 0; k < N; ++k) values[k + N] = solution.relative[static_cast<int>(k)];
    const LeanChain<N> chain(model_, pattern);
    const Response response = Stretch<N>{&chain, &piece()}.respond(values, offset_);
    for (int k = 0; k < N; ++k) {
      const auto i = static_cast<std::size_t>(k);
      if (!touching.test(i) || pattern[k] == Contact::closed) continue;
      const double back = -response.accelerations[i] * sign(pattern[k]);
      const double speed = std::abs(values[i + N]);
      if (speed * speed <= 2 * end_.angle * back || 2 * speed <= end_.time * back || speed < 1e-13)
        pattern[k] = Contact::closed;
    }
    return pattern;
  }

  /// Opens closed interfaces whose centre of pressure is outside, and that which is nearest to it where one
  /// is known to be.
  void settle(bool opening) {
    if (!has_closed_) return;
    const Response response = respond(values_, offset_);
    Pattern pattern = chain_.pattern();
    double least = opening ? std::numeric_limits<double>::infinity() : 0;
    for (int k = 0; k < N; ++k) {
      const auto i = static_cast<std::size_t>(k);
      if (chain_.pattern()[k] != Contact::closed || std::min(response.right[i], response.left[i]) >= least)
        continue;
      pattern = chain_.pattern();
      pattern[k] = response.right[i] < response.left[i] ? Contact::right : Contact::left;
      least = std::min(response.right[i], response.left[i]);
    }
    if (!(pattern == chain_.pattern())) set_pattern(pattern);
  }

  void take_samples(double until) {
    while (rows_.size() < samples_.size() * N && samples_[rows_.size() / N] - piece().start <= until)
      take_sample(at(std::max(offset_, samples_[rows_.size() / N] - piece().start)));
  }

  void take_sample(const Values<N>& values) { rows_.insert(rows_.end(), values.begin(), values.begin() + N); }

  const Scene& scene_;
  ChatterEnd end_;
  const std::vector<double>& samples_;
  Model<double, N> model_;
  GroundPieces<double> pieces_;
  Method<N> method_;
  std::array<double, N> toppling_{};  ///< of absolute angles, rad
  Values<N> values_{};
  LeanChain<N> chain_{model_, closed_pattern(N)};
  bool at_rest_ = true;
  bool has_closed_ = true;
  bool toppled_ = false;
  bool fresh_ = true;  ///< the method has to restart
  double offset_ = 0;
  int events_ = 0;
  std::vector<double> rows_;
};

}  // namespace rockstack::benchmarks
