#include <fmt/format.h>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/alignment.hpp"
#include "comparisons/measures/metrics/bodies.hpp"
#include "comparisons/studies/lessons/lesson.hpp"
#include "comparisons/studies/lessons/mechanics.hpp"

namespace rockstack {
namespace {

/// Housner's constants of a block: half diagonal R (m), slenderness α (rad), p (1/s), ratio of velocities at
/// an impact.
struct Constants {
  double R, alpha, p, ratio;
};

Constants constants(const Scene& scene) {
  const Block& block = scene.blocks.front();
  const double R = std::hypot(block.half_width, block.half_height);
  const double alpha = std::atan2(block.half_width, block.half_height);
  const double about_corner = block.inertia + block.mass * R * R;
  return {R, alpha, std::sqrt(block.mass * scene.gravity * R / about_corner),
          1 - block.mass * R * R / about_corner * (1 - std::cos(2 * alpha))};
}

double quarter_period(const Constants& c, double share) {
  return std::acosh(1 / (1 - share)) / c.p;
}

Table periods(Scene scene, const Constants& c) {
  Table table{
      {"release, share of α", "release (rad)", "quarter period, formula (s)", "quarter period, solver (s)"}};
  for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9, 0.99}) {
    scene.initial.angles = {share * c.alpha};
    const History history = solve(scene);
    const Event* landing = first_event(history, EventKind::impact);
    table.rows.push_back({cell(share), cell(share * c.alpha), cell(quarter_period(c, share)),
                          landing ? cell(landing->time) : ""});
  }
  return table;
}

/// The largest angle of each swing, from the release on: a swing ends at an impact.
std::vector<double> peaks(const History& history, std::size_t count) {
  std::vector<double> list{0};
  std::size_t next = 0;
  for (std::size_t i = 0; i < history.size() && list.size() <= count; ++i) {
    for (; next < history.events.size() && history.events[next].time <= history.times[i]; ++next)
      list.push_back(0);
    list.back() = std::max(list.back(), std::abs(history.angles_at(i)[0]));
  }
  list.resize(std::min(list.size(), count));
  return list;
}

Table swings(const Scene& scene, const Constants& c) {
  Table table{{"impacts so far", "peak, formula (rad)", "peak, solver (rad)"}};
  constexpr std::size_t count = 8;
  const std::vector<double> found = peaks(exact_answer(scene, 1e-4), count);
  const double rise = 1 - scene.initial.angles.front() / c.alpha;
  for (std::size_t n = 0; n < found.size(); ++n) {
    const double kept = std::pow(c.ratio, 2.0 * static_cast<double>(n));
    table.rows.push_back({cell(static_cast<double>(n)),
                          cell(c.alpha * (1 - std::sqrt(1 - kept * (1 - rise * rise)))), cell(found[n])});
  }
  return table;
}

constexpr double step = 1e-3;  // s, of both engines

/// Impacts of an engine that are the exact ones, as long as one can be told from the other.
struct Thread {
  std::vector<double> exact, engine;  ///< s

  double late() const { return engine.back() - exact.back(); }
  double longer_swings() const {
    return (engine.back() - engine.front()) / (exact.back() - exact.front()) - 1;
  }
};

Thread thread_of(const Scene& scene, const char* engine) {
  const History found = answer(engine, scene, step), exact = solve(scene, {.sample_times = found.times});
  const double slowest = chatter_speed(scene);
  const auto expected = reported_impacts(scene, exact, slowest);
  const auto alignment = align(expected, observed_impacts(scene, found, slowest),
                               matching_windows(expected, gap_difference(scene, exact, found), step));
  Thread thread;
  for (const AlignedImpact& one : alignment)
    if (one.exact && one.engine && *one.exact < thread_lost(alignment, 1)) {
      thread.exact.push_back(*one.exact);
      thread.engine.push_back(*one.engine);
    }
  return thread;
}

/// What each impact would have to take of the angular velocity, beyond what the block's shape does, for the
/// exact motion to be as early as an engine at the end of its thread, with the half steps taken off; a share.
double extra_loss(Scene scene, const Constants& c, const Thread& thread) {
  const std::size_t last = thread.exact.size() - 1;
  const double half_steps = static_cast<double>(thread.exact.size()) * step / 2;
  return crossing(0, 0.1, [&](double extra) {
    scene.restitution = {c.ratio * (1 - extra)};
    return impacts_of(solve(scene)).at(last).time - (thread.engine.back() + half_steps);
  });
}

