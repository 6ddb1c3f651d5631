#include "analytic/branches.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "analytic/solve_led.hpp"

namespace rockstack {

namespace {

constexpr double alike = 1e-9;

/// A branch that is yet to be followed.
struct Start {
  std::vector<std::size_t> list;  ///< ways, fork by fork
  std::size_t parent = 0;
  std::optional<Fork> fork = {};
};

Branch follow(const Scene& scene, const SolveOptions& options, const Start& start) {
  Branching branching{start.list};
  Branch branch{.history = {}, .parent = start.parent, .start = start.fork};
  try {
    branch.history = solve_led(scene, options, &branching);
  } catch (const Unfinished& unfinished) {
    branch.history = unfinished.history;
    branch.unfinished = unfinished.what();
  }
  branch.forks = std::move(branching.forks);
  return branch;
}

double height(const Scene& scene) {
  double sum = 0;
  for (const Block& block : scene.blocks) sum += 2 * block.half_height;
  return sum;
}

/// Samples side by side, in shares of what is alike.
class Comparison {
 public:
  Comparison(const Scene& scene, const History& one, const History& other)
      : one_(one), other_(other), length_(height(scene) * alike) {}

  /// Whether the two end alike, apart from where.
  bool comparable() const {
    const auto end = [](const History& history) {
      return !history.events.empty() && ends_motion(history.events.back().kind);
    };
    return one_.size() == other_.size() && one_.size() > 0 && end(one_) == end(other_);
  }

  /// The first sample from which they are alike; as many as there are where the last are not.
  std::size_t alike_from(double side) const {
    std::size_t first = one_.size();
    while (first > 0 && alike_at(first - 1, side)) --first;
    return first;
  }

 private:
  /// `side`: −1 for a mirror image.
  bool alike_at(std::size_t sample, double side) const {
    const auto blocks = static_cast<std::size_t>(one_.blocks);
    const auto near = [&](const std::vector<double>& first, const std::vector<double>& second, std::size_t i,
                          double factor, double most) {
      // Infinite gaps are equal.
      return first.empty() || first[i] == factor * second[i] ||
             std::abs(first[i] - factor * second[i]) <= most;
    };
    for (std::size_t i = sample * blocks; i < (sample + 1) * blocks; ++i)
      if (!near(one_.angles, other_.angles, i, side, alike) ||
          !near(one_.slips, other_.slips, i, side, length_) || !near(one_.gaps, other_.gaps, i, 1, length_) ||
          !near(one_.centres, other_.centres, 2 * i, side, length_) ||
          !near(one_.centres, other_.centres, 2 * i + 1, 1, length_))
        return false;
    return true;
  }

  const History& one_;
  const History& other_;
  double length_;  ///< m
};

/// The likeness of a branch to an earlier one that begins first.
std::optional<Likeness> likeness(const Scene& scene, const Branch& branch,
                                 const std::vector<Branch>& earlier) {
  std::optional<Likeness> found;
  for (std::size_t i = 0; i < earlier.size(); ++i) {
    const Comparison pair(scene, branch.history, earlier[i].history);
    if (branch.unfinished != earlier[i].unfinished || !pair.comparable()) continue;
    for (const double side : {1.0, -1.0}) {
      const std::size_t first = pair.alike_from(side);
      if (first == branch.history.size()) continue;
      const double from = branch.history.times[first];
      if (!found || from < found->from) found = {i, from, side < 0};
    }
  }
  return found;
}

}  // namespace

BranchTree solve_branches(const Scene& scene, const SolveOptions& options, std::size_t most) {
  BranchTree tree;
  std::multimap<double, Start> starts{{0, {}}};
  while (!starts.empty() && tree.branches.size() < most) {
    const Start start = starts.extract(starts.begin()).mapped();
    Branch branch = follow(scene, options, start);
    branch.like = likeness(scene, branch, tree.branches);
    std::vector<std::size_t> list;
    for (const Fork& fork : branch.forks) {
      const bool known = branch.like && fork.time >= branch.like->from;
      for (std::size_t way = 1; list.size() >= start.list.size() && !known && way < fork.ways.size(); ++way) {
        Start next{list, tree.branches.size(), fork};
        next.list.push_back(way);
        next.fork->taken = way;
        starts.emplace(fork.time, std::move(next));
      }
      list.push_back(fork.taken);
    }
    tree.branches.push_back(std::move(branch));
  }
  tree.left_out = starts.size();
  if (!starts.empty()) tree.first_left_out = starts.begin()->first;
  return tree;
}

}  // namespace rockstack
