#pragma once

#include "analytic/mechanics/impact.hpp"
#include "tests/benchmarks/lean_chain.hpp"

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
/// Events are sign changes of guards over a step, then found by a bracket on at().
template <template <int> class Method, int N>
class Stepped {
 public:
  using Response = typename LeanChain<N>::Response;

  Stepped(const Scene& scene, ChatterEnd end, double setting, const std::vector<double>& samples)
      : scene_(scene),
        end_(end),
        samples_(samples),
        model_(make_model<double, N>(scene)),
        pieces_(scene),
        method_(setting) {
    for (std::size_t k = 0; k < N; ++k) {
      values_[k] = scene.initial.angles[k] - (k > 0 ? scene.initial.angles[k - 1] : 0);
      values_[k + N] = scene.initial.velocities[k] - (k > 0 ? scene.initial.velocities[k - 1] : 0);
    }
    const State<double, N> start = state(closed_pattern(N));
    set_pattern(pattern_of(start.angles, start.velocities));
  }

  /// Relative angles at the samples, row by row, rad.
  const std::vector<double>& run() {
    settle(false);
    for (; !pieces_.finished(); pieces_.advance(), offset_ = 0) {
      fresh_ = true;
      while (offset_ < pieces_.current().length) step();
    }
    while (rows_.size() < samples_.size() * N) take_sample(values_);
    return rows_;
  }

  int events() const { return events_; }

 private:
  State<double, N> state(const Pattern& pattern) const {
    State<double, N> result{pattern, {}, {}};
    for (std::size_t k = 0; k < N; ++k) {
      result.angles[static_cast<int>(k)] = values_[k];
      result.velocities[static_cast<int>(k)] = values_[k + N];
    }
    return result;
  }

  void set_pattern(const Pattern& pattern) {
    chain_ = LeanChain<N>(model_, pattern);
    at_rest_ = is_closed(pattern);
    has_closed_ = false;
    for (int k = 0; k < N; ++k) has_closed_ = has_closed_ || pattern[k] == Contact::closed;
    fresh_ = true;
  }

  void step() {
    const GroundPiece<double>& piece = pieces_.current();
    const Stretch<N> stretch{&chain_, &piece};
    // The ground alone decides when a stack at rest opens: its line at its ends, a pulse at points 1 ms
    // apart.
    constexpr double close = 1e-3;
    double reached = piece.straight() ? piece.length : std::min(piece.length, offset_ + close);
    Values<N> after = values_;
    bool rooted = false;
    if (!at_rest_) {
      if (fresh_) method_.restart(stretch, offset_, values_);
      fresh_ = false;
      reached = method_.advance(piece.length);
      after = method_.at(reached);
      if constexpr (Method<N>::finds_roots) rooted = method_.at_root();
    }
    if (rooted || least_guard(after, reached) < 0) {
      const double event = rooted ? reached : locate(reached);
      if (!at_rest_) after = method_.at(event);
      take_samples(event);
      offset_ = event;
      values_ = after;
      handle();
    } else {
      take_samples(reached);
      offset_ = reached;
      values_ = after;
    }
  }

  /// The least of all guards, each positive as long as its event has not come.
  double least_guard(const Values<N>& values, double offset) const {
    double least = 1;
    for (std::size_t k = 0; k < N; ++k) {
      const Contact contact = chain_.pattern()[static_cast<int>(k)];
      if (contact != Contact::closed) least = std::min(least, sign(contact) * values[k]);
    }
    if (!has_closed_ || least < 0) return least;
    const Response response = chain_.respond(values, pieces_.current().at(offset));
    for (std::size_t k = 0; k < N; ++k) {
      if (chain_.pattern()[static_cast<int>(k)] == Contact::closed)
        least = std::min({least, response.right[k], response.left[k]});
    }
    return least;
  }

  Values<N> at(double offset) { return at_rest_ ? values_ : method_.at(offset); }

  /// Where the least guard first turns negative: regula falsi (Illinois), to rounding.
  double locate(double high) {
    double low = offset_;
    double above = least_guard(at(low), low);
    double below = least_guard(at(high), high);
    if (!(above > 0)) above = -below;  // starts at zero: halve first
    double best = high;
    double smallest = -below;
    int side = 0;
    for (int iteration = 0; iteration < 100; ++iteration) {
      const double middle = (low * below - high * above) / (below - above);
      if (!(middle > low && middle < high)) break;
      const double guard = least_guard(at(middle), middle);
      if (std::abs(guard) <= smallest) {
        best = middle;
        smallest = std::abs(guard);
      }
      (guard >= 0 ? low : high) = middle;
      (guard >= 0 ? above : below) = guard;
      const int now = guard >= 0 ? 1 : -1;
      if (now == side) (now == 1 ? below : above) /= 2;
      side = now;
      if (guard == 0) break;
    }
    return best;
  }

  void handle() {
    ++events_;
    const double rounding = 1e-14;
    Interfaces closing;
    for (std::size_t k = 0; k < N; ++k) {
      const Contact contact = chain_.pattern()[static_cast<int>(k)];
      if (contact == Contact::closed || sign(contact) * values_[k] > rounding ||
          sign(contact) * values_[k + N] > 0)
        continue;
      closing.set(k);
      values_[k] = 0;
    }
    if (closing.any()) collide(closing);
    settle(closing.none());
  }

  void collide(const Interfaces& closing) {
    const Impact<double, N> impact{state(chain_.pattern()), closing};
    PatternSolution<double, N> solution = resolve(model_, impact, scene_.law).solution;
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
    const Response response = LeanChain<N>(model_, pattern).respond(values, pieces_.current().at(offset_));
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
    const Response response = chain_.respond(values_, pieces_.current().at(offset_));
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
    while (rows_.size() < samples_.size() * N &&
           samples_[rows_.size() / N] - pieces_.current().start <= until)
      take_sample(at(std::max(offset_, samples_[rows_.size() / N] - pieces_.current().start)));
  }

  void take_sample(const Values<N>& values) { rows_.insert(rows_.end(), values.begin(), values.begin() + N); }

  const Scene& scene_;
  ChatterEnd end_;
  const std::vector<double>& samples_;
  Model<double, N> model_;
  GroundPieces<double> pieces_;
  Method<N> method_;
  Values<N> values_{};
  LeanChain<N> chain_{model_, closed_pattern(N)};
  bool at_rest_ = true;
  bool has_closed_ = true;
  bool fresh_ = true;  ///< the method has to restart
  double offset_ = 0;
  int events_ = 0;
  std::vector<double> rows_;
};

}  // namespace rockstack::benchmarks
