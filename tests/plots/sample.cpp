#include "tests/plots/sample.hpp"

#include <fmt/core.h>
#include <fmt/ostream.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>

#include "comparisons/measures/results/run_metrics.hpp"
#include "comparisons/measures/results/tables.hpp"
#include "comparisons/measures/verdict/verdict.hpp"

namespace rockstack::testing {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr double duration = 5, period = 0.5;

std::ofstream create(const fs::path& file) {
  fs::create_directories(file.parent_path());
  return std::ofstream(file);
}

double swing(double t, int block) {
  return 0.15 / block * std::exp(-0.5 * t) * std::sin(std::numbers::pi * t / period);
}

double swing_rate(double t, int block) {
  const double turn = std::numbers::pi / period;
  return 0.15 / block * std::exp(-0.5 * t) * (turn * std::cos(turn * t) - 0.5 * std::sin(turn * t));
}

void write_header(std::ostream& out, const std::string& stem, int blocks) {
  for (int k = 1; k <= blocks; ++k) fmt::print(out, ",{}{}", stem, k);
}

/// Columns of slips, gaps and places: every block slips by 0.1 m/s on the one below, the lowest flies from
/// 1 s to 1.5 s.
void write_slide(std::ostream& out, const Sample& sample, double t) {
  for (int k = 1; k <= sample.blocks; ++k) fmt::print(out, ",{}", 0.1 * t);
  const double lift = t > 1 && t < 1.5 ? 0.3 : 0;
  for (int k = 1; k <= sample.blocks; ++k) fmt::print(out, ",{}", k == 1 ? lift : 0);
  for (int k = 1; k <= sample.blocks; ++k) fmt::print(out, ",{},{}", 0.1 * k * t, 2 * k - 1 + lift);
}

/// The name of a pattern in which the lowest block pivots about one side and all others about their right.
std::string leaning(const Sample& sample, Contact lowest) {
  Pattern pattern = closed_pattern(sample.blocks);
  for (int k = 0; k < sample.blocks; ++k) pattern[k] = k == 0 ? lowest : Contact::right;
  return name(pattern);
}

/// A motion that lags by `lag` s for every second that passes.
void write_history(const fs::path& folder, const Sample& sample, double dt, double lag, bool exact) {
  std::ofstream history = create(folder / "history.csv");
  history << "time";
  write_header(history, "theta_", sample.blocks);
  write_header(history, "omega_", sample.blocks);
  if (exact) history << ",pattern";
  if (sample.slides) {
    for (const char* stem : {"slip_", "gap_"}) write_header(history, stem, sample.blocks);
    for (int k = 1; k <= sample.blocks; ++k) fmt::print(history, ",x_{0},y_{0}", k);
  }
  history << "\n";
  for (int i = 0; i <= std::lround(duration / dt); ++i) {
    const double t = i * dt, moved = std::min(t, sample.rests_from) * (1 - lag);
    fmt::print(history, "{}", t);
    for (int k = 1; k <= sample.blocks; ++k) fmt::print(history, ",{}", swing(moved, k));
    for (int k = 1; k <= sample.blocks; ++k) fmt::print(history, ",{}", swing_rate(moved, k));
    if (exact)
      history << "," + (sample.slides ? "R>C" : leaning(sample, t < period ? Contact::right : Contact::left));
    if (sample.slides) write_slide(history, sample, t);
    history << "\n";
  }
}

/// One event of each kind that sliding and flight have, of two blocks; on springs corners part and touch.
void write_sliding_events(std::ostream& events, bool springs) {
  for (const char* words : {"0.5,slip,2,R>C,R>C<", springs ? "1,part,1,R>C<,-C<" : "1,lift-off,1,R>C<,-C<",
                            springs ? "1.5,touch,1,-C<,LC<" : "1.5,impact,1,-C<,LC<", "2,stick,2,LC<,LC",
                            "2.5,corner,2,LC,LR", "3,fall,2,LR,L-"})
    events << words << ",0,0,-1,1,0,0,consistent\n";
}

void write_events(const fs::path& folder, const Sample& sample) {
  std::ofstream events = create(folder / "events.csv");
  events << "time,kind,interface,from,to";
  for (const char* stem : {"theta_", "omega_before_", "omega_after_"})
    write_header(events, stem, sample.blocks);
  events << ",consistency\n";
  if (sample.slides) return write_sliding_events(events, sample.law == Law::compliant);
  for (int i = 1; i <= sample.impacts; ++i) {
    const std::string right = leaning(sample, Contact::right), left = leaning(sample, Contact::left);
    fmt::print(events, "{},impact,{},{},{}", i * period, 1 + i % sample.blocks, i % 2 == 1 ? right : left,
               i % 2 == 1 ? left : right);
    for (int k = 0; k < sample.blocks; ++k) events << ",0";
    for (int k = 0; k < sample.blocks; ++k) events << (k % 2 == 0 ? ",-1" : ",1");
    for (int k = 0; k < sample.blocks; ++k) events << ",0";
    events << ",consistent\n";
  }
}

void write_impacts(const fs::path& folder, const Sample& sample, double lag) {
  std::ofstream impacts = create(folder / "impacts.csv");
  impacts << "number,interface,exact_time,engine_time,difference,verdict\n";
  for (int i = 1; i <= sample.impacts; ++i) {
    const double time = i * period;
    if (i % 7 == 0) {
      fmt::print(impacts, "{},1,{},,,missed\n,2,,{},,extra\n", i, time, time + 0.1);
    } else {
      const double late = time * lag * (i % 5 == 0 ? -1 : 1);
      fmt::print(impacts, "{},1,{},{},{},matched\n", i, time, time + late, late);
    }
  }
}

void write_difference(const fs::path& folder, const Sample& sample, double dt, double lag) {
  std::ofstream difference = create(folder / "difference.csv");
  difference << "time";
  write_header(difference, "difference_", sample.blocks);
  difference << "\n";
  for (int i = 0; i <= std::lround(duration / dt); ++i) {
    const double t = i * dt;
    fmt::print(difference, "{}", t);
    for (int k = 1; k <= sample.blocks; ++k)
      fmt::print(difference, ",{}", swing(t * (1 - lag), k) - swing(t, k));
    difference << "\n";
  }
}

/// A staircase, and another that is a little late.
void write_energy(const fs::path& folder, double dt, double lag) {
  std::ofstream energy = create(folder / "energy.csv");
  energy << "time,exact,engine,input,elastic,balance,penetration\n";
  for (int i = 0; i <= std::lround(duration / dt); ++i) {
    const double t = i * dt;
    const auto level = [](double time) { return 1000 * std::exp(-std::floor(time / period)); };
    fmt::print(energy, "{0},{1},{2},0,0,{2},0\n", t, level(t), level(t * (1 - lag)));
  }
}

void write_patterns(const fs::path& folder) {
  create(folder / "patterns.csv") << "exact,engine,share\n1a,1a,0.5\n1a,2b,0.05\n2b,2b,0.4\n2b,rest,0.05\n";
}

/// Half of the weight on each interface.
void write_reactions(const fs::path& folder, const Sample& sample) {
  std::ofstream reactions = create(folder / "reactions.csv");
  reactions << "time";
  for (const char* stem : {"normal_", "tangential_", "centre_"}) write_header(reactions, stem, sample.blocks);
  for (const double t : {0.0, duration / 2, duration}) {
    fmt::print(reactions, "\n{}", t);
    for (int k = 0; k < sample.blocks; ++k) reactions << ",4905";
    for (int k = 0; k < sample.blocks; ++k) reactions << ",100";
    for (int k = 0; k < sample.blocks; ++k) reactions << (k == 0 ? "," : ",0.1");
  }
  reactions << "\n";
}

bool tells_forces(const Sample& sample) {
  return std::ranges::find(sample.results, "forces") != sample.results.end();
}

/// An engine's, of which a step before an impact bears nothing and the next one ten weights; and impulses
/// that are larger by a share.
void write_forces(const fs::path& folder, const Sample& sample, double share) {
  std::ofstream reactions = create(folder / "reactions.csv"), impulses = create(folder / "impulses.csv");
  reactions << "time";
  for (const char* stem : {"normal_", "tangential_", "centre_"}) write_header(reactions, stem, sample.blocks);
  reactions << "\n0" << std::string(3 * static_cast<std::size_t>(sample.blocks), ',');
  for (int i = 1; i <= 500; ++i) {
    const double force = i % 100 == 50 ? 0 : i % 100 == 51 ? 98100 : 4905 * (1 + share);
    fmt::print(reactions, "\n{}", 0.01 * i);
    for (int k = 0; k < sample.blocks; ++k) fmt::print(reactions, ",{}", force);
    for (int k = 0; k < sample.blocks; ++k) fmt::print(reactions, ",{}", 0.02 * force);
    for (int k = 0; k < sample.blocks; ++k) reactions << (force > 0 ? ",0.1" : ",");
  }
  reactions << "\n";
  impulses << "number,interface,exact_time,engine_time,exact_normal,engine_normal\n";
  for (int i = 1; i <= sample.impacts; ++i)
    fmt::print(impulses, "{},1,{},{},{},{}\n", i, i * period, i * period, 1e3 / i, 1e3 / i * (1 + share));
}

/// Readings, one of them missing, and what a run has there.
void write_readings(const fs::path& folder, const Sample& sample, double lag) {
  if (!sample.tested) return;
  std::ofstream readings = create(folder / "readings.csv");
  readings << "time,measured_1,motion_1\n0,,0\n";
  for (int i = 1; i <= std::lround(duration / sample.readings); ++i) {
    const double t = sample.readings * i;
    fmt::print(readings, "{},{},{}\n", t, 0.1 * swing(t, 1) + 0.002, 0.1 * swing(t - lag, 1));
  }
}

Law law_of(const Sample& sample) {
  return sample.slides ? sample.law : Law::consistent;
}

Json page_of(const Sample& sample) {
  Json page{{"title", sample.title},
            {"duration", duration},
            {"law", name(law_of(sample))},
            {"contact", {{"friction", 0.5}}}};
  if (law_of(sample) == Law::compliant) page["contact"]["stiffness"] = 1e8;
  for (int k = 0; k < sample.blocks; ++k)
    page["blocks"].push_back({{"width", 1}, {"height", 2}, {"mass", 1000}, {"inertia", 416.67}});
  return page;
}

void write_json(const fs::path& folder, const Sample& sample, const std::vector<RunMetrics>& rows) {
  Json scene{{"name", "sample"}};
  scene["ground"] = sample.shaken ? "samples" : "";
  scene["predictable_time"] = sample.predictable_time;
  scene["toml"] = "duration = 5 # s & <b>not bold</b>\n";
  scene["page"] = page_of(sample).dump();
  scene["results"] = sample.results;
  if (sample.tested) scene["measured"] = {{"columns", {"base of a_b"}}, {"unit", "m"}};
  Json json{{"title", "A sample <comparison>"}, {"scenes", Json::array({scene})}};
  json["distributions"] = Json::parse(sample.distributions);
  json["fits"] = Json::parse(sample.fits);
  json["statements"] = Json::array();
  json["verdict"] = verdict_json({{"What <it> comes to."}, {{"What it <shows>."}}, {}}, {{"sample", {}}});
  json["definitions"] = {{"run", "name of the run"}, {"rms_angle_difference", "root mean square, rad"}};
  json["tolerance_rad"] = 0.01;
  json["left_out"] = {"ode"};
  json["environment"] = {{"rockstack", "0.1.0"}, {"eigen", "3.4.0"}};
  json["command"] = "rockstack compare sample.toml --out DIR";
  for (const RunMetrics& row : rows) json["rows"].push_back(row);
  create(folder / "comparison.json") << json.dump(1);
  create(folder / "comparison.csv") << csv_of(rows);
}

void write_ground(const fs::path& folder) {
  std::ofstream ground = create(folder / "ground" / "sample.csv");
  ground << "time,horizontal,vertical\n";
  for (int i = 0; i <= 500; ++i) {
    const double t = 0.01 * i;
    fmt::print(ground, "{},{},{}\n", t, 7 * swing(t, 1), -3 * swing(t, 2));
  }
}

/// A few words of everything a run's folder holds besides its histories.
void write_summary(const fs::path& folder, const std::string& run, double dt, bool slides) {
  create(folder / "summary.json") << fmt::format(
      R"({{"run": "{}", "dt": {}, "parameters": {{"iterations": 50, "erp<1>": 0.2}}{}}})", run, dt,
      slides
          ? R"(, "contact": [{"interface": 1, "final_slip": -0.25, "largest_slip": 0.5, "highest_lift": 0.3,
                  "slips": 7, "lift_offs": 1}], "validity_warnings": ["several motions <obey>"])"
          : "");
}

