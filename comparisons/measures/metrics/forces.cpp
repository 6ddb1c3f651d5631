#include "comparisons/measures/metrics/forces.hpp"

#include "analytic/scene/lists.hpp"
#include "comparisons/measures/metrics/bodies.hpp"
#include "comparisons/measures/metrics/contact.hpp"

namespace rockstack {
namespace {

Reaction in_face_axes(const Stack<double>& stack, const std::vector<double>& angles, int interface,
                      const Point<double>& impulse) {
  const int body = face(stack, interface);
  const double angle = body < 0 ? 0 : angles[static_cast<std::size_t>(body)];
  return {impulse.x() * std::sin(angle) + impulse.y() * std::cos(angle),
          impulse.x() * std::cos(angle) - impulse.y() * std::sin(angle)};
}

Reaction less(const Reaction& one, const Reaction& other) {
  return {one.normal - other.normal, one.tangential - other.tangential};
}

/// Weight of an interface's block and of all above it, N.
std::vector<double> weights_above(const Scene& scene) {
  std::vector<double> weights(scene.blocks.size());
  double sum = 0;
  for (std::size_t k = weights.size(); k-- > 0;) weights[k] = sum += scene.blocks[k].mass * scene.gravity;
  return weights;
}

/// Reactions of both motions in each step, of the interfaces that it has.
class Steps {
 public:
  Steps(const Scene& scene, const History& exact, const History& engine)
      : engine_(engine), exact_(reactions_of(scene, exact)), size_(std::min(exact.size(), engine.size())) {}

  std::size_t size() const { return size_; }  ///< of samples; step i ends with sample i
  std::size_t blocks() const { return static_cast<std::size_t>(engine_.blocks); }
  double time(std::size_t step) const { return engine_.times[step]; }
  double length() const { return size_ > 1 ? time(1) - time(0) : 0; }
  const Reaction& engine(std::size_t step, std::size_t interface) const {
    return engine_.reactions[step * blocks() + interface];
  }
  Reaction exact(std::size_t step, std::size_t interface) const {
    const Reaction &before = exact_[(step - 1) * blocks() + interface],
                   &after = exact_[step * blocks() + interface];
    return {0.5 * (before.normal + after.normal), 0.5 * (before.tangential + after.tangential)};
  }

