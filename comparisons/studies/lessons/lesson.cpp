#include "comparisons/studies/lessons/lesson.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analytic/scene/input/scene_file.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/difference.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
const std::vector<Lesson>& lessons() {
  static const std::vector<Lesson> list{
#include "comparisons/studies/lessons/lesson_list.inc"
  };
  return list;
}

std::string title(const Lesson& lesson) {
  return read_suite(shipped("studies/lessons") / lesson.name / "suite.toml", {}).title;
}

const Lesson& find_lesson(const std::string& name) {
  const auto found = std::ranges::find(lessons(), name, &Lesson::name);
  if (found != lessons().end()) return *found;
  const std::vector<std::string> names = mapped(lessons(), &Lesson::name);
  throw InputError(
      fmt::format("teach {}: must be one of {}{}", name, fmt::join(names, ", "), did_you_mean(name, names)));
}

History answer(const std::string& engine, const Scene& scene, double dt, const Parameters& changes,
               const std::string& settings) {
  const EngineSeries series = make_series(find_engine(engine), settings, {dt}, changes);
  return simulate(*series.engine, scene, dt, series.parameters).history;
}

History exact_answer(const Scene& scene, double interval) {
  return solve(scene, {.sample_times = regular_times(interval, scene.duration)});
}

double error_of(const Scene& scene, const History& answer) {
  return root_mean_square(difference(solve(scene, {.sample_times = answer.times}), answer));
}

std::vector<double> errors_of_draws(const Suite& suite, const std::string& engine, double dt,
                                    const Parameters& changes, const std::string& settings) {
  std::vector<double> errors;
  for (int i = 0; i < suite.replicates.runs; ++i) {
    const Scene scene = replicate_scene(suite.scenes.front().scene, suite.replicates, i);
    const double step = replicate_step(dt, suite.replicates, i);
    errors.push_back(error_of(scene, answer(engine, scene, step, changes, settings)));
  }
  return errors;
}

Scene read_shipped(const std::string& scene, const std::vector<std::string>& overrides) {
  return read_scene(shipped("scenes") / (scene + ".toml"), overrides);
}

Scene under(Scene scene, Law law) {
  scene.law = law;
  return scene;
}

Scene lasting(Scene scene, double duration) {
  scene.duration = duration;
  return scene;
}

double weight_of(const Scene& scene) {
  double weight = 0;
  for (const Block& block : scene.blocks) weight += block.mass * scene.gravity;
  return weight;
}

const RunMetrics& find_run(const std::vector<RunMetrics>& rows, const std::string& engine, double dt) {
  const auto found = std::ranges::find_if(rows, [&](const RunMetrics& row) {
    return (row.engine == engine || row.engine + ":" + row.solver == engine) && row.settings == "tuned" &&
           row.dt == dt;
  });
  if (found == rows.end())
    throw std::logic_error(fmt::format("lesson: no run of {}, tuned, {} s", engine, dt));
  return *found;
}

double crossing(double low, double high, const std::function<double(double)>& value) {
  const bool rises = value(high) > 0;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    ((value(middle) > 0) == rises ? high : low) = middle;
  }
  return high;
}

const Event* first_event(const History& history, EventKind kind) {
  const auto found = std::ranges::find(history.events, kind, &Event::kind);
  return found == history.events.end() ? nullptr : &*found;
}

std::vector<Event> impacts_of(const History& history) {
  std::vector<Event> impacts = history.events;
  std::erase_if(impacts, [](const Event& event) { return event.kind != EventKind::impact; });
  return impacts;
}

std::string fixed(double value, int digits) {
  const std::string text = fmt::format("{:.{}f}", std::abs(value), digits);
  const bool zero = text.find_first_not_of("0.") == std::string::npos;
  return (value < 0 && !zero ? "−" : "") + text;
}

std::string power(double value, int digits) {
  if (value == 0) return "0";
  return (value < 0 ? "−" : "") + with_power(fmt::format("{:.{}e}", std::abs(value), digits));
}

std::string percent(double share, int digits) {
  return fixed(100 * share, digits) + " %";
}

std::string cell(double value, double scale) {
  constexpr double rounding = 1e-12;
  return fmt::format("{}", std::abs(value) < rounding * scale ? 0 : value);
}

}  // namespace rockstack
