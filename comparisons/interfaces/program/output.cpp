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

#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/measures/results/build.hpp"
#ifdef ROCKSTACK_WITH_PLOTS
#include "plots/pages/show.hpp"
#endif

namespace rockstack {
namespace {

using Json = nlohmann::ordered_json;

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
    const std::string remaining =
        now.remaining && now.done < now.total ? ", about " + waiting_time(*now.remaining) + " to go" : "";
    const std::string run = now.running.empty() ? now.last : "running " + now.running;
    fmt::print(stderr, "\r\033[K[{}/{}{}] {}{}", now.done, now.total, remaining, run,
               now.done == now.total ? "\n" : "");
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
    fmt::print("results: {}\n", folder.string());
  }
}

void print_history(const Scene& scene, const History& history, const Support& support,
                   const std::filesystem::path& folder, const Common& common) {
  std::map<std::string, int> events;
  for (const Event& event : history.events) ++events[name(event.kind)];
  const std::string verdict = motion_verdict(scene, history, support);
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

int end_of_runs(std::size_t failed, std::size_t runs, const char* file) {
  if (failed > 0) fmt::print(stderr, "rockstack: {} of {} runs failed, {} says why\n", failed, runs, file);
  return failed > 0 ? 1 : 0;
}

void print_report(const std::filesystem::path& folder, const Common& common) {
  if (common.quiet || common.json) return;
#ifdef ROCKSTACK_WITH_PLOTS
  fmt::print("report: {}\n", (folder / "report.html").string());
#else
  fmt::print("left out of this build: figures and the report in {}\n", folder.string());
#endif
}

void show_report(const std::filesystem::path& folder, const Common& common) {
#ifdef ROCKSTACK_WITH_PLOTS
  plots::show(folder);
#endif
  print_report(folder, common);
}

std::string version_text() {
  return fmt::format("rockstack {}", build::version);
}

}  // namespace rockstack
