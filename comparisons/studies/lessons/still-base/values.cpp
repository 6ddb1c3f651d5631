#include <fmt/format.h>

#include "analytic/solve.hpp"
#include "comparisons/studies/lessons/lesson.hpp"
#include "comparisons/studies/lessons/mechanics.hpp"

namespace rockstack {
namespace {

constexpr double watched = 0.1;  // s after the impact in which a base that lifts has lifted

Table patterns_after(const Scene& scene, const Event& event) {
  const Model<double> model = make_model<double>(scene);
  const Impact<double> impact = impact_of(event);
  const std::array<Contact, 3> contacts{Contact::left, Contact::closed, Contact::right};
  Table table{{"pattern after", "θ̇₁ (rad/s)", "θ̇₂ (rad/s)", "opens as it should",
               "impulse of the ground (N s)", "its place from the middle (m)"}};
  for (const Contact lower : contacts)
    for (const Contact upper : contacts) {
      Pattern pattern = event.from;
      pattern[0] = lower;
      pattern[1] = upper;
      const PatternSolution<double> solution = velocities_after(model, impact, pattern);
      const Vector<double> rates = absolute(solution.relative);
      const double width = model.stack.half_width[0], push = solution.reactions.normal[0];
      const bool pushes = std::abs(push) > solution.rounding[0];
      const double place =
          lower == Contact::closed ? -solution.reactions.moment[0] / push : sign(lower) * width;
      table.rows.push_back({name(pattern), cell(rates[0], 1), cell(rates[1], 1),
                            kinematically_admissible(solution, impact.touching()) ? "yes" : "no",
                            cell(pushes ? push : 0), pushes ? cell(place) : ""});
    }
  return table;
}

/// The largest angle of the base soon after a time, rad.
double lift(const History& history, double time) {
  double most = 0;
  for (std::size_t i = 0; i < history.size(); ++i)
    if (history.times[i] > time && history.times[i] < time + watched)
      most = std::max(most, std::abs(history.angles_at(i)[0]));
  return most;
}

/// Above 0 where the base stays still under a top block of that width, by the paper's order of trials.
double stays_still(double width) {
  const Scene scene = read_shipped("squat-top", {"law=\"paper\"", fmt::format("blocks.2.width={}", width)});
  return first_event(solve(scene), EventKind::impact)->to[0] == Contact::closed ? 1 : -1;
}

}  // namespace

LessonValues still_base_values(const Suite& suite, const std::vector<RunMetrics>& /*rows*/) {
  const Scene& scene = suite.scenes.front().scene;
  const History paper = exact_answer(under(scene, Law::paper)),
                consistent = exact_answer(under(scene, Law::consistent));
  const Event& first = *first_event(paper, EventKind::impact);
  const Event& other = *first_event(consistent, EventKind::impact);
  const PatternSolution<double> kept =
      velocities_after(make_model<double>(scene), impact_of(first), first.to);
  return {.numbers = {{"time", fixed(first.time, 4)},
                      {"still_from", fixed(crossing(0.5, 1, stays_still), 2)},
                      {"still_until", fixed(crossing(1, 2.5, stays_still), 2)},
                      {"paper", name(first.to)},
                      {"consistent", name(other.to)},
                      {"speed", fixed(first.before[1], 3)},
                      {"place", fixed(-kept.reactions.moment[0] / kept.reactions.normal[0], 3)},
                      {"half_width", fixed(scene.blocks[0].half_width, 2)},
                      {"push", fixed(kept.reactions.normal[0], 0)},
                      {"loss_paper", percent(impact_energies(scene, first).share_lost(), 1)},
                      {"loss_consistent", percent(impact_energies(scene, other).share_lost(), 1)},
                      {"lift_paper", fixed(lift(paper, first.time), 4)},
                      {"lift_consistent", fixed(lift(consistent, first.time), 4)},
                      {"lift_bullet", fixed(lift(answer("bullet", scene, 1e-4), first.time), 4)},
                      {"lift_ode", fixed(lift(answer("ode", scene, 1e-4), first.time), 4)}},
          .tables = {{"candidates", patterns_after(scene, first)}},
          .player = {.time = first.time - 0.01, .speed = 0.05, .gain = 10}};
}

}  // namespace rockstack
