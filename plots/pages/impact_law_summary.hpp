#pragma once

#include <string>
#include <vector>

#include "plots/data/law_results.hpp"

namespace rockstack::plots {

/// The shortest answer: whose pattern engines take where the laws differ, and how often the laws do.
std::vector<std::string> law_answer(const LawResults& results);

/// How often and where the laws differ over the stacks that were drawn, one sentence an entry, as plain text.
std::vector<std::string> law_summary(const LawResults& results);

/// Which law the engines are nearer to, how near, and where they are farthest from it.
std::vector<std::string> engine_summary(const LawResults& results);

}  // namespace rockstack::plots
