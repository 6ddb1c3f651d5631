#include "analytic/branches.hpp"

#include <map>

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
    branch.history = solve(scene, options, &branching);
  } catch (const Unfinished& unfinished) {
    branch.history = unfinished.history;
    branch.unfinished = unfinished.what();
  }
  branch.forks = std::move(branching.forks);
  return branch;
}

/// Whether two motions end alike, apart from where.
bool comparable(const History& one, const History& other) {
  const auto end = [](const History& history) {
    return !history.events.empty() && ends_motion(history.events.back().kind);
  };
  return one.size() == other.size() && one.size() > 0 && end(one) == end(other);
}

/// Whether a sample is; `side`: −1 for a mirror image, `length`: by which places may differ, m.
bool alike_at(std::size_t sample, const History& one, const History& other, double side, double length) {
  const auto blocks = static_cast<std::size_t>(one.blocks);
  const auto near = [&](auto values, std::size_t i, double factor, double most) {
    const std::vector<double>& first = one.*values;
    const std::vector<double>& second = other.*values;
    // Infinite gaps are equal.
    return first.empty() || first[i] == factor * second[i] || std::abs(first[i] - factor * second[i]) <= most;
  };
  for (std::size_t i = sample * blocks; i < (sample + 1) * blocks; ++i)
    if (!near(&History::angles, i, side, alike) || !near(&History::slips, i, side, length) ||
        !near(&History::gaps, i, 1, length) || !near(&History::centres, 2 * i, side, length) ||
        !near(&History::centres, 2 * i + 1, 1, length))
      return false;
  return true;
}

/// The likeness of a branch to an earlier one that begins first.
std::optional<Likeness> likeness(const Scene& scene, const Branch& branch,
                                 const std::vector<Branch>& earlier) {
  const double length = stack_height(scene) * alike;
  std::optional<Likeness> found;
  for (std::size_t i = 0; i < earlier.size(); ++i) {
    const History &one = branch.history, &other = earlier[i].history;
    if (branch.unfinished != earlier[i].unfinished || !comparable(one, other)) continue;
    for (const double side : {1.0, -1.0}) {
      std::size_t first = one.size();
      while (first > 0 && alike_at(first - 1, one, other, side, length)) --first;
      if (first == one.size()) continue;
      const double from = one.times[first];
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
