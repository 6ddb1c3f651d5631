#include "comparisons/measures/results/recorded_history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "analytic/scene/history.hpp"
#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/measures/results/csv.hpp"

namespace rockstack {
namespace {

namespace fs = std::filesystem;
using Cells = std::vector<std::string>;
using Indices = std::vector<std::size_t>;

/// One line of a file whose columns are found by their names.
class Line {
 public:
  explicit Line(fs::path file) : file_(std::move(file)) {}

  /// Calls `row` for each line under the header, which `header` has looked at.
  void read(const std::function<void()>& header, const std::function<void()>& row) {
    read_rows(
        file_,
        [&](const Cells& names) {
          header_.columns = names;
          header();
        },
        [&](const Cells& cells, std::size_t number) {
          cells_ = &cells;
          number_ = number;
          row();
        });
  }

  bool has(const std::string& name) const {
    return std::find(header_.columns.begin(), header_.columns.end(), name) != header_.columns.end();
  }
  std::size_t index(const std::string& name) const { return column(header_, name, file_); }
  Indices indices(const std::vector<std::string>& names) const {
    Indices list;
    for (const std::string& name : names) list.push_back(index(name));
    return list;
  }

  const std::string& text(std::size_t index) const { return (*cells_)[index]; }
  double value(std::size_t index) const {
    if (const std::optional<double> value = number_in(text(index))) return *value;
    return number(text(index), place(), header_.columns[index]);
  }
  std::optional<double> known(std::size_t index) const {
    return text(index).empty() ? std::nullopt : std::optional(value(index));
  }
  int whole(std::size_t index, int least, int most) const {
    return whole_number(text(index), place(), header_.columns[index], least, most);
  }
  /// Adds the numbers of some columns to a list.
  void add(const Indices& columns, std::vector<double>& list) const {
    for (const std::size_t one : columns) list.push_back(value(one));
  }
  /// What a text names. @throws InputError where it names nothing.
  template <class Read>
  auto named(std::size_t index, const Read& read) const {
    try {
      return read(text(index));
    } catch (const std::invalid_argument& error) {
      throw InputError(fmt::format("{}: {} = {}", place(), header_.columns[index], error.what()));
    }
  }

 private:
  std::string place() const { return fmt::format("{}:{}", file_.string(), number_); }

  fs::path file_;
  Table header_;
  const Cells* cells_ = nullptr;
  std::size_t number_ = 1;
};

/// The centres of mass, x and y in turn.
std::vector<std::string> place_names(int blocks) {
  std::vector<std::string> names;
  for (int k = 1; k <= blocks; ++k)
    names.insert(names.end(), {fmt::format("x_{}", k), fmt::format("y_{}", k)});
  return names;
}

int blocks_in(const Line& line) {
  int blocks = 0;
  while (blocks < max_blocks && line.has(fmt::format("theta_{}", blocks + 1))) ++blocks;
  return blocks;
}

History samples_in(const fs::path& file) {
  History history;
  Line line(file);
  std::size_t time = 0;
  std::optional<std::size_t> pattern;
  Indices angles, velocities, slips, gaps, places;
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
  Line line(file);
  std::size_t time = 0, kind = 0, interface = 0, from = 0, to = 0, consistency = 0;
  Indices angles, before, after;
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
  Line line(file);
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
