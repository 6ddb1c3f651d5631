#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "tests/benchmarks/pack_steps.hpp"
#include "tests/benchmarks/stepped.hpp"

namespace rockstack::benchmarks {

/// A lane of a pack, as the method of Stepped that knows its step.
template <int N>
struct InPack {
  static constexpr bool finds_roots = false;
  const PackSteps<N>* steps;
  std::size_t lane;

  Values<N> at(double offset) const { return steps->at(lane, offset); }
};

/// What came out of a scene.
struct Motion {
  std::vector<double> angles;  ///< relative, at the samples, rad
  double end = 0;              ///< s
};

/// Solves scenes side by side: PackSteps steps all lanes together and tells which have an event or the end of
/// a piece of ground; these alone do what Stepped does, by themselves, and come
/// back. A stack at rest is in no lane; a scene that is done gives way to the next.
template <int N>
class Packed {
 public:
  /// @param scenes with grounds of straight pieces
  Packed(const std::vector<Scene>& scenes, double tolerance, const std::vector<double>& samples)
      : scenes_(scenes),
        tolerance_(tolerance),
        samples_(samples),
        steps_(make_pack_steps<N>(tolerance)),
        motions_(scenes.size()) {}

  const std::vector<Motion>& run() {
    for (std::size_t lane = 0; lane < lanes; ++lane) take_next(lane);
    while (busy_ > 0) {
      const auto outcome = steps_->step();
      conclude(outcome);
      steps_->keep();
      if (!outcome.leaves.any()) continue;
      for (std::size_t lane = 0; lane < lanes; ++lane)
        if (outcome.leaves.has(lane)) go_on(lane, outcome.happens.has(lane));
    }
    return motions_;
  }

 private:
  static constexpr std::size_t lanes = PackSteps<N>::lanes;
  using Stack = Stepped<InPack, N>;

  void conclude(const typename PackSteps<N>::Outcome& outcome) {
    const LaneSet& concerned = samples_.empty() ? outcome.leaves : outcome.made;
    if (!concerned.any()) return;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      if (!concerned.has(lane)) continue;
      const auto step = steps_->step_of(lane);
      stacks_[lane]->pass(step.from);
      if (outcome.happens.has(lane)) {
        stacks_[lane]->conclude(step.to, step.after);
      } else {
        stacks_[lane]->arrive(step.to, step.after);
      }
    }
  }

  void go_on(std::size_t lane, bool happened) {
    Stack& stack = *stacks_[lane];
    bool rested = false;
    for (; stack.at_rest() && !stack.finished(); rested = true) stack.rest();
    if (stack.finished()) {
      motions_[numbers_[lane]] = {stack.rows(), stack.end()};
      take_next(lane);
      return;
    }
    steps_->follow(lane, stack.piece(), stack.offset());
    if (happened || rested) steps_->go_on(lane, stack.values(), stack.chain());
  }

  void take_next(std::size_t lane) {
    if (stacks_[lane]) --busy_;
    stacks_[lane].reset();
    steps_->stop(lane);
    if (next_ == scenes_.size()) return;
    numbers_[lane] = next_++;
    const Scene& scene = scenes_[numbers_[lane]];
    stacks_[lane].emplace(scene, ChatterEnd{tolerance_, 0}, InPack<N>{steps_.get(), lane}, samples_);
    ++busy_;
    steps_->start(lane, scene.gravity, stacks_[lane]->toppling());
    go_on(lane, true);
  }

  const std::vector<Scene>& scenes_;
  double tolerance_;
  const std::vector<double>& samples_;
  std::unique_ptr<PackSteps<N>> steps_;
  std::vector<Motion> motions_;
  std::array<std::optional<Stack>, lanes> stacks_;
  std::array<std::size_t, lanes> numbers_{};
  std::size_t next_ = 0, busy_ = 0;
};

}  // namespace rockstack::benchmarks
