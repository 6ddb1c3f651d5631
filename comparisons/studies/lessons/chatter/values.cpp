#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/impacts.hpp"
#include "comparisons/studies/lessons/lesson.hpp"

namespace rockstack {
namespace {

/// Impacts of the lowest interface that lead to its first closure, and the closure's time.
struct Chatter {
  std::vector<Event> impacts;
  double closure = 0;  ///< s

  /// Before the impact of that number, from 1, s.
  double flight(std::size_t n) const { return impacts[n].time - impacts[n - 1].time; }

  /// The flight with the one before it, as a share of the two before these.
  double pair(std::size_t n) const { return (flight(n) + flight(n - 1)) / (flight(n - 2) + flight(n - 3)); }
};

Chatter first_chatter(const History& history) {
  Chatter chatter;
  for (const Event& event : history.events) {
    if (event.interface != 1) continue;
    if (event.kind == EventKind::closure || event.kind == EventKind::rest) {
      chatter.closure = event.time;
      break;
    }
    if (event.kind == EventKind::impact) chatter.impacts.push_back(event);
  }
  return chatter;
}

/// The flights between impacts, and what is left of each.
Table flights(const Chatter& chatter) {
  Table table{{"impact of the base", "time (s)", "flight since the last (s)", "of the flight before",
               "with that before it, of the pair before", "speed after (rad/s)"}};
  constexpr std::size_t count = 14;
  for (std::size_t i = 0; i < std::min(count, chatter.impacts.size()); ++i)
    table.rows.push_back(
        {std::to_string(i + 1), cell(chatter.impacts[i].time), i > 0 ? cell(chatter.flight(i)) : "",
         i > 1 ? fixed(chatter.flight(i) / chatter.flight(i - 1), 4) : "",
         i > 3 ? fixed(chatter.pair(i), 4) : "", cell(std::abs(chatter.impacts[i].after[0]))});
  return table;
}

/// Impacts that the solver finds where it leaves out flights that stay below an angle, rad.
std::size_t impacts_found(const Scene& scene, double smallest) {
  return impacts_of(solve(scene, {.resolution = smallest})).size();
}

Table tolerances(const Scene& scene) {
  Table table{{"flights left out below (rad)", "impacts found"}};
  for (const double smallest : {1e-4, 1e-6, 1e-8, 1e-10, 0.0})
    table.rows.push_back({smallest > 0 ? cell(smallest) : "what roundings leave",
                          std::to_string(impacts_found(scene, smallest))});
  return table;
}

/// How long the first chatter takes in the paper's example with these changes, s.
double chatter_time(const std::vector<std::string>& changes) {
  const Chatter chatter = first_chatter(solve(read_shipped("spanos-free-rocking", changes)));
  return chatter.closure - chatter.impacts.front().time;
}

Table seen_by_engines(const Scene& scene) {
  Table table{{"solver", "step (s)", "impacts seen"}, {{"the model", "", "infinitely many"}}};
  for (const char* engine : {"bullet", "ode"})
    for (const double dt : {1e-2, 1e-3, 1e-4})
      table.rows.push_back(
          {engine, cell(dt), std::to_string(observed_impacts(scene, answer(engine, scene, dt), 0).size())});
  return table;
}

}  // namespace

LessonValues chatter_values(const Suite& suite, const std::vector<RunMetrics>& /*rows*/) {
  const Scene& scene = suite.scenes.front().scene;
  const History history = exact_answer(scene);
  const Chatter chatter = first_chatter(history);
  const std::size_t last = chatter.impacts.size() - 1;
  // A flight in the midst, where neither the approach nor rounding shows, and the one two before it.
  const std::size_t middle = chatter.impacts.size() / 2;
  const double two = chatter.flight(middle) + chatter.flight(middle - 1);
  const double pair = chatter.pair(middle);
  const double limit = chatter.impacts[middle].time + two * pair / (1 - pair);
  return {
      .numbers = {{"impacts", std::to_string(impacts_of(history).size())},
                  {"large", std::to_string(reported_impacts(scene, history, chatter_speed(scene)).size())},
                  {"speed", fixed(chatter_speed(scene), 3)},
                  {"count", std::to_string(chatter.impacts.size())},
                  {"closure", fixed(chatter.closure, 6)},
                  {"first", fixed(chatter.impacts.front().time, 4)},
                  {"pair", fixed(pair, 4)},
                  {"pair_inverse", fixed(1 / pair, 1)},
                  {"limit", fixed(limit, 6)},
                  {"apart", power(std::abs(limit - chatter.closure), 1)},
                  {"last_flight", power(chatter.flight(last), 1)},
                  {"lean", fixed(scene.initial.angles.front(), 2)},
                  {"lasts", fixed(chatter.closure - chatter.impacts.front().time, 3)},
                  {"small_lean", "0.05"},
                  {"small_lasts", fixed(chatter_time({"initial.angles=[0.05,0.05]"}), 3)},
                  {"tall", "4"},
                  {"tall_lasts", fixed(chatter_time({"blocks.2.height=4"}), 3)}},
      .tables = {{"flights", flights(chatter)},
                 {"tolerances", tolerances(scene)},
                 {"seen", seen_by_engines(scene)}},
      .player = {.time = chatter.impacts[1].time - 0.01, .speed = 0.01, .gain = 100, .chatter = true},
      // A row whose pairs shrink by one factor has no last one.
      .measured = {{"impacts_of_the_model", pair < 1 ? std::numeric_limits<double>::infinity()
                                                     : static_cast<double>(chatter.impacts.size())}}};
}

}  // namespace rockstack
