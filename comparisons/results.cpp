#include "comparisons/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "comparisons/table.hpp"

namespace rockstack {
namespace {

using Json = nlohmann::ordered_json;

template <class Value>
Json json(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

/// A cell of comma-separated values; numbers read back to the same double.
std::string csv_cell(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_number_float()) return fmt::format("{}", value.get<double>());
  if (!value.is_string()) return value.dump();
  return text_cell(value.get_ref<const std::string&>());
}

/// Text that grows line by line.
class Lines {
 public:
  template <class... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Values>(values)...);
  }

  template <class Range>
  void add_numbers(const Range& values) {
    for (const double number : values) add(",{}", number);
  }

  void add_names(const char* stem, int count) {
    for (int k = 1; k <= count; ++k) add(",{}_{}", stem, k);
  }

  std::string text() const { return fmt::to_string(buffer_); }

 private:
  fmt::memory_buffer buffer_;
};

/// Times that show all of the ground motion up to the end of the scene, s.
std::vector<double> ground_times(const Scene& scene) {
  std::vector<double> times{0, scene.duration};
  for (const GroundMotion* motion : {&scene.horizontal, &scene.vertical}) {
    const double interval = motion->pulse ? 1e-3 : motion->interval;
    const double end = std::min(motion->end(), scene.duration);
    for (int i = 1; interval > 0 && i * interval <= end; ++i) times.push_back(i * interval);
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace

const std::vector<Column>& columns() {
  static const std::vector<Column> list{
      {"run", "name of the run, and of its folder under runs/", [](const Row& row) { return Json(row.run); }},
      {"scene", "name of the scene", [](const Row& row) { return Json(row.scene); }},
      {"engine", "\"exact\", or the engine's name", [](const Row& row) { return Json(row.engine); }},
      {"solver", "integrator of the exact solver, or the engine's constraint solver",
       [](const Row& row) { return Json(row.solver); }},
      {"settings",
       "the engine's parameter set: default is what a user gets who sets nothing but friction and "
       "restitution; tuned suits this problem best",
       [](const Row& row) { return Json(row.settings); }},
      {"dt", "time step, s; for the exact solver the longest", [](const Row& row) { return json(row.dt); }},
      {"status",
       "done; or what kept the run from it: failed (an error that the engine or the solver reports), not "
       "finite (an angle or velocity), signal (the engine's process was ended, as by an assertion), time "
       "limit or memory limit",
       [](const Row& row) { return Json(row.status); }},
      {"reason", "why a run is not done", [](const Row& row) { return Json(row.reason); }},
      {"steps", "time steps that the engine made; fewer than the duration holds where a block toppled",
       [](const Row& row) { return json(row.steps); }},
      {"stepping_time_minimum",
       "least wall time of stepping alone (for the exact solver: of solving), over the repeats, s",
       [](const Row& row) { return json(row.stepping_time_minimum); }},
      {"stepping_time_median", "median of the same times, s",
       [](const Row& row) { return json(row.stepping_time_median); }},
      {"stepping_time_spread", "largest less smallest of the same times, s",
       [](const Row& row) { return json(row.stepping_time_spread); }},
      {"repeats", "timed runs, after a warm-up that is not counted",
       [](const Row& row) { return json(row.repeats); }},
      {"processor_time",
       "user and system time of the engine's process, as the operating system accounts for it: the run that "
       "gives the history, all timed runs, building and reading, s",
       [](const Row& row) { return json(row.processor_time); }},
      {"peak_memory", "largest resident memory of the engine's process, the history included, bytes",
       [](const Row& row) { return json(row.peak_memory); }},
      {"largest_angle_difference",
       "largest absolute difference of any block's angle, at the engine's own times, rad",
       [](const Row& row) { return json(row.largest_angle_difference); }},
      {"rms_angle_difference", "root of the mean square of that difference over all times and blocks, rad",
       [](const Row& row) { return json(row.rms_angle_difference); }},
      {"first_impact_time_difference", "time of the engine's first impact less that of the exact one's, s",
       [](const Row& row) { return json(row.first_impact_time_difference); }},
      {"impacts_matched",
       "impacts above the chatter speed that both have, in order, within the matching window",
       [](const Row& row) { return json(row.impacts_matched); }},
      {"impacts_missed", "exact impacts above the chatter speed that the engine does not have",
       [](const Row& row) { return json(row.impacts_missed); }},
      {"impacts_extra", "engine impacts above the chatter speed that the exact solution does not have",
       [](const Row& row) { return json(row.impacts_extra); }},
      {"agreement_time",
       "time until which no angle differs by more than the tolerance; the end where none ever does, s",
       [](const Row& row) { return json(row.agreement_time); }},
      {"warnings",
       "how often the engine said that its solver failed, and went on: ODE with what it had, Bullet with "
       "sequential impulse in place of an mlcp solver",
       [](const Row& row) { return json(row.warnings); }},
      {"toppled", "block that passed its toppling angle and when, which ends the run",
       [](const Row& row) { return Json(row.toppled); }},
  };
  return list;
}

std::string comparison_csv(const std::vector<Row>& rows) {
  Lines lines;
  const char* separator = "";
  for (const Column& column : columns()) {
    lines.add("{}{}", separator, column.name);
    separator = ",";
  }
  lines.add("\n");
  for (const Row& row : rows) {
    separator = "";
    for (const Column& column : columns()) {
      lines.add("{}{}", separator, csv_cell(column.cell(row)));
      separator = ",";
    }
    lines.add("\n");
  }
  return lines.text();
}

std::string history_csv(const History& history) {
  Lines lines;
  lines.add("time");
  lines.add_names("theta", history.blocks);
  lines.add_names("omega", history.blocks);
  lines.add("{}\n", history.patterns.empty() ? "" : ",pattern");
  for (std::size_t i = 0; i < history.size(); ++i) {
    lines.add("{}", history.times[i]);
    lines.add_numbers(history.angles_at(i));
    lines.add_numbers(history.velocities_at(i));
    if (!history.patterns.empty()) lines.add(",{}", name(history.patterns[i]));
    lines.add("\n");
  }
  return lines.text();
}

std::string events_csv(const History& history) {
  Lines lines;
  lines.add("time,kind,interface,from,to");
  lines.add_names("theta", history.blocks);
  lines.add_names("omega_before", history.blocks);
  lines.add_names("omega_after", history.blocks);
  lines.add(",consistency\n");
  for (const Event& event : history.events) {
    lines.add("{},{},{},{},{}", event.time, name(event.kind), event.interface, name(event.from),
              name(event.to));
    lines.add_numbers(event.angles);
    lines.add_numbers(event.before);
    lines.add_numbers(event.after);
    lines.add(",{}\n", name(event.consistency));
  }
  return lines.text();
}

std::string ground_csv(const Scene& scene) {
  Lines lines;
  lines.add("time,horizontal,vertical\n");
  for (const double time : ground_times(scene))
    lines.add("{},{},{}\n", time, acceleration(scene.horizontal, time), acceleration(scene.vertical, time));
  return lines.text();
}

std::string difference_csv(const Difference& difference) {
  Lines lines;
  lines.add("time");
  lines.add_names("difference", static_cast<int>(difference.blocks));
  lines.add("\n");
  for (std::size_t i = 0; i < difference.times.size(); ++i) {
    lines.add("{}", difference.times[i]);
    for (std::size_t k = 0; k < difference.blocks; ++k)
      lines.add(",{}", difference.angles[i * difference.blocks + k]);
    lines.add("\n");
  }
  return lines.text();
}

std::string impacts_csv(const std::vector<AlignedImpact>& alignment) {
  const auto cell = [](const auto& value) { return value ? fmt::format("{}", *value) : std::string(); };
  Lines lines;
  lines.add("number,interface,exact_time,engine_time,difference,verdict\n");
  for (const AlignedImpact& line : alignment) {
    const bool both = line.exact && line.engine;
    const std::string apart = both ? fmt::format("{}", *line.engine - *line.exact) : "";
    lines.add("{},{},{},{},{},{}\n", cell(line.number), line.interface, cell(line.exact), cell(line.engine),
              apart,
              both         ? "matched"
              : line.exact ? "missed"
                           : "extra");
  }
  return lines.text();
}

}  // namespace rockstack
