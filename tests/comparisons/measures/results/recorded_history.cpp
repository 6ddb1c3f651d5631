#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "analytic/scene/history.hpp"
#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/measures/results/tables.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

/// A history of everything that files hold, of numbers drawn at random.
History made_up(int blocks, bool leaves_pivots) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> value(-1, 1);
  const auto rows = [&](int count) {
    std::vector<double> list(static_cast<std::size_t>(count));
    for (double& each : list) each = value(generator);
    return list;
  };
  constexpr int samples = 7;
  History history;
  history.blocks = blocks;
  for (int i = 0; i < samples; ++i) history.times.push_back(i / 3.0);
  history.angles = rows(samples * blocks), history.velocities = rows(samples * blocks);
  history.patterns.assign(samples, closed_pattern(blocks));
  history.patterns.back()[blocks - 1] = Contact::left;
  if (leaves_pivots) {
    history.slips = rows(samples * blocks), history.gaps = rows(samples * blocks);
    history.gaps.back() = std::numeric_limits<double>::infinity();
    history.centres = rows(2 * samples * blocks);
    history.patterns[1].contacts[0] = Contact::apart;
  }
  for (const EventKind kind : {EventKind::impact, EventKind::slip, EventKind::rest})
    history.events.push_back({0.1 / 3, kind, blocks, history.patterns.front(), history.patterns.back(),
                              rows(blocks), rows(blocks), rows(blocks), Consistency::other});
  return history;
}

void expect_same(const History& read, const History& history) {
  EXPECT_EQ(read.blocks, history.blocks);
  EXPECT_EQ(read.times, history.times);
  EXPECT_EQ(read.angles, history.angles);
  EXPECT_EQ(read.velocities, history.velocities);
  EXPECT_EQ(read.patterns, history.patterns);
  EXPECT_EQ(read.slips, history.slips);
  EXPECT_EQ(read.gaps, history.gaps);
  EXPECT_EQ(read.centres, history.centres);
  ASSERT_EQ(read.events.size(), history.events.size());
  for (std::size_t i = 0; i < read.events.size(); ++i) {
    const Event &one = read.events[i], &other = history.events[i];
    EXPECT_EQ(one.time, other.time);
    EXPECT_EQ(one.kind, other.kind);
    EXPECT_EQ(one.interface, other.interface);
    EXPECT_EQ(one.from, other.from);
    EXPECT_EQ(one.to, other.to);
    EXPECT_EQ(one.angles, other.angles);
    EXPECT_EQ(one.before, other.before);
    EXPECT_EQ(one.after, other.after);
    EXPECT_EQ(one.consistency, other.consistency);
  }
}

TEST(RecordedHistory, IsTheOneThatWasWritten) {
  for (const int blocks : {1, 2, 5})
    for (const bool leaves_pivots : {false, true}) {
      const TemporaryFolder folder;
      const History history = made_up(blocks, leaves_pivots);
      folder.write("history.csv", history_csv(history));
      folder.write("events.csv", events_csv(history));
      expect_same(read_history(folder.path()), history);
    }
}

TEST(RecordedHistory, OfAnEngineHasNoPatternsAndNoEvents) {
  const TemporaryFolder folder;
  History history = made_up(2, false);
  history.patterns.clear(), history.events.clear();
  folder.write("history.csv", history_csv(history));
  expect_same(read_history(folder.path()), history);
}

TEST(RecordedHistory, WhatIsWrongIsNamedByFileAndLine) {
  const TemporaryFolder folder;
  const auto complaint = [&](const std::string& name, const std::string& text) {
    folder.write("history.csv", history_csv(made_up(2, false)));
    folder.write("events.csv", events_csv(made_up(2, false)));
    folder.write(name, text);
    try {
      read_history(folder.path());
    } catch (const InputError& error) {
      return std::string(error.what()).substr(folder.path().string().size());
    }
    return std::string();
  };
  const std::string header = "time,theta_1,theta_2,omega_1,omega_2,pattern\n";
  EXPECT_EQ(complaint("history.csv", "time\n"), "/history.csv:1: no column theta_1");
  EXPECT_EQ(complaint("history.csv", header + "0,0,0,x,0,1a\n"),
            "/history.csv:2: omega_1 = \"x\": must be a number");
  EXPECT_EQ(complaint("history.csv", header + "0,0,0,0,0,1a\n0,0,0,0,0,5a\n"),
            "/history.csv:3: pattern = \"5a\": must be a pattern of 2 blocks");
  EXPECT_NE(complaint("events.csv", "time,kind\n").find("/events.csv:1: no column"), std::string::npos);
}

TEST(RecordedImpacts, AreThoseThatWereWritten) {
  const TemporaryFolder folder;
  const std::vector<AlignedImpact> impacts{{1, 1, 0.1, 1.0 / 3}, {2, 2, 0.2, {}}, {2, {}, {}, 0.7}};
  const auto read = read_impacts(folder.write("impacts.csv", impacts_csv(impacts)));
  ASSERT_EQ(read.size(), impacts.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].interface, impacts[i].interface);
    EXPECT_EQ(read[i].number, impacts[i].number);
    EXPECT_EQ(read[i].exact, impacts[i].exact);
    EXPECT_EQ(read[i].engine, impacts[i].engine);
  }
}

}  // namespace
}  // namespace rockstack
