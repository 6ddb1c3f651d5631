#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>

#include "analytic/scene/input/scene_file.hpp"
#include "analytic/solve.hpp"

namespace rockstack {
namespace {

/// A row of a proved table: an event, and intervals in which its time and absolute angles are, s and rad.
struct ProvedRow {
  std::string kind, from, to;
  int interface = 0;
  std::vector<long double> lower, upper;  ///< of the time, then of angles
};

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream input(line);
  for (std::string cell; std::getline(input, cell, ',');) cells.push_back(cell);
  return cells;
}

std::vector<ProvedRow> proved_rows(const std::filesystem::path& file) {
  std::ifstream input(file);
  std::string line;
  std::getline(input, line);
  std::vector<ProvedRow> rows;
  while (std::getline(input, line)) {
    const std::vector<std::string> cells = split(line);
    ProvedRow row{cells[0], cells[2], cells[3], std::stoi(cells[1]), {}, {}};
    for (std::size_t i = 4; i + 1 < cells.size(); i += 2) {
      row.lower.push_back(std::strtold(cells[i].c_str(), nullptr));
      row.upper.push_back(std::strtold(cells[i + 1].c_str(), nullptr));
    }
    rows.push_back(row);
  }
  return rows;
}

std::string letters(const Pattern& pattern) {
  std::string result;
  for (int k = 0; k < pattern.size; ++k) result += "LCR"[sign(pattern[k]) + 1];
  return result;
}

/// Without the last microsecond of chatter, which proved tables leave out.
std::vector<Event> without_last_chatter(const std::vector<Event>& events) {
  constexpr double last = 1e-6;  // s
  std::vector<Event> kept;
  for (const Event& event : events) {
    if (event.kind == EventKind::closure || event.kind == EventKind::rest)
      while (!kept.empty() && kept.back().kind == EventKind::impact &&
             kept.back().interface == event.interface && event.time - kept.back().time <= last)
        kept.pop_back();
    kept.push_back(event);
  }
  return kept;
}

/// How far a number is from an interval.
double distance(double number, long double lower, long double upper) {
  const long double value = number;
  return static_cast<double>(std::max({lower - value, value - upper, 0.0L}));
}

double in_units(double difference, double number) {
  const double size = std::abs(number);
  return difference / (std::nextafter(size, std::numeric_limits<double>::infinity()) - size);
}

/// How far the solver is from a table at most: of times in units in their last place, of angles in rad.
struct Held {
  const char* scene;
  double time_units, angle;
};
void PrintTo(const Held& held, std::ostream* out) {
  *out << held.scene;
}

class SolverAgainstProof : public ::testing::TestWithParam<Held> {};

// What rounding makes of times grows with what events make of each other: bounds are twice what was found.
TEST_P(SolverAgainstProof, EventsAreThoseThatAreProved) {
  const auto& [name, time_units, angle] = GetParam();
  const std::filesystem::path folder = ROCKSTACK_COMPARISONS;
  const std::vector<ProvedRow> rows = proved_rows(folder / "canon/proved" / (std::string(name) + ".csv"));
  ASSERT_FALSE(rows.empty());
  Scene scene = read_scene(folder / "scenes" / (std::string(name) + ".toml"));
  scene.duration = std::max(scene.duration, static_cast<double>(rows.back().upper[0]) + 1);
  const std::vector<Event> events = without_last_chatter(solve(scene).events);
  ASSERT_GE(events.size(), rows.size());
  double worst_angle = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ProvedRow& row = rows[i];
    const Event& event = events[i];
    ASSERT_EQ(rockstack::name(event.kind), row.kind) << i << " at " << event.time;
    ASSERT_EQ(event.interface, row.interface) << i << " at " << event.time;
    ASSERT_EQ(letters(event.to), row.to) << i << " at " << event.time;
    const double units = in_units(distance(event.time, row.lower[0], row.upper[0]), event.time);
    EXPECT_LE(units, time_units) << row.kind << ' ' << i << " at " << event.time;
    // A closure stands for impacts that no double tells apart: it comes from either side, with the angles of
    // one of them.
    if (event.kind == EventKind::closure || event.kind == EventKind::rest) continue;
    ASSERT_EQ(letters(event.from), row.from) << i << " at " << event.time;
    for (std::size_t k = 0; k < event.angles.size(); ++k)
      worst_angle = std::max(worst_angle, distance(event.angles[k], row.lower[k + 1], row.upper[k + 1]));
  }
  EXPECT_LE(worst_angle, angle);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SolverAgainstProof,
                         ::testing::Values(Held{"shaken-block", 3, 0}, Held{"pulse-block", 66, 0},
                                           Held{"squat-top", 6, 0}, Held{"housner-block", 33, 0},
                                           Held{"three-drums", 9, 0}, Held{"drum-column", 6, 0},
                                           Held{"spanos-el-centro", 41, 1e-16},
                                           Held{"spanos-free-rocking", 63, 1e-15}),
                         [](const auto& held) {
                           std::string name = held.param.scene;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace rockstack
