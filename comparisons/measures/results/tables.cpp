#include "comparisons/measures/results/tables.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "comparisons/measures/metrics/bodies.hpp"
#include "comparisons/measures/results/csv.hpp"

namespace rockstack {
namespace {

const char* side_name(Contact side) {
  return side == Contact::left ? "left" : side == Contact::right ? "right" : "closed";
}

/// Adds where a motion ends, and both sides of where it jumps as it starts or ends: times next to each other,
/// s.
void add_edges(const GroundMotion& motion, std::vector<double>& times) {
  if (motion.empty()) return;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double largest = motion.pulse ? std::abs(motion.pulse->amplitude) : peak(motion);
  const auto add_jump = [&](double last, double next) {
    const double jump = acceleration(motion, next) - acceleration(motion, last);
    if (std::abs(jump) > 1e-12 * largest) times.insert(times.end(), {last, next});
  };
  const double end = motion.end();
  if (motion.pulse && motion.pulse->start > 0)
    add_jump(std::nextafter(motion.pulse->start, 0), motion.pulse->start);
  if (end < infinity) {
    times.push_back(end);
    add_jump(end, std::nextafter(end, infinity));
  }
}

/// Times that show all of the ground motion up to the end of the scene, s.
std::vector<double> ground_times(const Scene& scene) {
  std::vector<double> times{0, scene.duration};
  for (const GroundMotion* motion : {&scene.horizontal, &scene.vertical}) {
    const double interval = motion->pulse ? 1e-3 : motion->interval;
    const double end = std::min(motion->end(), scene.duration);
    for (int i = 1; interval > 0 && i * interval <= end; ++i) times.push_back(i * interval);
    add_edges(*motion, times);
  }
  std::ranges::sort(times);
  times.erase(std::ranges::upper_bound(times, scene.duration), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace

std::string cell_text(const Json& cell) {
  if (cell.is_null()) return "";
  if (cell.is_number_float()) return fmt::format("{}", cell.get<double>());
  return cell.is_string() ? cell.get<std::string>() : cell.dump();
}

std::string csv_of(const Json& list) {
  CsvWriter csv;
  for (const auto& [name, cell] : list.at(0).items()) csv.add(name);
  csv.end_line();
  for (const Json& row : list) {
    for (const Json& cell : row) csv.add(cell_text(cell));
    csv.end_line();
  }
  return csv.text();
}

std::string history_csv(const History& history) {
  const bool patterns = !history.patterns.empty(), slips = !history.slips.empty();
  const bool gaps = !history.gaps.empty(), places = !history.centres.empty();
  CsvWriter csv;
  csv.add("time", numbered("theta_", history.blocks), numbered("omega_", history.blocks));
  if (patterns) csv.add("pattern");
  if (slips) csv.add(numbered("slip_", history.blocks));
  if (gaps) csv.add(numbered("gap_", history.blocks));
  if (places) csv.add(numbered_in_turn({"x_", "y_"}, history.blocks));
  csv.end_line();
  for (std::size_t i = 0; i < history.size(); ++i) {
    csv.add(history.times[i], history.angles_at(i), history.velocities_at(i));
    if (patterns) csv.add(name(history.patterns[i]));
    if (slips) csv.add(history.row(history.slips, i));
    if (gaps) csv.add(history.row(history.gaps, i));
    if (places) csv.add(history.row(history.centres, 2 * i), history.row(history.centres, 2 * i + 1));
    csv.end_line();
  }
  return csv.text();
}

std::string events_csv(const History& history) {
  const int blocks = history.blocks;
  CsvWriter csv;
  csv.line("time", "kind", "interface", "from", "to", numbered("theta_", blocks),
           numbered("omega_before_", blocks), numbered("omega_after_", blocks), "consistency");
  for (const Event& event : history.events)
    csv.line(event.time, name(event.kind), event.interface, name(event.from), name(event.to), event.angles,
             event.before, event.after, name(event.consistency));
  return csv.text();
}

std::string ground_csv(const Scene& scene) {
  CsvWriter csv;
  csv.line("time", "horizontal", "vertical");
  for (const double time : ground_times(scene))
    csv.line(time, acceleration(scene.horizontal, time), acceleration(scene.vertical, time));
  return csv.text();
}

std::string difference_csv(const Difference& difference) {
  CsvWriter csv;
  csv.line("time", numbered("difference_", static_cast<int>(difference.blocks)));
  for (std::size_t i = 0; i < difference.times.size(); ++i) csv.line(difference.times[i], difference.at(i));
  return csv.text();
}

std::string parts_csv(const DifferenceParts& parts) {
  const auto blocks = static_cast<int>(parts.model.blocks);
  CsvWriter csv;
  csv.line("time", numbered("model_", blocks), numbered("softness_", blocks), numbered("step_", blocks));
  for (std::size_t i = 0; i < parts.model.times.size(); ++i)
    csv.line(parts.model.times[i], parts.model.at(i), parts.softness.at(i), parts.step.at(i));
  return csv.text();
}

std::string impacts_csv(const std::vector<AlignedImpact>& alignment) {
  CsvWriter csv;
  csv.line("number", "interface", "exact_time", "engine_time", "difference", "verdict", "exact_side",
           "engine_side");
  for (const AlignedImpact& line : alignment) {
    const bool both = line.exact && line.engine;
    csv.line(line.number, line.interface, line.exact, line.engine,
             both ? std::optional(*line.engine - *line.exact) : std::nullopt,
             both         ? "matched"
             : line.exact ? "missed"
                          : "extra",
             line.exact ? side_name(line.exact_side) : "", line.engine ? side_name(line.engine_side) : "");
  }
  return csv.text();
}

std::string patterns_csv(const std::vector<PatternShare>& shares) {
  CsvWriter csv;
  csv.line("exact", "engine", "share");
  for (const PatternShare& one : shares) csv.line(name(one.exact), name(one.engine), one.share);
  return csv.text();
}

std::string energy_csv(const std::vector<double>& times, const std::vector<double>& exact,
                       const BodyRecord& engine) {
  const std::vector<double> elastic = elastic_energy(engine);
  const auto balance = energy_balance(engine.energy, engine.input, elastic);
  CsvWriter csv;
  csv.line("time", "exact", "engine", "input", "elastic", "balance", "penetration");
  for (std::size_t i = 0; i < times.size(); ++i)
    csv.line(times[i], exact[i], engine.energy[i], engine.input[i], elastic[i], balance[i],
             engine.penetration[i]);
  return csv.text();
}

}  // namespace rockstack
