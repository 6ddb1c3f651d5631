#include <gtest/gtest.h>

#include "tests/analytic/mechanics/maximal.hpp"
#include "tests/analytic/solver/stacks.hpp"

// Stacks under pushes, impulses and steps of the ground's velocity by a program of its own: bodies with
// Lagrange's multipliers in long double, the classical fourth-order step, events by bisection, and after each
// the pattern of all that violates the inequalities of contact least.

namespace rockstack {
namespace {

using testing::Column;
using testing::Number;
using Placement = testing::Placement;
using testing::row;

class SteppedStack {
 public:
  explicit SteppedStack(const Scene& scene) : scene_(scene), model_(make_model<Number>(scene)) {
    const auto size = static_cast<Eigen::Index>(scene.blocks.size());
    state_ = {closed_pattern(static_cast<int>(size)), Vector<Number>::Zero(size), Vector<Number>::Zero(size)};
    state_.angles = relative(vector_of<Number>(scene.initial.angles));
    state_.velocities = relative(vector_of<Number>(scene.initial.velocities));
    state_.pattern = pattern_of(state_.angles, state_.velocities);
    for (const Push& push : scene.pushes) note_edges(push.force);
    note_edges(scene.horizontal);
    edges_.push_back(scene.duration);
    std::ranges::sort(edges_);
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  }

  /// Up to the end, or to so many events, or to where contact alone lets no pattern follow.
  void run(std::size_t most_events) {
    if (std::ranges::count(edges_, 0.0) > 0) kick();
    settle();
    for (const double edge : edges_) {
      while (time_ < edge && times_.size() < most_events && !stuck_) advance(edge);
      if (times_.size() >= most_events || stuck_) return;
      if (edge > 0 && edge < scene_.duration) kick();
      const Pattern before = state_.pattern;
      settle();
      if (!(state_.pattern == before) && (times_.empty() || times_.back() < time_)) times_.push_back(time_);
    }
  }

  const std::vector<Number>& times() const { return times_; }  ///< of events
  const State<Number>& state() const { return state_; }
  Number time() const { return time_; }
  bool stuck() const { return stuck_; }

 private:
  void note_edges(const GroundMotion& motion) {
    if (motion.pulse) edges_.insert(edges_.end(), {motion.pulse->start, motion.end()});
    for (const VelocityStep& step : motion.steps) edges_.push_back(step.time);
    std::erase_if(edges_, [&](double time) { return time > scene_.duration; });
  }

  /// What forces of a size each make of free blocks.
  template <class Size>
  Column pushed(const State<Number>& state, const Size& size) const {
    const Placement placement = testing::place(model_, state.pattern, state.angles);
    Column result = Column::Zero(row(model_.stack.size()));
    for (const Push& push : scene_.pushes) {
      const int k = push.point.block - 1;
      const Block& block = scene_.blocks[static_cast<std::size_t>(k)];
      const Number angle = placement.angles[static_cast<std::size_t>(k)];
      const Number up = push.point.y - block.half_height, force = size(push.force);
      const Number x = up * std::sin(angle), y = up * std::cos(angle);
      const Number along = force * std::cos(Number(push.direction)),
                   above = force * std::sin(Number(push.direction));
      result.segment<3>(row(k)) +=
          Column{{along / block.mass, above / block.mass, (y * along - x * above) / block.inertia}};
    }
    return result;
  }

  testing::Solution accelerations(const State<Number>& state, Number time) const {
    // Inside the stretch between two edges.
    const double inside =
        std::clamp(static_cast<double>(time), static_cast<double>(from_) + 1e-13, to_ - 1e-13);
    const auto now = [&](const GroundMotion& motion) { return Number(acceleration(motion, inside)); };
    testing::Solution solution =
        testing::accelerate(model_, state, {now(scene_.horizontal), 0}, pushed(state, now));
    for (int k = 0; k < state.size(); ++k)
      if (state.pattern[k] == Contact::closed) solution.relative[k] = 0;  // what rounding leaves
    return solution;
  }

  State<Number> stepped(Number h) const {
    const auto at = [&](const Vector<Number>& angles, const Vector<Number>& rates, Number later) {
      return accelerations({state_.pattern, angles, rates}, time_ + later).relative;
    };
    const Vector<Number>&q = state_.angles, &v = state_.velocities;
    const Vector<Number> a1 = at(q, v, 0), a2 = at(q + h / 2 * v, v + h / 2 * a1, h / 2);
    const Vector<Number> a3 = at(q + h / 2 * v + h * h / 4 * a1, v + h / 2 * a2, h / 2);
    const Vector<Number> a4 = at(q + h * v + h * h / 2 * a2, v + h * a3, h);
    return {state_.pattern, q + h * v + h * h / 6 * (a1 + a2 + a3), v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)};
  }

