#include "comparisons/measures/metrics/branches.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/measures/metrics/motion_verdict.hpp"

namespace rockstack {
namespace {

/// How a branch ends, and when, s.
std::pair<std::string, double> ending_of(const Scene& scene, const Branch& branch) {
  const History& history = branch.history;
  if (!branch.unfinished.empty())
    return {"given up", history.events.empty() ? 0.0 : history.events.back().time};
  if (!reported_toppling(history).empty())
    return {name(history.events.back().kind), history.events.back().time};
  if (ends_at_rest(scene, history)) return {"rest", history.events.back().time};
  return {"end of scene", scene.duration};
}

std::string verdict_of(const Scene& scene, const Branch& branch) {
  return branch.unfinished.empty() ? motion_verdict(scene, branch.history) : "given up: " + branch.unfinished;
}

}  // namespace

Json branches_json(const Scene& scene, const BranchTree& tree) {
  Json list = Json::array();
  for (const Branch& branch : tree.branches) {
    const auto& start = branch.start;
    const auto& like = branch.like;
    const auto [ending, end_time] = ending_of(scene, branch);
    list.push_back({{"branch", list.size() + 1},
                    {"parent", start ? Json(branch.parent + 1) : Json()},
                    {"time", start ? Json(start->time) : Json()},
                    {"takes", start ? Json(name(start->ways[start->taken])) : Json()},
                    {"instead_of", start ? Json(name(start->ways.front())) : Json()},
                    {"like", like ? Json(like->branch + 1) : Json()},
                    {"like_from", like ? Json(like->from) : Json()},
                    {"mirrored", like ? Json(like->mirrored) : Json()},
                    {"ends", ending},
                    {"end_time", end_time},
                    {"verdict", verdict_of(scene, branch)}});
  }
  return list;
}

std::vector<std::string> branch_lines(const Scene& scene, const BranchTree& tree, std::size_t most) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < tree.branches.size(); ++i) {
    const Branch& branch = tree.branches[i];
    const std::string start =
        branch.start ? fmt::format("leaves branch {} at {:.6g} s, with {} instead of {}: ", branch.parent + 1,
                                   branch.start->time, name(branch.start->ways[branch.start->taken]),
                                   name(branch.start->ways.front()))
                     : "";
    const std::string likeness =
        branch.like ? fmt::format("; from {:.4g} s on {} branch {}", branch.like->from,
                                  branch.like->mirrored ? "the mirror image of" : "the same as",
                                  branch.like->branch + 1)
                    : "";
    lines.push_back(fmt::format("branch {}: {}{}{}", i + 1, start, verdict_of(scene, branch), likeness));
  }
  if (tree.branches.size() == 1 && tree.left_out == 0) lines.push_back("no event leaves another motion");
  if (tree.left_out > 0)
    lines.push_back(fmt::format("--most-branches {} leaves out {} more that {}, the first at {:.6g} s", most,
                                tree.left_out, tree.left_out == 1 ? "starts" : "start", tree.first_left_out));
  return lines;
}

}  // namespace rockstack
