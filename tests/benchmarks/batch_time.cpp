// Sweeps of two blocks and of one over 20 s of synthetic motions, by batches of the solver and by
// Boost.odeint on packs, each beside one by one, in one run: batch_time FOLDER writes batches.csv and
// batch-errors.csv into it.
//
// Error of a run: RMS, over blocks and samples 10 ms apart, of the difference of angles to the solver's at
// tolerance 0, rad, as long as no block has toppled. A motion may amplify what it is given without bound: the
// median over the runs tells, and the 90th percentile, and how many topple where the reference does not or do
// not where it does. Time: processor time of a run without samples on one core, the least of seven by turns.
// Chatter ends at flights below the tolerance.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <span>

#include "analytic/solve.hpp"
#include "analytic/solve_batch.hpp"
#include "comparisons/measures/statistics/samples.hpp"
#include "tests/benchmarks/ensemble_scenes.hpp"
#include "tests/benchmarks/measurement.hpp"
#include "tests/benchmarks/methods.hpp"
#include "tests/benchmarks/packed.hpp"
#include "tests/benchmarks/processor_time.hpp"
#include "tests/benchmarks/tables.hpp"

namespace rockstack::benchmarks {
namespace {

using Scenes = std::vector<Scene>;
using Samples = std::vector<double>;

struct Contender {
  std::string method;
  double tolerance;
  std::function<std::vector<Motion>(const Scenes&, const Samples&)> solve;
};

Contender ours(const std::string& method, InstructionSet set, double tolerance) {
  return {method, tolerance, [=](const Scenes& scenes, const Samples& samples) {
            SolveOptions options;
            options.tolerance = options.resolution = tolerance;
            options.events = EventsKept::summed;  // no other method keeps them
            options.sample_times = samples;
            std::vector<Motion> motions(scenes.size());
            std::size_t given = 0;
            solve_batch([&] { return given < scenes.size() ? std::optional(scenes[given++]) : std::nullopt; },
                        options,
                        [&](Solved&& solved) {
                          if (solved.failure) std::rethrow_exception(solved.failure);
                          const auto& events = solved.history.events;
                          const bool ended = !events.empty() && ends_motion(events.back().kind);
                          motions[solved.number] = {std::move(solved.history.angles),
                                                    ended ? events.back().time : solved.scene.duration};
                        },
                        set);
            return motions;
          }};
}

template <int N>
void make_absolute(std::vector<Motion>& motions) {
  for (Motion& motion : motions)
    for (std::size_t i = 0; i < motion.angles.size(); ++i)
      if (i % N != 0) motion.angles[i] += motion.angles[i - 1];
}

template <int N>
std::vector<Motion> one_by_one(const Scenes& scenes, double tolerance, const Samples& samples) {
  std::vector<Motion> motions;
  for (const Scene& scene : scenes) {
    Stepped<Dopri5, N> stack(scene, {tolerance, 0}, tolerance, samples);
    stack.run();
    motions.push_back({stack.rows(), stack.end()});
  }
  make_absolute<N>(motions);
  return motions;
}

template <int N>
std::vector<Motion> side_by_side(const Scenes& scenes, double tolerance, const Samples& samples) {
  std::vector<Motion> motions = Packed<N>(scenes, tolerance, samples).run();
  make_absolute<N>(motions);
  return motions;
}

std::vector<Contender> contenders() {
  constexpr std::array tolerances{1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4};
  std::vector<Contender> all;
  const auto add = [&](const auto& make) {
    for (const double tolerance : tolerances) all.push_back(make(tolerance));
  };
  const auto by = [](const std::string& method, auto one, auto two) {
    return [=](double tolerance) -> Contender {
      return {method, tolerance, [=](const Scenes& scenes, const Samples& samples) {
                return scenes.front().blocks.size() == 1 ? one(scenes, tolerance, samples)
                                                         : two(scenes, tolerance, samples);
              }};
    };
  };
  add([](double tolerance) { return ours("rockstack in packs", InstructionSet::avx2, tolerance); });
  add([](double tolerance) { return ours("rockstack one by one", InstructionSet::scalar, tolerance); });
  add(by("odeint dopri5 in packs", side_by_side<1>, side_by_side<2>));
  add(by("odeint dopri5 one by one", one_by_one<1>, one_by_one<2>));
  return all;
}

/// RMS difference of angles up to the end of either motion, rad.
double difference(const Motion& motion, const Motion& reference, const Samples& samples, std::size_t blocks) {
  const double end = std::min(motion.end, reference.end);
  const auto rows =
      static_cast<std::size_t>(std::upper_bound(samples.begin(), samples.end(), end) - samples.begin());
  double sum = 0;
  const std::size_t count = std::min({rows * blocks, motion.angles.size(), reference.angles.size()});
  for (std::size_t i = 0; i < count; ++i) {
    const double apart = motion.angles[i] - reference.angles[i];
    sum += apart * apart;
  }
  return std::sqrt(sum / static_cast<double>(count));
}

struct BatchMeasurement {
  Measurement median;
  double high;            ///< 90th percentile of errors, rad
  std::size_t different;  ///< runs that topple where the reference does not, or the other way
};

BatchMeasurement errors(const std::string& title, const Contender& contender, const Scenes& scenes,
                        const std::vector<Motion>& reference, const Samples& samples) {
  const std::vector<Motion> motions = contender.solve(scenes, samples);
  std::vector<double> differences;
  std::size_t different = 0;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    differences.push_back(difference(motions[i], reference[i], samples, scenes[i].blocks.size()));
    const double duration = scenes[i].duration;
    different += (motions[i].end < duration) != (reference[i].end < duration) ? 1 : 0;
  }
  return {{title, contender.method, contender.tolerance, median(differences),
           std::numeric_limits<double>::infinity()},
          quantile(differences, 0.9),
          different};
}

std::vector<BatchMeasurement> measure(const std::string& title, const Scenes& scenes) {
  const Samples samples = regular_times(0.01, scenes.front().duration);
  const auto reference = ours("reference", InstructionSet::scalar, 0).solve(scenes, samples);
  std::vector<BatchMeasurement> result;
  const std::vector<Contender> all = contenders();
  result.reserve(all.size());
  for (const Contender& contender : all)
    result.push_back(errors(title, contender, scenes, reference, samples));
  for (int turn = 0; turn < 7; ++turn) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double seconds = processor_seconds([&] { all[i].solve(scenes, {}); });
      result[i].median.seconds =
          std::min(result[i].median.seconds, seconds / static_cast<double>(scenes.size()));
    }
  }
  const auto toppled = std::count_if(reference.begin(), reference.end(), [&](const Motion& motion) {
    return motion.end < scenes.front().duration;
  });
  std::cout << title << ": " << scenes.size() << " runs, of which " << toppled << " topple" << std::endl;
  return result;
}