  /// By how much what touches would pull outside of its faces, over the weight, or go into itself.
  Number violation(const testing::Solution& solution, const Pattern& pattern, const State<Number>& state,
                   const Interfaces& touching, Number scale) const {
    Number worst = 0, angle = 0;
    for (int k = 0; k < pattern.size; ++k) {
      const Number lower = angle;
      angle += state.angles[k];
      if (pattern[k] == Contact::closed) {
        const Number face = model_.stack.overhangs[static_cast<std::size_t>(k)] ? angle : lower;
        const Number normal = solution.force(0, k) * std::sin(face) + solution.force(1, k) * std::cos(face);
        const Number width = model_.stack.half_width[k];
        worst = std::max(worst, (std::abs(solution.moment[k]) / width - normal) / scale);
      } else if (touching.test(static_cast<std::size_t>(k))) {
        worst = std::max(worst, -sign(pattern[k]) * solution.relative[k]);
      }
    }
    return worst;
  }

  Number weight() const { return model_.stack.mass.sum() * model_.gravity; }

  bool fails(const State<Number>& state, Number time) const {
    for (int k = 0; k < state.size(); ++k)
      if (sign(state.pattern[k]) * state.angles[k] < 0) return true;
    return violation(accelerations(state, time), state.pattern, state, {}, weight()) > 1e-15L;
  }

  void advance(double edge) {
    to_ = edge;
    const Number h = std::min<Number>(1e-3L, edge - time_);
    State<Number> next = stepped(h);
    if (!fails(next, time_ + h)) {
      state_ = next;
      time_ = h == edge - time_ ? Number(edge) : time_ + h;
      return;
    }
    Number low = 0, high = h;
    for (int i = 0; i < 70; ++i) {
      const Number middle = (low + high) / 2;
      (fails(stepped(middle), time_ + middle) ? high : low) = middle;
    }
    state_ = stepped(high);
    time_ += high;
    Interfaces closing;
    for (int k = 0; k < state_.size(); ++k) {
      closing.set(static_cast<std::size_t>(k), sign(state_.pattern[k]) * state_.angles[k] < 0);
      if (closing.test(static_cast<std::size_t>(k))) state_.angles[k] = 0;
    }
    if (closing.any()) strike(closing, {});
    settle();
    times_.push_back(time_);
  }

  /// Takes the best of all patterns of what touches by `solve`; `scale` of forces.
  template <class Solve>
  testing::Solution choose(const Interfaces& touching, Number scale, const Solve& solve) {
    Pattern best = state_.pattern;
    Number least = std::numeric_limits<Number>::infinity();
    for (const Pattern& pattern : candidates(state_.pattern, touching)) {
      const Number own = violation(solve(pattern), pattern, state_, touching, scale);
      if (own < least) {
        least = own;
        best = pattern;
      }
    }
    stuck_ = stuck_ || least > 1e-9L;
    const testing::Solution solution = solve(best);
    state_.pattern = best;
    return solution;
  }

  void strike(const Interfaces& closing, const Column& pushes) {
    const State<Number> before = state_;
    state_.velocities = choose(closing | before.closed(), weight(), [&](const Pattern& pattern) {
                          return testing::strike(model_, before, pattern, pushes);
                        }).relative;
  }

  /// Impulses at this instant.
  void kick() {
    bool any = false;
    const auto now = [&](const GroundMotion& motion) {
      Number sum = 0;
      for (const VelocityStep& step : motion.steps)
        if (step.time == static_cast<double>(time_)) {
          sum += step.size;
          any = true;
        }
      return sum;
    };
    Column pushes = pushed(state_, now);
    const Number ground = now(scene_.horizontal);
    for (int k = 0; k < state_.size(); ++k) pushes[row(k)] -= ground;
    from_ = time_;
    if (!any) return;
    strike({}, pushes);
    times_.push_back(time_);
  }

