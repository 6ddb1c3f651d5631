#pragma once

#include <variant>

#include "analytic/scene/input/json.hpp"
#include "comparisons/measures/metrics/motion_verdict.hpp"

namespace rockstack {

/// How a run ended; columns() has what each means.
enum class RunStatus { done, failed, not_finite, signal, time_limit, memory_limit };

/// "done", "not finite", …
std::string name(RunStatus status);

/// The status of that name. @throws std::invalid_argument where there is none.
RunStatus run_status(const std::string& name);

/// What was run and how it differs from the exact solution: one row of a comparison, with the members that
/// columns.txt names, texts and optional numbers. Empty where it does not apply, was not asked for, or the
/// run failed. columns() holds what each means, and its unit. Numbers of the motion are medians over
/// replicates where the suite asks for some.
struct RunMetrics {
#include "comparisons/measures/results/run_metrics_members.inc"
};

/// The folder in a run's own that has the files of its `shown_replicate`.
inline constexpr const char* shown_name = "shown";

/// A column of comparison.csv: its name, what it means, and of which member it is.
struct Column {
  using Field =
      std::variant<std::string RunMetrics::*, std::optional<double> RunMetrics::*,
                   std::optional<int> RunMetrics::*, RunStatus RunMetrics::*, TopplingVerdict RunMetrics::*>;

  std::string name, definition;
  Field field;
  bool measured = false;    ///< time or memory that the machine took: another run gives another value
  bool replicated = false;  ///< a median over replicates, where there are some
  bool quartiles = false;   ///< which NAME_lower and NAME_upper behind it are
  bool any_motion = false;  ///< whether a motion by itself has it too

  Json cell(const RunMetrics& row) const;
  void set(RunMetrics& row, const Json& cell) const;
};

const std::vector<Column>& columns();

/// The column of that name. @throws std::logic_error where there is none.
const Column& column_named(const std::string& name);

/// All metrics by the names of their columns, and back; a cell that is not there stays empty.
void to_json(Json& cells, const RunMetrics& row);
void from_json(const Json& cells, RunMetrics& row);

/// The part of them that a motion by itself has, and back.
Json motion_cells(const RunMetrics& row);
RunMetrics motion_row(const Json& cells);

}  // namespace rockstack