 private:
  const History& engine_;
  std::vector<Reaction> exact_;
  std::size_t size_;
};

/// Whether one of some rising times is no further from a step's end than that, s.
bool any_near(const std::vector<double>& times, double time, double reach) {
  const auto next = std::ranges::lower_bound(times, time - reach);
  return next != times.end() && *next <= time + reach;
}

ForceDifference forces_between(const Scene& scene, const Steps& steps, const std::vector<double>& impacts) {
  const std::vector<double> weights = weights_above(scene);
  const double reach = settling_duration(scene);
  double normal = 0, tangential = 0, peak = 0, exact_peak = 0;
  std::size_t count = 0;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    if (any_near(impacts, steps.time(i), reach)) continue;
    for (std::size_t k = 0; k < weights.size(); ++k, ++count) {
      const Reaction engine = steps.engine(i, k), exact = steps.exact(i, k), apart = less(engine, exact);
      normal += std::pow(apart.normal / weights[k], 2);
      tangential += std::pow(apart.tangential / weights[k], 2);
      peak = std::max(peak, engine.normal / weights[k]);
      exact_peak = std::max(exact_peak, exact.normal / weights[k]);
    }
  }
  if (count == 0) return {};
  const auto number = static_cast<double>(count);
  return {std::sqrt(normal / number), std::sqrt(tangential / number), peak, exact_peak};
}

/// Times of the strong impacts of both motions, rising.
struct StrongImpacts {
  std::vector<double> exact, engine;
};

StrongImpacts strong_impacts(const std::vector<AlignedImpact>& alignment) {
  StrongImpacts times;
  for (const AlignedImpact& one : alignment) {
    if (one.exact) times.exact.push_back(*one.exact);
    if (one.engine) times.engine.push_back(*one.engine);
  }
  std::ranges::sort(times.exact);
  std::ranges::sort(times.engine);
  return times;
}

/// For how long before and after an impact its impulse is added up, s.
struct Window {
  double before, after;
};

/// Not beyond half way to another one of its motion.
void narrow(Window& window, const std::vector<double>& impacts, double time) {
  const auto next = std::ranges::upper_bound(impacts, time), own = std::ranges::lower_bound(impacts, time);
  if (next != impacts.end()) window.after = std::min(window.after, 0.5 * (*next - time));
  if (own != impacts.begin()) window.before = std::min(window.before, 0.5 * (time - *std::prev(own)));
}

void add(Reaction& sum, const Reaction& other, double times = 1) {
  sum.normal += times * other.normal;
  sum.tangential += times * other.tangential;
}

/// What an interface of the engine bears around an impact above the exact forces, which come as much later or
/// earlier as its impact does.
Reaction engine_impulse(const Steps& steps, const AlignedImpact& impact, const Window& window) {
  const auto interface = static_cast<std::size_t>(impact.interface) - 1;
  const auto late =
      static_cast<std::ptrdiff_t>(std::lround((*impact.engine - *impact.exact) / steps.length()));
  const auto last = static_cast<std::ptrdiff_t>(steps.size()) - 1;
  Reaction sum;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const double after = steps.time(i) - *impact.engine;
    if (after <= -window.before || after > window.after) continue;
    const auto same = std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(i) - late, 1, last);
    add(sum, steps.engine(i, interface), steps.length());
    add(sum, steps.exact(static_cast<std::size_t>(same), interface), -steps.length());
  }
  return sum;
}

/// What all impacts of the exact motion give to an interface around one of them, weaker ones as well.
Reaction exact_impulse(const Stack<double>& stack, const History& exact, const AlignedImpact& impact,
                       const Window& window) {
  const int interface = impact.interface - 1;
  Reaction sum;
  for (const Event& event : exact.events) {
    const double after = event.time - *impact.exact;
    if (!is_impact(event.kind) || event.before.empty() || after <= -window.before || after > window.after)
      continue;
    add(sum, in_face_axes(stack, event.angles, interface, blow_of(stack, event).impulses.col(interface)));
  }
  return sum;
}

}  // namespace

ForceComparison compare_forces(const Scene& scene, const History& exact, const History& engine,
                               const std::vector<AlignedImpact>& alignment) {
  const Steps steps(scene, exact, engine);
  const StrongImpacts strong = strong_impacts(alignment);
  std::vector<double> all = strong.engine;
  for (const Event& event : exact.events)
    if (is_impact(event.kind)) all.push_back(event.time);
  std::ranges::sort(all);
  ForceComparison result{forces_between(scene, steps, all), {}};
  const Stack<double> stack = make_stack<double>(scene);
  for (const AlignedImpact& one : alignment) {
    if (!one.exact || !one.engine || steps.size() < 2) continue;
    Window window{settling_duration(scene), settling_duration(scene)};
    narrow(window, strong.exact, *one.exact);
    narrow(window, strong.engine, *one.engine);
    result.impulses.push_back({*one.number, one.interface, *one.exact, *one.engine,
                               exact_impulse(stack, exact, one, window), engine_impulse(steps, one, window)});
  }
  return result;
}

std::optional<double> impulse_error(const std::vector<ImpactImpulse>& impulses) {
  double apart = 0, exact = 0;
  for (const ImpactImpulse& one : impulses) {
    apart += std::pow(one.engine.normal - one.exact.normal, 2);
    exact += std::pow(one.exact.normal, 2);
  }
  return exact > 0 ? std::optional(std::sqrt(apart / exact)) : std::nullopt;
}

}  // namespace rockstack