  /// Opens what has no forces that hold it.
  void settle() {
    const State<Number> before = state_;
    Interfaces touching;
    for (int k = 0; k < state_.size(); ++k)
      touching.set(static_cast<std::size_t>(k), state_.angles[k] == 0 && state_.velocities[k] == 0);
    to_ = *std::ranges::upper_bound(edges_.begin(), edges_.end() - 1, static_cast<double>(time_));
    choose(touching, weight(), [&](const Pattern& pattern) {
      return accelerations({pattern, before.angles, before.velocities}, time_);
    });
  }

  const Scene& scene_;
  Model<Number> model_;
  State<Number> state_;
  std::vector<double> edges_;  ///< between smooth stretches, s
  Number time_ = 0, from_ = 0;
  double to_ = 0;
  bool stuck_ = false;
  std::vector<Number> times_;
};

/// A random stack at rest or leaning, under one or two pushes of any kind or steps of the ground's velocity.
Scene pushed_scene(testing::Draw& draw, int size) {
  Scene scene = testing::random_stack(draw, size);
  const double unit = std::sqrt(stack_height(scene) / 9.81);
  scene.law = Law::consistent;
  scene.duration = 1.5 * unit;
  scene.initial.angles.assign(scene.blocks.size(), 0.0);
  scene.initial.velocities.assign(scene.blocks.size(), 0.0);
  if (draw.coin()) scene.initial.angles.back() = draw.between(-0.2, 0.2) * slenderness(scene, size - 1);
  const double at = draw.between(0.1, 0.6) * unit;
  if (draw.below(4) == 0) {
    const double step =
        draw.between(-0.3, 0.3) * std::sqrt(9.81 * stack_height(scene)) * slenderness(scene, 0);
    scene.horizontal.steps = {{at, step}, {2 * at, -step}};
    return scene;
  }
  for (int count = 1 + draw.below(2); count > 0; --count) {
    Push& push = scene.pushes.emplace_back();
    push.point.block = 1 + draw.below(size);
    const Block& block = scene.blocks[static_cast<std::size_t>(push.point.block) - 1];
    push.point.y = draw.between(0, 2) * block.half_height;
    push.direction = draw.between(-1, 0.5) + (draw.coin() ? 2 : 0);
    const double weight = block.mass * 9.81, share = slenderness(scene, push.point.block - 1);
    if (draw.coin())
      push.force.steps = {{at, draw.between(0.1, 0.6) * weight * share * unit}};
    else
      push.force.pulse = {.shape = draw.coin() ? PulseShape::rectangle : PulseShape::sine,
                          .amplitude = draw.between(0.5, 2) * weight * share,
                          .period = draw.between(0.3, 1) * unit,
                          .start = at / 2};
  }
  return scene;
}

TEST(PushedStacks, MoveAsBodiesWithMultipliersDo) {
  testing::Draw draw(72);
  int compared = 0;
  std::size_t events = 0;
  for (int run = 0; run < 100; ++run) {
    const Scene scene = pushed_scene(draw, 1 + run % 2);
    SteppedStack stepped(scene);
    stepped.run(6);
    const History history = solve(scene);
    std::vector<double> times;
    bool consistent = true;
    for (const Event& event : history.events) {
      // An opening at the instant of an impact or impulse is one with it; what topples goes on in the other.
      const bool own = event.kind != EventKind::topple && (times.empty() || event.time > times.back());
      if (event.time > 0 || event.kind == EventKind::impulse)
        if (own) times.push_back(event.time);
      consistent = consistent && event.consistency == Consistency::consistent;
    }
    if (stepped.stuck() || !consistent) continue;
    ++compared;
    const std::size_t known = std::min(times.size(), stepped.times().size());
    for (std::size_t i = 0; i < known; ++i)
      EXPECT_NEAR(times[i], static_cast<double>(stepped.times()[i]), 1e-8) << run << "\n"
                                                                           << testing::listing(history);
    events += known;
    const bool toppled = !history.events.empty() && history.events.back().kind == EventKind::topple;
    if (toppled || stepped.times().size() >= 6) continue;
    EXPECT_EQ(times.size(), stepped.times().size()) << run << "\n" << testing::listing(history);
    const History end = solve(scene, {.sample_times = {scene.duration}});
    const Vector<Number> angles = absolute(stepped.state().angles);
    for (std::size_t k = 0; k < scene.blocks.size(); ++k)
      EXPECT_NEAR(end.angles[k], static_cast<double>(angles[static_cast<Eigen::Index>(k)]), 1e-8) << run;
  }
  EXPECT_GT(compared, 60);
  EXPECT_GT(events, 120U);
}

}  // namespace
}  // namespace rockstack
