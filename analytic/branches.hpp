#pragma once

#include "analytic/solve.hpp"

namespace rockstack {

/// Where a branch becomes like an earlier one, and stays so to the end.
struct Likeness {
  std::size_t branch = 0;  ///< the other
  double from = 0;         ///< s, to a sample
  bool mirrored = false;   ///< as its mirror image
};

/// One of the motions that obey the laws of contact.
struct Branch {
  History history;
  std::string unfinished = {};     ///< why it could not be followed to its end; else empty
  std::vector<Fork> forks = {};    ///< all on its way
  std::size_t parent = 0;          ///< the branch that it leaves; of the first, itself
  std::optional<Fork> start = {};  ///< where it does; of the first, nowhere
  std::optional<Likeness> like = {};
};

/// The motions that obey, and what a bound leaves out.
struct BranchTree {
  std::vector<Branch> branches;  ///< the first is the motion of solve(); others by the time that they start
  std::size_t left_out = 0;      ///< ways that were not followed, as `most` branches were there
  double first_left_out = 0;     ///< when the first of these starts, s
};

/// All motions that leave each other where contact has several solutions, at events and at the start, up to
/// `most` of them, in the order in which they start. Times between events at which a motion might leave as
/// well, as where a force could jam at any time, are not looked at; nor is chatter, more than eight events
/// within a thousandth of √(H/g), of laws that leave pivots. A branch that becomes like an earlier one is
/// followed to its end, but leaves no more branches from there on: that one does.
///
/// Like are motions whose angles differ by 10⁻⁹ rad, and places and slips by 10⁻⁹ of the stack's height, at
/// most, at all samples from some time on; so sample times are needed.
/// @throws as solve(), but for Unfinished, which is told by the branch.
BranchTree solve_branches(const Scene& scene, const SolveOptions& options, std::size_t most);

}  // namespace rockstack