/// What twenty perturbed scenes came to, one of which failed.
void write_perturbed(const fs::path& folder, const Sample& sample, double lag) {
  if (sample.distributions == "[]") return;
  std::ofstream out = create(folder / "perturbed.csv");
  out << "run";
  write_header(out, "peak_", sample.blocks);
  out << ",impacts,toppled\n0" << std::string(static_cast<std::size_t>(sample.blocks) + 2, ',') << "\n";
  for (int i = 1; i < 20; ++i) {
    fmt::print(out, "{}", i);
    for (int k = 1; k <= sample.blocks; ++k) fmt::print(out, ",{}", 0.1 / k + lag * i);
    fmt::print(out, ",{},0\n", 20 + i % 4);
  }
}

RunMetrics row_of(const Sample& sample, const std::string& run, const SampleEngine& engine) {
  RunMetrics row;
  row.run = run;
  row.scene = "sample";
  row.law = name(law_of(sample));
  row.engine = engine.engine;
  row.solver = engine.solver;
  row.settings = engine.settings;
  return row;
}

RunMetrics write_engine(const fs::path& folder, const Sample& sample, const SampleEngine& engine, double dt) {
  const std::string run =
      fmt::format("sample.{}.{}.{}.{:g}", engine.engine, engine.solver, engine.settings, dt);
  const double lag = engine.lateness * dt * 1e3;
  const fs::path place = folder / "runs" / run;
  write_history(place, sample, dt, lag, false);
  write_impacts(place, sample, lag);
  write_difference(place, sample, dt, lag);
  write_energy(place, dt, lag);
  write_patterns(place);
  write_summary(place, run, dt, false);
  write_perturbed(place, sample, lag);
  write_readings(place, sample, lag);
  RunMetrics row = row_of(sample, run, engine);
  if (sample.tested) row.rms_test_difference = 0.002 + lag;
  if (tells_forces(sample)) {
    write_forces(place, sample, lag);
    row.normal_force_error = row.impulse_error = lag;
  }
  row.dt = dt;
  row.steps = static_cast<int>(duration / dt);
  row.stepping_time_minimum = 2e-5 / dt;
  row.largest_angle_difference = 3 * lag;
  row.error = row.rms_angle_difference = lag;
  row.motion = 0.15;
  row.exact_peak_over_slenderness = 0.5;
  row.peak_over_slenderness = 0.5 + lag;
  row.rank = 1;
  if (sample.impacts > 0) row.first_impact_time_difference = period * lag;
  if (sample.draws > 1) row.draws = sample.draws;
  row.impacts_matched = sample.impacts;
  row.impacts_missed = row.impacts_extra = 1;
  row.agreement_time = std::min(duration, 0.02 / lag);
  return row;
}

}  // namespace

