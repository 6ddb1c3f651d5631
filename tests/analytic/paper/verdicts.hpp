#pragma once

#include <string_view>
#include <vector>

namespace rockstack::paper {

/// What the audit found about a numbered equation of Spanos et al. 2001.
enum class Verdict {
  definition,  ///< names a quantity or states a constraint; nothing to hold against physics
  agrees,      ///< right as printed
  misprint,    ///< wrong as printed, right in the corrected reading
  ambiguous    ///< the print leaves a symbol open; one reading is right, another one is not
};

std::string_view name(Verdict verdict);

/// Consecutive equations with the same verdict.
struct VerdictRow {
  int first, last;
  Verdict verdict;
};

/// All equations, in order.
const std::vector<VerdictRow>& verdicts();

/// @throws std::out_of_range for an equation that has no verdict.
Verdict verdict_of(int equation);

inline constexpr int equation_count = 163;

}  // namespace rockstack::paper