Table lateness(const std::vector<Event>& impacts, const Thread& bullet, const Thread& ode) {
  Table table{
      {"impact", "exact (s)", "Bullet less exact (s)", "ODE less exact (s)", "half a step at each (s)"}};
  const auto late = [](const Thread& thread, std::size_t i) {
    return i < thread.exact.size()    ? cell(thread.engine[i] - thread.exact[i])
           : i == thread.exact.size() ? "thread lost"
                                      : "";
  };
  for (std::size_t i = 0; i < impacts.size(); ++i)
    table.rows.push_back({std::to_string(i + 1), cell(impacts[i].time), late(bullet, i), late(ode, i),
                          cell(-step / 2 * static_cast<double>(i + 1))});
  return table;
}

/// What the sliders ask for: the release from which the quarter period doubles, and the width from which the
/// first swing to the other side is half of the release.
std::map<std::string, std::string> slider_answers(const Scene& scene, double quarter) {
  const double release = scene.initial.angles.front();
  const auto landing = [&](double angle) {
    Scene other = scene;
    other.initial.angles = {angle};
    return first_event(solve(other), EventKind::impact)->time;
  };
  const auto first_swing = [&](double width) {
    const Scene wider = read_shipped("housner-block", {fmt::format("blocks.1.width={}", width)});
    return peaks(exact_answer(lasting(wider, 3)), 2).at(1);
  };
  const double doubled = crossing(release, 0.195, [&](double angle) { return landing(angle) - 2 * quarter; });
  return {{"doubled", fixed(doubled, 3)},
          {"doubled_share", fixed(doubled / release, 1)},
          {"half_swing_width",
           fixed(crossing(0.5, 2, [&](double width) { return first_swing(width) - release / 2; }), 2)}};
}

}  // namespace

LessonValues housner_values(const Suite& suite, const std::vector<RunMetrics>& /*rows*/) {
  const Scene& scene = suite.scenes.front().scene;
  const Constants c = constants(scene);
  const History history = exact_answer(scene);
  const Event& landing = *first_event(history, EventKind::impact);
  const ImpactEnergies energies = impact_energies(scene, landing);
  const double share = scene.initial.angles.front() / c.alpha;
  const Thread bullet = thread_of(scene, "bullet"), ode = thread_of(scene, "ode");
  const Model<double> model = make_model<double>(scene);
  const Vector<double> none = Vector<double>::Zero(1);
  const double stored = energy(model, State<double>{landing.from, vector_of(scene.initial.angles), none}) -
                        energy(model, State<double>{closed_pattern(1), none, none});
  LessonValues values{
      .numbers = {{"alpha", fixed(c.alpha, 4)},
                  {"R", fixed(c.R, 4)},
                  {"p", fixed(c.p, 4)},
                  {"release", fixed(scene.initial.angles.front(), 2)},
                  {"share", fixed(share, 3)},
                  {"quarter_formula", fixed(quarter_period(c, share), 4)},
                  {"quarter_solver", fixed(landing.time, 4)},
                  {"ratio", fixed(c.ratio, 6)},
                  {"ratio_solver", fixed(landing.after[0] / landing.before[0], 6)},
                  {"lost", percent(1 - c.ratio * c.ratio, 2)},
                  {"stored", fixed(stored, 1)},
                  {"before", fixed(energies.before, 1)},
                  {"after", fixed(energies.after, 1)},
                  {"difference", percent((energies.before - energies.after) / energies.before, 2)},
                  {"bullet_first", fixed(1e3 * (bullet.exact.front() - bullet.engine.front()), 1)},
                  {"ode_first", fixed(1e3 * (ode.exact.front() - ode.engine.front()), 1)},
                  {"followed", std::to_string(bullet.exact.size())},
                  {"half_steps", fixed(1e3 * step / 2 * static_cast<double>(bullet.exact.size()), 0)},
                  {"bullet_early", fixed(-1e3 * bullet.late(), 0)},
                  {"bullet_loss", percent(extra_loss(scene, c, bullet), 2)},
                  {"bullet_swings", percent(-bullet.longer_swings(), 1)},
                  {"ode_swings", percent(-ode.longer_swings(), 1)}},
      .tables = {{"periods", periods(scene, c)},
                 {"swings", swings(scene, c)},
                 {"lateness", lateness(impacts_of(history), bullet, ode)}},
      .player = {.time = landing.time - 0.1, .speed = 0.1, .gain = 2}};
  values.numbers.merge(slider_answers(scene, landing.time));
  return values;
}

}  // namespace rockstack