/// As CSV, a row a sweep, tolerance and method.
void write_table(const std::vector<BatchMeasurement>& all, std::ostream& out) {
  out << "sweep,tolerance,method,runs a second,median error (rad),90th percentile (rad),topple otherwise\n";
  constexpr std::array tolerances{1e-12, 1e-9, 1e-6};
  // Measured are sweeps one after the other: the rows of one are together.
  for (auto sweep = all.begin(); sweep != all.end();) {
    const auto end = std::find_if(
        sweep, all.end(), [&](const BatchMeasurement& m) { return m.median.scene != sweep->median.scene; });
    for (const double tolerance : tolerances) {
      for (const auto& [median, high, different] : std::span(sweep, end)) {
        if (median.setting != tolerance) continue;
        std::array<char, 96> numbers{};
        std::snprintf(numbers.data(), numbers.size(), "%.0f,%.1e,%.1e,%zu", 1 / median.seconds, median.error,
                      high, different);
        out << median.scene << ',' << tolerance << ',' << median.method << ',' << numbers.data() << '\n';
      }
    }
    sweep = end;
  }
}

}  // namespace
}  // namespace rockstack::benchmarks

int main(int arguments, char** values) {
  using namespace rockstack;
  const auto& sets = instruction_sets();
  if (std::find(sets.begin(), sets.end(), InstructionSet::avx2) == sets.end()) {
    std::cerr << "batch_time: this machine has no AVX2\n";
    return 2;
  }
  const std::filesystem::path folder = arguments > 1 ? values[1] : ".";
  std::filesystem::create_directories(folder);
  std::vector<benchmarks::BatchMeasurement> all;
  for (const auto& [title, ensemble] :
       {std::pair("two blocks", "ida-two-blocks"), std::pair("one block", "fragility-block")}) {
    const auto measured = benchmarks::measure(title, benchmarks::ensemble_scenes(ensemble));
    all.insert(all.end(), measured.begin(), measured.end());
  }
  std::ofstream table(folder / "batches.csv");
  benchmarks::write_table(all, table);
  std::vector<benchmarks::Measurement> medians;
  medians.reserve(all.size());
  for (const auto& m : all) medians.push_back(m.median);
  std::ofstream equal(folder / "batch-errors.csv");
  constexpr std::array errors{1e-4, 1e-6, 1e-8, 1e-10, 1e-12};  // rad
  benchmarks::write_equal_errors(medians, errors, equal);
}
