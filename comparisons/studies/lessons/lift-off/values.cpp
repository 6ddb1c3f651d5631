#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/studies/lessons/lesson.hpp"
#include "comparisons/studies/lessons/mechanics.hpp"

namespace rockstack {
namespace {

/// Velocities of centres at a time, m/s: of the lowest block along the ground, then up.
std::vector<double> rates_at(const Scene& scene, double time) {
  return solve(scene, {.sample_times = {time}}).centre_velocities;
}

InterfaceSummary summary_of(const Scene& scene) {
  return contact_summary(exact_answer(scene, 1e-4)).front();
}

Table amplitudes(Scene scene) {
  Table table{{"amplitude (g)", "least normal force by pivots (weights)", "lifts off at (s)", "lands at (s)",
               "highest gap (mm)"}};
  for (const double share : {0.8, 0.99, 1.5, 2.0, 3.0}) {
    scene.vertical.pulse->amplitude = share * scene.gravity;
    const History history = solve(scene);
    const Event* lift = first_event(history, EventKind::lift_off);
    const Event* landing = first_event(history, EventKind::impact);
    table.rows.push_back({cell(share), cell(contact_need(scene).force.least_normal / weight_of(scene)),
                          lift != nullptr ? cell(lift->time) : "",
                          landing != nullptr ? cell(landing->time) : "",
                          lift != nullptr ? cell(1e3 * summary_of(scene).highest_lift) : ""});
  }
  return table;
}

/// The flight in closed form and by the solver, which is read a nanosecond before and after the landing.
Table flight(const Scene& scene, const Throw& thrown, double landing) {
  constexpr double aside = 1e-9;  // s
  return {
      {"", "closed form", "exact solver"},
      {{"highest gap (mm)", fixed(1e3 * thrown.highest, 2), fixed(1e3 * summary_of(scene).highest_lift, 2)},
       {"lands at (s)", fixed(thrown.landing, 6), fixed(landing, 6)},
       {"speed at the landing (m/s)", fixed(thrown.landing_rate, 5),
        fixed(-rates_at(scene, landing - aside)[1], 5)},
       {"speed after it (m/s)", "0", fixed(rates_at(scene, landing + aside)[1], 5)}}};
}

/// The block slides from the start, at `speed`, and is thrown on its way.
Table slides(Scene scene, const Throw& thrown, double speed) {
  Table table{{"friction", "after the landing (m/s): v₀ − μ g t", "exact solver", "stops at (s): v₀/(μ g)",
               "exact solver", "slides (m): closed form", "exact solver", "without the throw (m)"}};
  for (const double friction : {0.1, 0.2, 0.4}) {
    scene.initial.slip_velocities = {speed};
    scene.friction = {friction};
    scene.duration = 1.1 * speed / (friction * scene.gravity);
    const Slide form = slide_through(thrown, speed, friction, scene.gravity);
    const History history = solve(scene, {.sample_times = {scene.duration}});
    const double landing = first_event(history, EventKind::impact)->time;
    constexpr double later = 1e-9;  // s: the speed falls by 1e-8 m/s
    table.rows.push_back({cell(friction), cell(form.after_landing), cell(rates_at(scene, landing + later)[0]),
                          cell(form.stop), cell(history.events.back().time), cell(form.distance),
                          cell(history.slips.back()), cell(speed * speed / (2 * friction * scene.gravity))});
  }
  return table;
}

}  // namespace

LessonValues lift_off_values(const Suite& suite, const std::vector<RunMetrics>& /*rows*/) {
  const Scene& scene = suite.scenes.front().scene;
  const Pulse& pulse = *scene.vertical.pulse;
  const Throw thrown = thrown_by_sine(pulse.amplitude, pulse.period, scene.gravity);
  const History history = solve(scene);
  const Event& lift = *first_event(history, EventKind::lift_off);
  const Event& landing = *first_event(history, EventKind::impact);
  const ContactNeed tied = contact_need(scene);
  const Throw slow = thrown_by_sine(pulse.amplitude, 2 * pulse.period, scene.gravity);
  constexpr double speed = 3;  // m/s
  return {.numbers = {{"amplitude", fixed(pulse.amplitude / scene.gravity, 0)},
                      {"period", fixed(pulse.period, 1)},
                      {"lift_form", fixed(thrown.lift_off, 6)},
                      {"lift", fixed(lift.time, 6)},
                      {"rate", fixed(thrown.lift_off_rate, 4)},
                      {"flight", fixed(landing.time - lift.time, 3)},
                      {"pull", fixed(-tied.force.least_normal / weight_of(scene), 1)},
                      {"pull_from", fixed(tied.first_pull(), 4)},
                      {"least_amplitude", fixed(scene.gravity, 2)},
                      {"highest", fixed(1e3 * thrown.highest, 0)},
                      {"highest_slow", fixed(1e3 * slow.highest, 0)},
                      {"speed", fixed(speed, 0)}},
          .tables = {{"flight", flight(scene, thrown, landing.time)},
                     {"amplitudes", amplitudes(scene)},
                     {"slides", slides(scene, thrown, speed)}},
          .player = {.time = lift.time - 0.01, .speed = 0.1, .gain = 1}};
}

}  // namespace rockstack
