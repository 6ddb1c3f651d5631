#include "comparisons/interfaces/program/output.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "comparisons/measures/metrics/contact/validity.hpp"
#include "comparisons/measures/metrics/motion_verdict.hpp"
#include "comparisons/measures/results/build.hpp"

namespace rockstack {
namespace {

using Json = nlohmann::ordered_json;

template <class Value>
std::string cell(const std::optional<Value>& value, fmt::format_string<const Value&> format) {
  return value ? fmt::format(format, *value) : "";
}

/// Letters that the columns engine:solver and settings need.
struct Widths {
  std::size_t engine = 13, settings = 8;
};

Widths widths_of(const std::vector<RunMetrics>& rows) {
  Widths widths;
  for (const RunMetrics& row : rows) {
    widths.engine = std::max(widths.engine, row.engine.size() + 1 + row.solver.size());
    widths.settings = std::max(widths.settings, row.settings.size());
  }
  return widths;
}

void print_row(const RunMetrics& row, const Widths& widths) {
  if (row.status != RunStatus::done) {
    fmt::print("{:<{}} {:<{}} {:>7} {}: {}\n", row.engine + ":" + row.solver, widths.engine, row.settings,
               widths.settings, cell(row.dt, "{}"), name(row.status), row.reason);
    return;
  }
  const std::string impacts = row.impacts_matched ? fmt::format("{}/{}/{}", *row.impacts_matched,
                                                                *row.impacts_missed, *row.impacts_extra)
                                                  : "";
  const std::string chance = row.impacts_matched_null
                                 ? fmt::format("{}, {}", *row.impacts_matched_null,
                                               std::max(row.impacts_matched_random.value_or(0),
                                                        row.impacts_matched_shifted.value_or(0)))
                                 : "";
  const std::string quartiles =
      row.rms_angle_difference_lower
          ? fmt::format("{:.1e}…{:.1e}", *row.rms_angle_difference_lower, *row.rms_angle_difference_upper)
          : "";
  fmt::print("{:<{}} {:<{}} {:>7} {:>11} {:>9} {:>8} {:>9} {:>16} {:>9} {:>9} {:>10}\n",
             row.engine + ":" + row.solver, widths.engine, row.settings, widths.settings, cell(row.dt, "{}"),
             cell(row.first_impact_time_difference, "{:+.1e}"), impacts, chance,
             cell(row.rms_angle_difference, "{:.2e}"), quartiles,
             cell(row.largest_angle_difference, "{:.2e}"), cell(row.agreement_time, "{:.4g}"),
             cell(row.stepping_time_minimum, "{:.2e}"));
}

bool shows_progress(const Common& common) {
  return !common.quiet && isatty(STDERR_FILENO) != 0;
}

/// A time to be waited for, in the largest unit that fits.
std::string waiting_time(double seconds) {
  if (seconds < 60) return fmt::format("{:.0f} s", seconds);
  if (seconds < 3600) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

std::string shell_word(const std::string& word) {
  const auto plain = [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 || (letter & 0x80) != 0 ||
           std::string_view("-_./=:+,@%").find(letter) != std::string_view::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), plain)) return word;
  std::string quoted = "'";
  for (const char letter : word) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
}

std::function<void(const Progress&)> progress(const Common& common) {
  if (!shows_progress(common)) return [](const Progress&) {};
  return [](const Progress& now) {
    const bool end = now.done == now.total;
    const std::string remaining = end || !now.remaining ? "" : ", " + waiting_time(*now.remaining) + " to go";
    fmt::print(stderr, "\r\033[K[{}/{}{}] {}{}", now.done, now.total, remaining, now.last, end ? "\n" : "");
    std::fflush(stderr);
  };
}

void clear_progress(const Common& common) {
  if (shows_progress(common)) fmt::print(stderr, "\r\033[K");
}

std::function<void(std::size_t, std::size_t, std::size_t)> sweep_progress(const Common& common) {
  if (!shows_progress(common)) return [](std::size_t, std::size_t, std::size_t) {};
  using Clock = std::chrono::steady_clock;
  return [start = Clock::now(), last = Clock::time_point{}](std::size_t done, std::size_t begun_with,
                                                            std::size_t runs) mutable {
    const auto now = Clock::now();
    const bool end = done == runs;
    if (!end && now - last < std::chrono::milliseconds(100)) return;
    last = now;
    const double seconds = std::chrono::duration<double>(now - start).count();
    const double rest = seconds * static_cast<double>(runs - done) / static_cast<double>(done - begun_with);
    const std::string remaining =
        end || done == begun_with ? "" : fmt::format(", {} to go", waiting_time(rest));
    fmt::print(stderr, "\r\033[K{} of {} runs{}{}", done, runs, remaining, end ? "\n" : "");
    std::fflush(stderr);
  };
}

void print_stopped(const SweepResult& result, const Common& common) {
  fmt::print(stderr, "{}rockstack: stopped after {} of {} runs; the same command goes on from there\n",
             shows_progress(common) ? "\n" : "", result.done, result.runs);
}

void print_sweep(const SweepResult& result, const std::filesystem::path& folder, const Common& common) {
  if (common.json) {
    fmt::print("{}\n", Json{{"runs", result.runs},
                            {"done", result.done},
                            {"computed", result.computed},
                            {"failed", result.failed},
                            {"seconds", result.seconds},
                            {"folder", folder.string()}}
                           .dump(2));
  } else if (!common.quiet) {
    fmt::print("runs: {}, {} of them now in {:.3g} s\n", result.runs, result.computed, result.seconds);
    if (result.failed > 0) fmt::print("failed: {}, runs.csv says why\n", result.failed);
    fmt::print("results: {}\n", folder.string());
  }
}

void print_history(const Scene& scene, const History& history, const std::filesystem::path& folder,
                   const Common& common) {
  std::map<std::string, int> events;
  for (const Event& event : history.events) ++events[name(event.kind)];
  const std::string verdict = motion_verdict(scene, history);
  const std::vector<double> peaks = peak_angles(history);
  const std::vector<std::string> warnings = validity_warnings(scene, history);
  if (common.json) {
    fmt::print("{}\n", Json{{"verdict", verdict},
                            {"events", events},
                            {"peak_angles", peaks},
                            {"warnings", warnings},
                            {"folder", folder.string()}}
                           .dump(2));
  } else if (!common.quiet) {
    fmt::print("{}\n", verdict);
    for (const auto& [kind, number] : events) fmt::print("{}: {}\n", kind, number);
    for (std::size_t k = 0; const double peak : peaks)
      fmt::print("peak angle of block {}: {:.6g} rad\n", ++k, peak);
    for (const std::string& warning : warnings) fmt::print("warning: {}\n", warning);
    fmt::print("results: {}\n", folder.string());
  }
}

void print_rows(const CompareResult& result, const std::filesystem::path& folder, const Common& common) {
  const std::vector<RunMetrics>& rows = result.rows;
  if (common.json) {
    Json list = Json::array();
    for (const RunMetrics& row : rows) list.push_back(metrics_json(row));
    fmt::print("{}\n", list.dump(2));
    return;
  }
  if (common.quiet) return;
  const Widths widths = widths_of(rows);
  std::string scene;
  for (const RunMetrics& row : rows) {
    if (row.scene != scene) {
      fmt::print("{}{}, law {}\n{:<{}} {:<{}} {:>7} {:>11} {:>9} {:>8} {:>9} {:>16} {:>9} {:>9} {:>10}\n",
                 scene.empty() ? "" : "\n", row.scene, row.law, "engine:solver", widths.engine, "settings",
                 widths.settings, "dt (s)", "first (s)", "impacts", "limits", "rms (rad)", "quartiles",
                 "max (rad)", "agree (s)", "time (s)");
    }
    scene = row.scene;
    print_row(row, widths);
  }
  fmt::print(
      "\nfirst: first impact, engine less exact; impacts: matched/missed/extra; limits: how many match of "
      "the "
      "exact\nmotion itself, sampled at these steps, and at random times; agree: time until which angles "
      "stay "
      "within "
      "the tolerance;\ntime: least wall time of stepping alone\n");
  const auto draws = std::max_element(rows.begin(), rows.end(), [](const RunMetrics& a, const RunMetrics& b) {
    return a.draws.value_or(1) < b.draws.value_or(1);
  });
  if (draws != rows.end() && draws->draws)
    fmt::print(
        "numbers are medians of {} replicates: steps within a few percent, scenes that differ in the sixth "
        "digit\n",
        *draws->draws);
  if (std::any_of(rows.begin(), rows.end(),
                  [](const RunMetrics& row) { return row.runs_at_a_time.value_or(1) > 1; }))
    fmt::print("times are those of runs that shared the machine\n");
  if (result.reused > 0) fmt::print("{} of {} runs were there already\n", result.reused, rows.size());
  for (const std::string& name : engines_left_out()) fmt::print("left out of this build: {}\n", name);
  fmt::print("results: {}\n", folder.string());
}

void print_impact_laws(const ImpactLawResults& results, const std::filesystem::path& folder,
                       const Common& common) {
  const std::vector<KindShare> kinds = shares_by_kind(results.laws.shares);
  if (common.json) {
    Json list = Json::array();
    for (const KindShare& kind : kinds) {
      list.push_back(
          {{"kind", kind.kind}, {"impacts", kind.impacts}, {"differ", kind.differ}, {"none", kind.none}});
    }
    fmt::print("{}\n", Json{{"kinds", list}, {"folder", folder.string()}}.dump(2));
    return;
  }
  if (common.quiet) return;
  fmt::print("{:<18} {:>8} {:>9} {:>9}\n", "impact", "number", "differ", "none");
  for (const KindShare& kind : kinds) {
    fmt::print("{:<18} {:>8} {:>8.2f}% {:>8.2f}%\n", kind.kind, kind.impacts,
               100.0 * kind.differ / kind.impacts, 100.0 * kind.none / kind.impacts);
  }
  fmt::print("\n{:<26} {:>7} {:>11} {:>7} {:>8} {:>7}\n", "engine:solver", "dt (s)", "consistent", "paper",
             "neither", "failed");
  for (const EngineTally& tally : tallies(results.cases)) {
    fmt::print("{:<26} {:>7} {:>11} {:>7} {:>8} {:>7}\n", tally.engine, tally.dt, tally.consistent,
               tally.paper, tally.neither, tally.failed);
  }
  fmt::print(
      "\ndiffer: the laws choose different patterns; none: no pattern is consistent; below: whose "
      "pattern the\nengines show where the laws differ\n");
  for (const std::string& name : engines_left_out()) fmt::print("left out of this build: {}\n", name);
  fmt::print("results: {}\n", folder.string());
}

void print_report(const std::filesystem::path& folder, const Common& common) {
  if (common.quiet || common.json) return;
#ifdef ROCKSTACK_WITH_PLOTS
  fmt::print("report: {}\n", (folder / "report.html").string());
#else
  fmt::print("left out of this build: figures and the report in {}\n", folder.string());
#endif
}

std::string version_text() {
  return fmt::format("rockstack {}", build::version);
}

}  // namespace rockstack
