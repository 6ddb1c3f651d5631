#include "analytic/solve.hpp"
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

}  // namespace

LessonValues housner_values(const Suite& suite, const std::vector<RunMetrics>& rows) {
  const Scene& scene = suite.scenes.front().scene;
  const Constants c = constants(scene);
  const History history = exact_answer(scene);
  const Event& landing = *first_event(history, EventKind::impact);
  const ImpactEnergies energies = impact_energies(scene, landing);
  const double share = scene.initial.angles.front() / c.alpha;
  const RunMetrics &bullet = find_run(rows, "bullet", 1e-3), &ode = find_run(rows, "ode", 1e-3);
  const Model<double> model = make_model<double>(scene);
  const Vector<double> none = Vector<double>::Zero(1);
  const double stored = energy(model, State<double>{landing.from, vector_of(scene.initial.angles), none}) -
                        energy(model, State<double>{closed_pattern(1), none, none});
  return {.numbers = {{"alpha", fixed(c.alpha, 4)},
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
                      {"bullet_first", power(*bullet.first_impact_time_difference, 1)},
                      {"ode_first", power(*ode.first_impact_time_difference, 1)},
                      {"bullet_latest", fixed(*bullet.largest_impact_time_difference, 2)},
                      {"ode_latest", fixed(*ode.largest_impact_time_difference, 2)},
                      {"bullet_missed", std::to_string(*bullet.impacts_missed)},
                      {"impacts", std::to_string(impacts_of(history).size())}},
          .tables = {{"periods", periods(scene, c)}, {"swings", swings(scene, c)}},
          .player = {.time = landing.time - 0.1, .speed = 0.1, .gain = 2}};
}

}  // namespace rockstack
