// What threads share, compiled with thread sanitizer: a race ends the program even where it does no harm.

#include <gtest/gtest.h>

#include <algorithm>
#include <barrier>
#include <numeric>
#include <stdexcept>

#include "analytic/scene/ground/motion_library.hpp"
#include "comparisons/runs/execution/executor.hpp"

namespace rockstack {
namespace {

std::vector<std::size_t> tasks(std::size_t count) {
  std::vector<std::size_t> list(count);
  std::iota(list.begin(), list.end(), std::size_t{0});
  return list;
}

constexpr std::size_t together = 4;

TEST(Threads, DeliverEveryPartOnceOneAtATime) {
  std::vector<std::size_t> delivered;  // without a lock of its own
  std::barrier all{together};          // so that all have something to deliver at once
  const auto compute = [&](std::size_t part) {
    all.arrive_and_wait();
    return std::string(part, 'x');
  };
  const auto deliver = [&](std::size_t part, const std::string& text) {
    EXPECT_EQ(text.size(), part);
    delivered.push_back(part);
  };
  make_threads(together)->run(tasks(500), {compute, deliver, [] { return false; }});
  std::sort(delivered.begin(), delivered.end());
  EXPECT_EQ(delivered, tasks(500));
}

TEST(Threads, AFailureEndsThemAllAndIsThrown) {
  std::size_t delivered = 0;
  const Work work{[](std::size_t part) -> std::string {
                    if (part == 40) throw std::runtime_error("part 40");
                    return {};
                  },
                  [&](std::size_t, const std::string&) { ++delivered; }, [] { return false; }};
  EXPECT_THROW(make_threads(together)->run(tasks(500), work), std::runtime_error);
  EXPECT_LT(delivered, 500U);
}

TEST(Threads, ShareALibraryOfMotionsThatForgetsTheOldest) {
  MotionLibrary library(1000);
  std::barrier all{together};
  const auto ask = [&](std::size_t part) {
    all.arrive_and_wait();
    SyntheticMotion motion;
    motion.duration = 1;
    motion.seed = part % 5;
    return std::to_string(library.synthetic(motion)->samples.at(20));
  };
  std::vector<std::string> answers(200);
  make_threads(together)->run(
      tasks(200),
      {ask, [&](std::size_t part, const std::string& text) { answers[part] = text; }, [] { return false; }});
  for (std::size_t part = 5; part < answers.size(); ++part) EXPECT_EQ(answers[part], answers[part - 5]);
}

}  // namespace
}  // namespace rockstack
