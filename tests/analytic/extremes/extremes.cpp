// Solves seeded scenes from all over the range of what can be asked: extremes [COUNT [FIRST [reference |
// unilateral]]], the last under the law of that name, with friction.
// Each scene goes through the laws that no motion may leave; each in a process that may end without taking
// this one along. A scene that takes longer than half a minute is long where its motion gets on all the same:
// of that, the first part goes through the laws. Prints a line for each scene that broke a law, is long, got
// stuck or could not go on, and a summary; fails where a law was broken or a scene got stuck.

#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "analytic/solve.hpp"
#include "analytic/solver/solver.hpp"
#include "tests/analytic/extremes/laws.hpp"
#include "tests/analytic/extremes/scenes.hpp"
#include "tests/analytic/reference/random_scenes.hpp"

namespace {

using namespace rockstack;
using namespace rockstack::testing;

constexpr long patience = 30;   // for one scene, s of processor time
constexpr double few = 1000;    // roundings
constexpr double several = 16;  // operations in a row

/// What the processes share.
struct Shared {
  std::uint64_t seed = 0;
  std::size_t events = 0, broken = 0, diagnosed = 0, lengthy = 0, stuck = 0;
  double impact_gain = 0, flight_drift = 0;
  std::size_t compared = 0, parted = 0, at_resolution = 0, by_input = 0, by_arithmetic = 0;
  double amplified = 0, weighed = 0;
  double halfway = 0, reached = 0;  ///< of a long scene, in half of the patience and in all of it, s
  std::size_t steps = 0;            ///< in that time
  bool moves = false;               ///< in the second half too
  bool unilateral = false;          ///< law of all scenes

  Scene scene() const { return unilateral ? slippery_extreme_scene(seed) : extreme_scene(seed); }
};

void note(Shared& shared, const Scene& scene) {
  const std::vector<double> times = regular_times(scene.duration / 50, scene.duration);
  const Breaches found = scene.law == Law::unilateral
                             ? contact_breaches(scene, solve_unilateral(scene, {.sample_times = times}))
                             : breaches(scene, solve(scene, {.sample_times = times}));
  shared.events += found.events;
  shared.impact_gain = std::max(shared.impact_gain, found.impact_gain);
  shared.flight_drift = std::max(shared.flight_drift, found.flight_drift);
  if (found.fault.empty() && found.impact_gain <= few && found.flight_drift <= few) return;
  ++shared.broken;
  std::printf("%llu broken: %s gain %g, drift %g, %zu events; %s\n",
              static_cast<unsigned long long>(shared.seed), found.fault.c_str(), found.impact_gain,
              found.flight_drift, found.events, features(scene).c_str());
}

constexpr std::size_t most_compared = 150;  // events, at 113 bits

/// Compares one scene with the reference. Where events differ that roundings do not part, a law is broken.
/// Where they are off by more than what operations weigh, a line says so.
void compare_one(Shared& shared, const Scene& scene) {
  const History history = solve(scene);
  if (history.events.size() > most_compared) return;
  Tally tally;
  const std::string words = tally.add(shared.seed, scene);
  ++shared.compared;
  shared.parted += tally.parted;
  shared.at_resolution += tally.at_resolution;
  shared.by_input += tally.sensitive_input;
  shared.by_arithmetic += tally.sensitive_arithmetic;
  shared.events += tally.events;
  shared.amplified = std::max(shared.amplified, tally.amplified);
  const double weighed = tally.amplified / weight_of_rounding(scene, history);
  shared.weighed = std::max(shared.weighed, weighed);
  if (!words.empty()) std::printf("%s; %s\n", words.c_str(), features(scene).c_str());
  if (weighed > several)
    std::printf("%llu off by %g times what roundings make; %s\n",
                static_cast<unsigned long long>(shared.seed), weighed, features(scene).c_str());
  shared.broken += tally.unexplained;
}

/// Ends this process after `seconds` of processor time.
void limit_time(long seconds) {
  const itimerval limit{{0, 0}, {seconds, 0}};
  setitimer(ITIMER_PROF, &limit, nullptr);
}

template <class Work>
void attempt(Shared& shared, const Scene& scene, const Work& work) {
  try {
    work();
  } catch (const std::exception& failure) {
    ++shared.diagnosed;
    std::printf("%llu diagnosed: %s; %s\n", static_cast<unsigned long long>(shared.seed), failure.what(),
                features(scene).c_str());
  }
  std::fflush(stdout);
}

/// Solves from the shared seed on, up to `end`.
void solve_until(std::uint64_t end, bool reference, Shared& shared) {
  for (; shared.seed < end; ++shared.seed) {
    limit_time(patience);
    const Scene scene = shared.scene();
    attempt(shared, scene, [&] { reference ? compare_one(shared, scene) : note(shared, scene); });
  }
}

/// How far the solver gets while patience lasts.
template <class Real>
void walk(Shared& shared, const Scene& scene) {
  const std::clock_t start = std::clock();
  const SolveOptions options;
  Solver<Real> solver(scene, options);
  solver.start();
  for (shared.steps = 0; !solver.finished(); ++shared.steps) {
    solver.advance();
    shared.reached = static_cast<double>(solver.time());
    const std::clock_t spent = std::clock() - start;
    if (spent < patience * CLOCKS_PER_SEC / 2) shared.halfway = shared.reached;
    if (spent > patience * CLOCKS_PER_SEC) break;
  }
  shared.moves = solver.finished() || shared.reached > shared.halfway;
}

void walk_in_either_precision(Shared& shared, const Scene& scene) {
  try {
    walk<double>(shared, scene);
  } catch (const IllConditioned&) {
    walk<long double>(shared, scene);
  }
}

/// Does something in a process of its own; false where that is ended.
template <class Work>
bool apart(const Work& work) {
  if (fork() == 0) {
    work();
    std::fflush(stdout);
    _exit(0);
  }
  int status = 0;
  wait(&status);
  return status == 0;
}

/// Goes through the laws with ever shorter parts of a motion with friction that took too long. Only where a
/// thousandth of it takes too long as well does it not get on.
void look_at_parts(Shared& shared) {
  Scene scene = shared.scene();
  shared.moves = false;
  for (int tenths = 0; tenths < 3 && !shared.moves; ++tenths) {
    scene.duration /= 10;
    apart([&] {
      limit_time(patience);
      attempt(shared, scene, [&] { note(shared, scene); });
      shared.moves = true;
    });
  }
  ++(shared.moves ? shared.lengthy : shared.stuck);
  std::printf("%llu %s: %g s; %s\n", static_cast<unsigned long long>(shared.seed),
              shared.moves ? "long" : "stuck", scene.duration, features(scene).c_str());
  std::fflush(stdout);
}

/// Tells whether the motion of a scene that took too long gets on.
void look_closer(Shared& shared) {
  if (shared.unilateral) return look_at_parts(shared);
  Scene scene = extreme_scene(shared.seed);
  const std::size_t diagnosed = shared.diagnosed;
  shared.moves = false;
  apart([&] {
    limit_time(3 * patience);
    attempt(shared, scene, [&] { walk_in_either_precision(shared, scene); });
  });
  if (shared.diagnosed > diagnosed) return;
  ++(shared.moves ? shared.lengthy : shared.stuck);
  std::printf("%llu %s: %g s in %ld s of processor time, %g s in half of that, %zu steps; %s\n",
              static_cast<unsigned long long>(shared.seed), shared.moves ? "long" : "stuck", shared.reached,
              patience, shared.halfway, shared.steps, features(scene).c_str());
  std::fflush(stdout);
  if (!shared.moves) return;
  scene.duration = shared.halfway;
  apart([&] {
    limit_time(2 * patience);
    attempt(shared, scene, [&] { note(shared, scene); });
  });
}

}  // namespace

