#include "comparisons/measures/results/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "analytic/scene/history.hpp"
#include "comparisons/measures/results/csv.hpp"

namespace rockstack {
namespace {

namespace fs = std::filesystem;
/// The centres of mass, x and y in turn.
std::vector<std::string> place_names(int blocks) {
  std::vector<std::string> names;
  for (int k = 1; k <= blocks; ++k)
    names.insert(names.end(), {fmt::format("x_{}", k), fmt::format("y_{}", k)});
  return names;
}

int blocks_in(const CsvLine& line) {
  int blocks = 0;
  while (blocks < max_blocks && line.has(fmt::format("theta_{}", blocks + 1))) ++blocks;
  return blocks;
}

History samples_in(const fs::path& file) {
  History history;
  CsvLine line(file);
  std::size_t time = 0;
  std::optional<std::size_t> pattern;
  CsvLine::Indices angles, velocities, slips, gaps, places;
  std::string last;
  line.read(
      [&] {
        const int blocks = history.blocks = blocks_in(line);
        time = line.index("time");
        angles = line.indices(numbered("theta_", std::max(blocks, 1)));
        velocities = line.indices(numbered("omega_", blocks));
        if (line.has("pattern")) pattern = line.index("pattern");
        if (line.has("slip_1")) slips = line.indices(numbered("slip_", blocks));
        if (line.has("gap_1")) gaps = line.indices(numbered("gap_", blocks));
        if (line.has("x_1")) places = line.indices(place_names(blocks));
      },
      [&] {
        history.times.push_back(line.value(time));
        line.add(angles, history.angles);
        line.add(velocities, history.velocities);
        line.add(slips, history.slips);
        line.add(gaps, history.gaps);
        line.add(places, history.centres);
        if (!pattern) return;
        const std::string& text = line.text(*pattern);
        history.patterns.push_back(text == last ? history.patterns.back()
                                                : line.named(*pattern, [&](const auto& name) {
                                                    return named_pattern(name, history.blocks);
                                                  }));
        last = text;
      });
  return history;
}

std::vector<Event> events_in(const fs::path& file, int blocks) {
  std::vector<Event> events;
  CsvLine line(file);
  std::size_t time = 0, kind = 0, interface = 0, from = 0, to = 0, consistency = 0;
  CsvLine::Indices angles, before, after;
  const auto pattern = [&](const auto& name) { return named_pattern(name, blocks); };
  line.read(
      [&] {
        time = line.index("time"), kind = line.index("kind"), interface = line.index("interface");
        from = line.index("from"), to = line.index("to"), consistency = line.index("consistency");
        angles = line.indices(numbered("theta_", blocks));
        before = line.indices(numbered("omega_before_", blocks));
        after = line.indices(numbered("omega_after_", blocks));
      },
      [&] {
        Event& event = events.emplace_back();
        event.time = line.value(time);
        event.kind = line.named(kind, named_event);
        event.interface = line.whole(interface, 1, blocks);
        event.from = line.named(from, pattern);
        event.to = line.named(to, pattern);
        line.add(angles, event.angles);
        line.add(before, event.before);
        line.add(after, event.after);
        event.consistency = line.named(consistency, named_consistency);
      });
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
  std::size_t number = 0, interface = 0, exact = 0, engine = 0;
  line.read(
      [&] {
        number = line.index("number"), interface = line.index("interface");
        exact = line.index("exact_time"), engine = line.index("engine_time");
      },
      [&] {
        AlignedImpact& one = list.emplace_back();
        if (!line.text(number).empty()) one.number = line.whole(number, 1, std::numeric_limits<int>::max());
        one.interface = line.whole(interface, 1, max_blocks);
        one.exact = line.known(exact);
        one.engine = line.known(engine);
      });
  return list;
}

}  // namespace rockstack
