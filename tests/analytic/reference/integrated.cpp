#include "tests/analytic/reference/integrated.hpp"

#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>

#include "analytic/mechanics/impact.hpp"

namespace rockstack::testing {
namespace {

using Values = std::vector<Quad>;  ///< relative angles, then relative velocities

/// A scene that moves, an event at a time.
class Walk {
 public:
  Walk(const Scene& scene, double step) : scene_(scene), model_(make_model<Quad>(scene)), step_(step) {
    const auto size = static_cast<std::size_t>(model_.stack.size());
    const auto fill = [&](const std::vector<double>& absolute_values) {
      for (std::size_t k = 0; k < size; ++k)
        values_.push_back(Quad(absolute_values[k]) - Quad(k > 0 ? absolute_values[k - 1] : 0));
    };
    fill(scene.initial.angles);
    fill(scene.initial.velocities);
    const State<Quad> start = state(values_);
    pattern_ = pattern_of(start.angles, start.velocities);
    history_.blocks = model_.stack.size();
  }

  QuadHistory events(std::size_t count) {
    while (history_.events.size() < count && number_ * step_ < Quad(scene_.duration)) {
      const Values before = values_;
      advance(Quad(number_ + 1) * step_ - time_);
      if (open_wide()) {
        time_ = Quad(++number_) * step_;
      } else {
        locate(before);
      }
    }
    return history_;
  }

 private:
  State<Quad> state(const Values& values) const {
    const Eigen::Index size = model_.stack.size();
    State<Quad> result{pattern_, Vector<Quad>::Zero(size), Vector<Quad>::Zero(size)};
    for (Eigen::Index k = 0; k < size; ++k) {
      result.angles[k] = values[static_cast<std::size_t>(k)];
      result.velocities[k] = values[static_cast<std::size_t>(k + size)];
    }
    return result;
  }

  /// (ẍg, 0) in the current step.
  Point<Quad> ground(const Quad& time) const {
    const GroundMotion& motion = scene_.horizontal;
    if (motion.samples.empty()) return {Quad(0), Quad(0)};
    const auto sample =
        static_cast<std::size_t>((static_cast<double>(number_) + 0.5) * step_ / motion.interval);
    if (sample + 1 >= motion.samples.size()) return {Quad(0), Quad(0)};
    const Quad first(motion.samples[sample]);
    const Quad share = time / Quad(motion.interval) - Quad(sample);
    return {first + (Quad(motion.samples[sample + 1]) - first) * share, Quad(0)};
  }

  void advance(const Quad& length) {
    reached_ = time_ + length;
    if (is_closed(pattern_)) return;
    const auto derivative = [&](const Values& values, Values& rates, const Quad& time) {
      const auto size = static_cast<std::size_t>(model_.stack.size());
      const Vector<Quad> second = accelerations(model_, state(values), ground(time));
      for (std::size_t k = 0; k < size; ++k) {
        rates[k] = values[k + size];
        rates[k + size] = second[static_cast<Eigen::Index>(k)];
      }
    };
    stepper_.do_step(derivative, values_, time_, length);
  }

  /// True where no open interface has passed zero, and no closed one has its centre of pressure outside.
  bool open_wide() const {
    const State<Quad> now = state(values_);
    const auto solution = accelerate(model_, now, ground(reached_));
    for (int k = 0; k < pattern_.size; ++k) {
      if (pattern_[k] == Contact::closed) {
        const Margins<Quad> margin = margins(model_.stack, solution.reactions, k);
        if (margin.right < 0 || margin.left < 0) return false;
      } else if (now.angles[k] * sign(pattern_[k]) < 0) {
        return false;
      }
    }
    return true;
  }

  /// Bisects the step that an event lies in, and passes the event.
  void locate(const Values& before) {
    Quad low = 0;
    Quad high = Quad(number_ + 1) * step_ - time_;
    for (int halving = 0; halving < std::numeric_limits<Quad>::digits; ++halving) {
      const Quad middle = (low + high) / 2;
      values_ = before;
      advance(middle);
      (open_wide() ? low : high) = middle;
    }
    values_ = before;
    advance(high);
    time_ = reached_;
    pass();
  }

  void pass() {
    State<Quad> now = state(values_);
    const auto solution = accelerate(model_, now, ground(time_));
    BasicEvent<Quad> event{time_, EventKind::opening,     0, pattern_, pattern_, {}, {},
                           {},    Consistency::consistent};
    Interfaces closing;
    for (int k = pattern_.size - 1; k >= 0; --k) {
      if (pattern_[k] == Contact::closed) {
        const Margins<Quad> margin = margins(model_.stack, solution.reactions, k);
        if (margin.right >= 0 && margin.left >= 0) continue;
        event.to[k] = margin.right < 0 ? Contact::right : Contact::left;
      } else if (now.angles[k] * sign(pattern_[k]) < 0) {
        now.angles[k] = 0;
        closing.set(static_cast<std::size_t>(k));
        event.kind = EventKind::impact;
      } else {
        continue;
      }
      event.interface = k + 1;
    }
    event.angles = list(now.angles);
    event.before = list(now.velocities);
    if (closing.any()) {
      const Resolution<Quad, Eigen::Dynamic> resolution =
          resolve(model_, Impact<Quad>{now, closing}, before_impact(model_, now), scene_.law);
      event.to = resolution.solution.pattern;
      event.consistency = resolution.consistency;
      now.velocities = resolution.solution.relative;
    }
    event.after = list(now.velocities);
    pattern_ = event.to;
    history_.events.push_back(event);
    for (int k = 0; k < pattern_.size; ++k) {
      const auto block = static_cast<std::size_t>(k);
      values_[block] = now.angles[k];
      values_[block + values_.size() / 2] = now.velocities[k];
    }
  }

  static std::vector<Quad> list(const Vector<Quad>& relative_values) {
    const Vector<Quad> result = absolute(relative_values);
    return {result.begin(), result.end()};
  }

  const Scene& scene_;
  Model<Quad> model_;
  double step_;
  Pattern pattern_;
  Values values_;
  Quad time_ = 0;
  Quad reached_ = 0;        ///< the end of the step under way, s
  std::size_t number_ = 0;  ///< of the step
  boost::numeric::odeint::runge_kutta_fehlberg78<Values, Quad> stepper_;
  QuadHistory history_;
};

}  // namespace

QuadHistory integrate(const Scene& scene, double step, std::size_t events) {
  return Walk(scene, step).events(events);
}

}  // namespace rockstack::testing
