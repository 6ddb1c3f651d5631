#include "comparisons/measures/results/tables.hpp"

#include <fmt/format.h>

#include "comparisons/measures/results/csv.hpp"

namespace rockstack {
namespace {

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
  }
  return events;
}

}  // namespace

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
