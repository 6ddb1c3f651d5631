#pragma once

#include "analytic/branches.hpp"
#include "analytic/scene/input/json.hpp"

namespace rockstack {

/// A row a branch, from 1 on: branch, parent, time (s), takes and instead_of, where it leaves its parent, the
/// patterns that both go on with; like, like_from (s) and mirrored, the earlier branch that it becomes like;
/// ends, "rest", "topple", "fall", "strike", "end of scene" or "given up", end_time (s) and verdict. Null
/// where there is none.
Json branches_json(const Scene& scene, const BranchTree& tree);

/// A line a branch, and one for what a bound of `most` has left out.
std::vector<std::string> branch_lines(const Scene& scene, const BranchTree& tree, std::size_t most);

}  // namespace rockstack