void write_sample(const fs::path& folder, const Sample& sample) {
  if (sample.shaken) write_ground(folder);
  const fs::path exact = folder / "runs" / "sample.exact";
  write_history(exact, sample, 1e-3, 0, true);
  write_events(exact, sample);
  write_reactions(exact, sample);
  write_summary(exact, "sample.exact", 1e-3, sample.slides);
  write_perturbed(exact, sample, 1e-4);
  write_readings(exact, sample, 0);
  std::vector<RunMetrics> rows{row_of(sample, "sample.exact", {"exact", "rk4", "", 0})};
  rows.front().stepping_time_minimum = 0.004;
  if (sample.tested) rows.front().rms_test_difference = 0.002;
  for (const SampleEngine& engine : sample.engines)
    for (const double dt : sample.steps) rows.push_back(write_engine(folder, sample, engine, dt));
  if (sample.failed_row) {
    rows.push_back(row_of(sample, "sample.bad", {"ode", "step", "default", 0}));
    rows.back().dt = 0.1;
    rows.back().status = RunStatus::failed;
    rows.back().reason = "angle not finite, at t = 0.3 s <nan>";
  }
  write_json(folder, sample, rows);
}

fs::path fresh_folder() {
  const ::testing::UnitTest& tests = *::testing::UnitTest::GetInstance();
  const ::testing::TestInfo* test = tests.current_test_info();
  fs::path folder = fs::path(::testing::TempDir()) / fmt::format("rockstack-plots.{}.{}",
                                                                 tests.current_test_suite()->name(),
                                                                 test != nullptr ? test->name() : "all");
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace rockstack::testing
