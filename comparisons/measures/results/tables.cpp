#include "comparisons/measures/results/tables.hpp"

#include <fmt/format.h>

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

namespace fs = std::filesystem;

History samples_in(const fs::path& file) {
  History history;
  CsvLine line(file);
  int& blocks = history.blocks;
  while (blocks < max_blocks && line.has(fmt::format("theta_{}", blocks + 1))) ++blocks;
  const std::size_t time = line.index("time");
  // What a history may leave out has no columns.
  const auto columns = [&](const std::vector<std::string>& names) {
    return line.has(names.front()) ? line.indices(names) : CsvLine::Indices();
  };
  const CsvLine::Indices angles = line.indices(numbered("theta_", std::max(blocks, 1))),
                         velocities = line.indices(numbered("omega_", blocks)),
                         pattern = columns({"pattern"}), slips = columns(numbered("slip_", blocks)),
                         gaps = columns(numbered("gap_", blocks)),
                         places = columns(numbered_in_turn({"x_", "y_"}, blocks));
  const auto named = [&](const auto& name) { return named_pattern(name, blocks); };
  for (std::string last; line.next();) {
    history.times.push_back(line.value(time));
    line.add(angles, history.angles);
    line.add(velocities, history.velocities);
    line.add(slips, history.slips);
    line.add(gaps, history.gaps);
    line.add(places, history.centres);
    if (pattern.empty()) continue;
    const std::string& text = line.text(pattern[0]);
    history.patterns.push_back(text == last ? history.patterns.back() : line.named(pattern[0], named));
    last = text;
  }
  return history;
}

std::vector<Event> events_in(const fs::path& file, int blocks) {
  std::vector<Event> events;
  CsvLine line(file);
  const CsvLine::Indices angles = line.indices(numbered("theta_", blocks)),
                         before = line.indices(numbered("omega_before_", blocks)),
                         after = line.indices(numbered("omega_after_", blocks));
  const auto pattern = [&](const auto& name) { return named_pattern(name, blocks); };
  while (line.next()) {
    Event& event = events.emplace_back();
    event.time = line.value("time");
    event.kind = line.named(line.index("kind"), named_event);
    event.interface = line.whole(line.index("interface"), 1, blocks);
    event.from = line.named(line.index("from"), pattern);
    event.to = line.named(line.index("to"), pattern);
    line.add(angles, event.angles);
    line.add(before, event.before);
    line.add(after, event.after);
    event.consistency = line.named(line.index("consistency"), named_consistency);
    if (line.has("approach")) event.approach = line.known(line.index("approach"));
  }
  return events;
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
  const bool lands = !history.gaps.empty();
  CsvWriter csv;
  csv.add("time", "kind", "interface", "from", "to", numbered("theta_", blocks),
          numbered("omega_before_", blocks), numbered("omega_after_", blocks), "consistency");
  if (lands) csv.add("approach");
  csv.end_line();
  for (const Event& event : history.events) {
    csv.add(event.time, name(event.kind), event.interface, name(event.from), name(event.to), event.angles,
            event.before, event.after, name(event.consistency));
    if (lands) csv.add(event.approach);
    csv.end_line();
  }
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

std::string impulses_csv(const std::vector<ImpactImpulse>& impulses) {
  CsvWriter csv;
  csv.line("number", "interface", "exact_time", "engine_time", "exact_normal", "engine_normal",
           "exact_tangential", "engine_tangential");
  for (const ImpactImpulse& one : impulses)
    csv.line(one.number, one.interface, one.exact_time, one.engine_time, one.exact.normal, one.engine.normal,
             one.exact.tangential, one.engine.tangential);
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

History read_history(const fs::path& folder) {
  History history = samples_in(folder / "history.csv");
  if (const fs::path file = folder / "events.csv"; fs::exists(file))
    history.events = events_in(file, history.blocks);
  return history;
}

std::vector<AlignedImpact> read_impacts(const fs::path& file) {
  std::vector<AlignedImpact> list;
  CsvLine line(file);
  const std::size_t number = line.index("number"), interface = line.index("interface");
  const std::size_t exact = line.index("exact_time"), engine = line.index("engine_time");
  while (line.next()) {
    AlignedImpact& one = list.emplace_back();
    if (!line.text(number).empty()) one.number = line.whole(number, 1, std::numeric_limits<int>::max());
    one.interface = line.whole(interface, 1, max_blocks);
    one.exact = line.known(exact);
    one.engine = line.known(engine);
  }
  return list;
}

}  // namespace rockstack
