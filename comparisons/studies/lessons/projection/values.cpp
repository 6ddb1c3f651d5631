#include <fmt/format.h>

#include "analytic/solve.hpp"
#include "comparisons/studies/lessons/lesson.hpp"
#include "comparisons/studies/lessons/mechanics.hpp"

namespace rockstack {
namespace {

Table balance(const Scene& scene, const std::vector<Event>& impacts) {
  Table table{{"time (s)", "interface", "pattern", "energy before (J)", "energy after (J)",
               "energy of the jump (J)", "before − after − jump (J)", "share lost"}};
  for (const Event& impact : impacts) {
    const ImpactEnergies e = impact_energies(scene, impact);
    table.rows.push_back({cell(impact.time), std::to_string(impact.interface),
                          name(impact.from) + " → " + name(impact.to), cell(e.before), cell(e.after),
                          cell(e.jump), cell(e.before - e.after - e.jump), cell(e.share_lost())});
  }
  return table;
}

/// Every pattern that could follow, with what it would bring.
Table candidates(const Scene& scene, const Event& event) {
  const Model<double> model = make_model<double>(scene);
  const Impact<double> impact = impact_of(event);
  Table table{
      {"pattern after", "θ̇₁ (rad/s)", "θ̇₂ (rad/s)", "opens as it should", "least pivot impulse (N s)"}};
  for (const Contact contact : {Contact::left, Contact::closed, Contact::right}) {
    Pattern pattern = event.from;
    pattern[event.interface - 1] = contact;
    const PatternSolution<double> solution = velocities_after(model, impact, pattern);
    const Vector<double> rates = absolute(solution.relative);
    Eigen::Index weakest = 0;
    const double least = solution.reactions.normal.minCoeff(&weakest);
    table.rows.push_back({name(pattern), cell(rates[0], 1), cell(rates[1], 1),
                          kinematically_admissible(solution, impact.touching()) ? "yes" : "no",
                          cell(std::abs(least) > solution.rounding[weakest] ? least : 0)});
  }
  return table;
}

/// The first impact of the scene with these changes.
Event first_impact(const std::vector<std::string>& changes) {
  return *first_event(solve(read_shipped("spanos-free-rocking", changes)), EventKind::impact);
}

Event with_top_block(double height) {
  return first_impact({fmt::format("blocks.2.height={}", height)});
}

}  // namespace

LessonValues projection_values(const Suite& suite, const std::vector<RunMetrics>& /*rows*/) {
  const Scene& scene = suite.scenes.front().scene;
  std::vector<Event> impacts = impacts_of(exact_answer(scene));
  impacts.resize(std::min<std::size_t>(impacts.size(), 8));
  const Event& first = impacts.front();
  const ImpactEnergies e = impact_energies(scene, first);
  double worst = 0;
  for (const Event& impact : impacts) {
    const ImpactEnergies one = impact_energies(scene, impact);
    worst = std::max(worst, std::abs(one.before - one.after - one.jump) / one.before);
  }
  // The drawing is to scale: lengths are roots of energies, and that before the impact is as long as
  // `length`.
  constexpr double left = 60, ground = 230, length = 520;
  constexpr double low = 1;  // m
  const Event landing = with_top_block(low);
  const double least_height =
      crossing(low, 2.5, [&](double height) { return with_top_block(height).to == landing.to ? -1 : 1; });
  return {.numbers = {{"time", fixed(first.time, 5)},
                      {"least_height", fixed(least_height, 2)},
                      {"low_from", name(landing.from)},
                      {"low_to", name(landing.to)},
                      {"small_lean", "0.02"},
                      {"small_to", name(first_impact({"initial.angles=[0.02,0.02]"}).to)},
                      {"from", name(first.from)},
                      {"to", name(first.to)},
                      {"before_1", fixed(first.before[0], 4)},
                      {"before_2", fixed(first.before[1], 4)},
                      {"after_1", fixed(first.after[0], 4)},
                      {"after_2", fixed(first.after[1], 4)},
                      {"energy_before", fixed(e.before, 1)},
                      {"energy_after", fixed(e.after, 1)},
                      {"energy_jump", fixed(e.jump, 1)},
                      {"lost", percent(e.share_lost(), 1)},
                      {"worst", power(worst, 0)},
                      {"foot_x", fixed(left + length * std::sqrt(e.after / e.before), 1)},
                      {"middle_x", fixed(left + length / 2 * std::sqrt(e.after / e.before), 1)},
                      {"tip_y", fixed(ground - length * std::sqrt(e.jump / e.before), 1)},
                      {"half_y", fixed(ground - length / 2 * std::sqrt(e.jump / e.before), 1)},
                      {"top_gain", percent(first.after[1] / first.before[1] - 1, 0)}},
          .tables = {{"balance", balance(scene, impacts)}, {"candidates", candidates(scene, first)}},
          .player = {.time = first.time - 0.01, .speed = 0.01, .gain = 4}};
}

}  // namespace rockstack