int main(int arguments, char** values) {
  const std::uint64_t count = arguments > 1 ? std::strtoull(values[1], nullptr, 10) : 100000;
  const std::uint64_t first = arguments > 2 ? std::strtoull(values[2], nullptr, 10) : 0;
  const bool unilateral = arguments > 3 && std::string(values[3]) == "unilateral";
  const bool reference = arguments > 3 && !unilateral;
  void* memory = mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return 1;
  Shared& shared = *new (memory) Shared{.seed = first, .unilateral = unilateral};
  while (shared.seed < first + count) {
    if (apart([&] { solve_until(first + count, reference, shared); })) break;
    if (reference) {
      ++shared.lengthy;
      std::printf("%llu long at 113 bits\n", static_cast<unsigned long long>(shared.seed));
      std::fflush(stdout);
    } else {
      look_closer(shared);
    }
    ++shared.seed;
  }
  std::printf(
      "%llu scenes, %zu events; %zu broke a law, %zu got stuck, %zu are long, %zu have a diagnosis; largest "
      "gain of an impact %g, largest drift of a flight %g\n",
      static_cast<unsigned long long>(count), shared.events, shared.broken, shared.stuck, shared.lengthy,
      shared.diagnosed, shared.impact_gain, shared.flight_drift);
  if (reference)
    std::printf(
        "%zu compared with 113 bits, %zu part from them: %zu at the resolution of chatter, %zu as they do by "
        "roundings of the input, %zu by roundings of operations; off by at most %g times what 16 roundings "
        "of the input make, and by %g times that with the weight of operations\n",
        shared.compared, shared.parted, shared.at_resolution, shared.by_input, shared.by_arithmetic,
        shared.amplified, shared.weighed);
  return shared.broken + shared.stuck == 0 ? 0 : 1;
}
