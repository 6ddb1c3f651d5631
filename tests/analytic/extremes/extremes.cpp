// Solves seeded scenes from all over the range of what can be asked: extremes [COUNT [FIRST]]. Each scene
// goes through the laws that no motion may leave; each in a process that may end without taking this one
// along. Prints a line for each scene that broke a law, did not end or could not go on, and a summary; fails
// where a law was broken or a scene did not end.

#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "analytic/solve.hpp"
#include "tests/analytic/extremes/laws.hpp"
#include "tests/analytic/extremes/scenes.hpp"
#include "tests/analytic/reference/random_scenes.hpp"

namespace {

using namespace rockstack;
using namespace rockstack::testing;

constexpr long patience = 30;  // for one scene, s of processor time
constexpr double few = 1000;   // roundings

/// What the processes share.
struct Shared {
  std::uint64_t seed = 0;
  std::size_t events = 0, broken = 0, diagnosed = 0, unfinished = 0;
  double impact_gain = 0, flight_drift = 0;
  std::size_t compared = 0, parted = 0, at_resolution = 0, by_input = 0, by_arithmetic = 0;
  double amplified = 0;
};

void note(Shared& shared, const Scene& scene) {
  const Breaches found =
      breaches(scene, solve(scene, {.sample_times = regular_times(scene.duration / 50, scene.duration)}));
  shared.events += found.events;
  shared.impact_gain = std::max(shared.impact_gain, found.impact_gain);
  shared.flight_drift = std::max(shared.flight_drift, found.flight_drift);
  if (found.words.empty() && found.impact_gain <= few && found.flight_drift <= few) return;
  ++shared.broken;
  std::printf("%llu broken: %s gain %g, drift %g, %zu events; %s\n",
              static_cast<unsigned long long>(shared.seed), found.words.c_str(), found.impact_gain,
              found.flight_drift, found.events, features(scene).c_str());
}

constexpr std::size_t most_compared = 150;  // events, at 113 bits

/// Compares one scene with the reference. Where events differ, or differ by more than a few times what
/// roundings of the scene's own numbers make, a law is broken.
void compare_one(Shared& shared, const Scene& scene) {
  if (solve(scene).events.size() > most_compared) return;
  Tally tally;
  const std::string words = tally.add(shared.seed, scene);
  ++shared.compared;
  shared.parted += tally.parted;
  shared.at_resolution += tally.at_resolution;
  shared.by_input += tally.sensitive_input;
  shared.by_arithmetic += tally.sensitive_arithmetic;
  shared.events += tally.events;
  shared.amplified = std::max(shared.amplified, tally.amplified);
  if (!words.empty()) std::printf("%s; %s\n", words.c_str(), features(scene).c_str());
  shared.broken += tally.unexplained;
}

/// Solves from the shared seed on, up to `end`.
void solve_until(std::uint64_t end, bool reference, Shared& shared) {
  for (; shared.seed < end; ++shared.seed) {
    const itimerval limit{{0, 0}, {patience, 0}};
    setitimer(ITIMER_PROF, &limit, nullptr);
    const Scene scene = extreme_scene(shared.seed);
    try {
      reference ? compare_one(shared, scene) : note(shared, scene);
    } catch (const std::exception& failure) {
      ++shared.diagnosed;
      std::printf("%llu diagnosed: %s; %s\n", static_cast<unsigned long long>(shared.seed), failure.what(),
                  features(scene).c_str());
    }
    std::fflush(stdout);
  }
}

}  // namespace

int main(int arguments, char** values) {
  const std::uint64_t count = arguments > 1 ? std::strtoull(values[1], nullptr, 10) : 100000;
  const std::uint64_t first = arguments > 2 ? std::strtoull(values[2], nullptr, 10) : 0;
  const bool reference = arguments > 3;
  void* memory = mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return 1;
  Shared& shared = *new (memory) Shared{.seed = first};
  while (shared.seed < first + count) {
    const pid_t child = fork();
    if (child == 0) {
      solve_until(first + count, reference, shared);
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (status == 0) break;
    ++shared.unfinished;
    std::printf("%llu did not end: signal %d; %s\n", static_cast<unsigned long long>(shared.seed),
                WTERMSIG(status), features(extreme_scene(shared.seed)).c_str());
    std::fflush(stdout);
    ++shared.seed;
  }
  std::printf(
      "%llu scenes, %zu events; %zu broke a law, %zu did not end, %zu have a diagnosis; largest gain of an "
      "impact %g, largest drift of a flight %g\n",
      static_cast<unsigned long long>(count), shared.events, shared.broken, shared.unfinished,
      shared.diagnosed, shared.impact_gain, shared.flight_drift);
  if (reference)
    std::printf(
        "%zu compared with 113 bits, %zu part from them: %zu at the resolution of chatter, %zu as they do by "
        "roundings of the input, %zu by roundings of operations; off by at most %g times what 16 roundings "
        "of "
        "the input make\n",
        shared.compared, shared.parted, shared.at_resolution, shared.by_input, shared.by_arithmetic,
        shared.amplified);
  return shared.broken + shared.unfinished == 0 ? 0 : 1;
}
