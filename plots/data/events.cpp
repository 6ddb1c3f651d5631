#include "plots/data/events.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/measures/results/csv.hpp"

namespace rockstack::plots {
namespace {

/// Cells of a file by column name, with file:line for errors.
struct Cells {
  std::filesystem::path file;
  Table table = read_table(file);

  const std::string& text(std::size_t row, const std::string& name) const {
    return table.rows[row][column(table, name, file)];
  }
  std::string place(std::size_t row) const { return fmt::format("{}:{}", file.string(), row + 2); }
  double value(std::size_t row, const std::string& name) const {
    return number(text(row, name), place(row), name);
  }
};

void change_pattern(std::vector<PatternSpan>& spans, double time, const std::string& pattern) {
  if (!spans.empty() && spans.back().pattern == pattern) return;
  if (!spans.empty()) spans.back().to = time;
  spans.push_back({time, time, pattern});
}

/// Impacts with their exact times, as far as the file has them, for placing those that are extra.
double place_between(const std::vector<double>& exact_times, double time) {
  const auto before =
      std::count_if(exact_times.begin(), exact_times.end(), [&](double t) { return t <= time; });
  return static_cast<double>(before) + 0.5;
}

}  // namespace

ExactEvents read_events(const Run& exact, int blocks, double end, const std::string& start) {
  const Cells cells{.file = exact.folder / "events.csv"};
  ExactEvents events;
  events.impact_times.resize(static_cast<std::size_t>(blocks));
  if (!start.empty()) change_pattern(events.spans, 0, start);
  for (std::size_t i = 0; i < cells.table.rows.size(); ++i) {
    const double time = cells.value(i, "time");
    if (events.spans.empty()) change_pattern(events.spans, 0, cells.text(i, "from"));
    change_pattern(events.spans, time, cells.text(i, "to"));
    if (cells.text(i, "kind") != "impact") continue;
    const int interface = whole_number(cells.text(i, "interface"), cells.place(i), "interface", 1, blocks);
    events.impact_times[static_cast<std::size_t>(interface) - 1].push_back(time);
    ++events.impacts;
  }
  if (!events.spans.empty()) events.spans.back().to = std::max(end, events.spans.back().from);
  return events;
}

std::string starting_pattern(const Run& run) {
  const Table table = read_table(run.folder / "history.csv");
  const auto found = std::find(table.columns.begin(), table.columns.end(), "pattern");
  if (found == table.columns.end() || table.rows.empty()) return "";
  return table.rows.front()[static_cast<std::size_t>(found - table.columns.begin())];
}

std::vector<PatternChange> read_changes(const Run& exact, int blocks) {
  const Cells cells{.file = exact.folder / "events.csv"};
  std::vector<PatternChange> changes;
  for (std::size_t i = 0; i < cells.table.rows.size(); ++i) {
    const int interface = whole_number(cells.text(i, "interface"), cells.place(i), "interface", 1, blocks);
    const auto speed = [&](int block) {
      return block == 0 ? 0 : cells.value(i, fmt::format("omega_before_{}", block));
    };
    changes.push_back({cells.value(i, "time"), cells.text(i, "kind"), interface, cells.text(i, "from"),
                       cells.text(i, "to"), std::abs(speed(interface) - speed(interface - 1))});
  }
  return changes;
}

std::vector<PatternChange> read_impact_changes(const Run& exact, int blocks) {
  std::vector<PatternChange> changes = read_changes(exact, blocks);
  std::erase_if(changes, [](const PatternChange& change) { return change.kind != "impact"; });
  return changes;
}

const std::array<NamedSides, 9>& two_block_patterns() {
  static constexpr std::array<NamedSides, 9> patterns{{{"1a", {1, 1}},
                                                       {"1b", {-1, -1}},
                                                       {"2a", {1, -1}},
                                                       {"2b", {-1, 1}},
                                                       {"3a", {1, 0}},
                                                       {"3b", {-1, 0}},
                                                       {"4a", {0, 1}},
                                                       {"4b", {0, -1}},
                                                       {"rest", {0, 0}}}};
  return patterns;
}

Impacts read_impacts(const Run& run) {
  const Cells cells{.file = run.folder / "impacts.csv"};
  std::vector<double> exact_times;
  for (std::size_t i = 0; i < cells.table.rows.size(); ++i)
    if (const double time = cells.value(i, "exact_time"); !std::isnan(time)) exact_times.push_back(time);
  Impacts impacts;
  for (std::size_t i = 0; i < cells.table.rows.size(); ++i) {
    const std::string& verdict = cells.text(i, "verdict");
    if (verdict == "matched") {
      impacts.matched.push_back({cells.value(i, "number"), cells.value(i, "difference")});
    } else if (verdict == "missed") {
      impacts.missed.push_back(cells.value(i, "number"));
    } else if (verdict == "extra") {
      impacts.extra.push_back(place_between(exact_times, cells.value(i, "engine_time")));
    } else {
      throw InputError(
          fmt::format("{}: verdict = \"{}\": must be matched, missed or extra", cells.place(i), verdict));
    }
  }
  return impacts;
}

}  // namespace rockstack::plots
