#include "comparisons/studies/diff/changes.hpp"

#include "comparisons/measures/statistics/joint_test.hpp"

namespace rockstack {
namespace {

using RowChanges = std::vector<RowChange>;

/// A test, and the numbers that it judges: one, or several of a row.
struct ChangeTest {
  std::vector<QuantityChange*> numbers;
  double least_p_value = 1;
  const RowPair* together = nullptr;  ///< the row of several
};

/// Above it all numbers of a row together take too long.
constexpr double most_ways = 5e4;

ReplicatedNumber number_of(const ReportedQuantity& quantity, const RowPair& pair) {
  ReplicatedNumber number;
  for (const RecordedRun* run : {pair.old_run, pair.new_run})
    for (const RunMetrics& replicate : run->replicates) {
      const auto value = quantity.value(replicate);
      number.push_back(value && !std::isnan(*value) ? value : std::nullopt);
    }
  return number;
}

std::vector<double> p_values_of(const ChangeTest& test) {
  if (test.together == nullptr) return {test.numbers.front()->test->p_value};
  return joint_chances(mapped(test.numbers,
                              [&](const QuantityChange* change) {
                                return number_of(quantity_named(change->quantity), *test.together);
                              }),
                       test.together->old_run->replicates.size());
}

std::vector<TestChance> least_chances(const std::vector<ChangeTest>& tests) {
  return mapped(tests, [](const ChangeTest& test) {
    return TestChance{test.least_p_value, test.least_p_value};
  });
}

std::vector<ChangeTest> tests_of(RowChange& row, bool foremost) {
  std::vector<ChangeTest> tests;
  for (QuantityChange& change : row.quantities)
    if (change.test && change.foremost == foremost) tests.push_back({{&change}, change.test->least_p_value});
  return tests;
}

/// Those of a row as one.
ChangeTest joined_test(const std::vector<ChangeTest>& tests, const RowPair& pair) {
  ChangeTest joint{
      {}, least_joint_chance(pair.old_run->replicates.size(), pair.new_run->replicates.size()), &pair};
  for (const ChangeTest& test : tests)
    if (test.least_p_value < 1) joint.numbers.push_back(test.numbers.front());
  return joint;
}

bool can_join(const std::vector<ChangeTest>& tests, const RowPair& pair) {
  const bool vary = std::ranges::any_of(tests, [](const ChangeTest& one) { return one.least_p_value < 1; });
  return vary && ways_to_share(pair.old_run->replicates.size(), pair.new_run->replicates.size()) <= most_ways;
}

void append_tests(const std::vector<ChangeTest>& more, std::vector<ChangeTest>& tests) {
  tests.insert(tests.end(), more.begin(), more.end());
}

std::vector<ChangeTest> tests_alone(bool foremost, ResultsChange& result) {
  std::vector<ChangeTest> tests;
  for (RowChanges* rows : {&result.rows, &result.sets})
    for (RowChange& row : *rows) append_tests(tests_of(row, foremost), tests);
  return tests;
}

/// Tests of all numbers that are not foremost.
std::vector<ChangeTest> tests_of_others(const std::vector<RowPair>& pairs, double level,
                                        ResultsChange& result) {
  std::vector<ChangeTest> tests = tests_alone(false, result);
  const std::vector<bool> shown = could_show(least_chances(tests), level);
  for (std::size_t i = 0; i < tests.size(); ++i) tests[i].numbers.front()->could_show = shown[i];
  tests.clear();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::vector<ChangeTest> own = tests_of(result.rows[i], false);
    const bool alone =
        std::ranges::any_of(own, [](const ChangeTest& test) { return test.numbers.front()->could_show; });
    if (!alone && can_join(own, pairs[i]))
      tests.push_back(joined_test(own, pairs[i]));
    else
      append_tests(own, tests);
  }
  for (RowChange& set : result.sets) append_tests(tests_of(set, false), tests);
  return tests;
}

/// Corrects the tests of one half of the level for how many there are, and judges by them. Of a test of
/// several numbers the least p-value stands for it among the others.
void judge_share(const std::vector<ChangeTest>& tests, double share, ResultsChange& result) {
  std::vector<TestChance> chances = least_chances(tests);
  const std::vector<bool> shown = could_show(chances, share * result.level);
  std::vector<std::vector<double>> own(tests.size());
  for (std::size_t i = 0; i < tests.size(); ++i) {
    own[i] = shown[i] ? p_values_of(tests[i]) : std::vector(tests[i].numbers.size(), 1.0);
    chances[i].p_value = std::ranges::min(own[i]);
  }
  const AdjustedTests adjusted = adjust(chances, share * result.level);
  for (std::size_t i = 0; i < tests.size(); ++i)
    for (std::size_t j = 0; j < own[i].size(); ++j) {
      QuantityChange& change = *tests[i].numbers[j];
      const double beyond_least = own[i].size() == 1 ? 1 : own[i][j] / chances[i].p_value;
      change.adjusted_p_value = std::min(1.0, adjusted.p_values[i] * beyond_least / share);
      change.could_show = shown[i];
      result.tests += change.test->least_p_value < 1 ? 1 : 0;
      result.counted += shown[i] ? 1 : 0;
      judge(result.level, change);
    }
}

/// What a row has shown, its set does not repeat.
void leave_to_rows(ResultsChange& result) {
  for (RowChange& set : result.sets)
    for (QuantityChange& change : set.quantities)
      for (const RowChange& row : result.rows)
        if (set_of(row) == set_of(set))
          for (const QuantityChange& own : row.quantities)
            if (own.quantity == change.quantity && own.trend == change.trend) change.trend = Trend::none;
}

/// The set's number that a row's is part of; none where the row stands alone.
const QuantityChange* number_of_set(const ResultsChange& result, const RowChange& row,
                                    const QuantityChange& change) {
  for (const RowChange& set : result.sets)
    if (row.replicated && set_of(set) == set_of(row))
      for (const QuantityChange& own : set.quantities)
        if (own.quantity == change.quantity) return &own;
  return nullptr;
}

/// Whether not all replicates of a row have a number, such as a second peak.
bool some_lack(const RowChange& row, const QuantityChange& change) {
  const QuantityChange& failed = row.quantities.front();  // which all have
  return change.old_values.values < failed.old_values.values ||
         change.new_values.values < failed.new_values.values;
}

/// Whether a number looks worse, and no test has said so. Of the few values that some replicates have, all
/// new ones may be worse by chance.
bool is_in_doubt(const ResultsChange& result, const RowChange& row, const QuantityChange& change) {
  const QuantityChange* const set = number_of_set(result, row, change);
  if (change.trend != Trend::none || (set != nullptr && set->trend == Trend::worse)) return false;
  if (change.test && change.test->p_value > result.level && some_lack(row, change)) return false;
  return looks_worse(change, set != nullptr && set->could_show, result.level);
}

/// Whether something can be said of a row by itself: it is an exact motion, or the same to the bit, has
/// turned, never varies, or has numbers that could show a change.
bool is_decided(const RowChange& row, const ChangeOptions& options) {
  const auto never_varies = [](const QuantityChange& change) {
    return change.test && change.test->least_p_value == 1 &&
           change.old_values.lower == change.new_values.upper;
  };
  return !row.old_row.steps || row.bits == "same" || row.worst() != Trend::none || row.could_show() ||
         (row.replicated ? std::ranges::all_of(row.quantities, never_varies) : options.single.has_value());
}

bool is_decided_by_set(const RowChange& row, const ResultsChange& result) {
  return row.replicated && std::ranges::any_of(result.sets, [&](const RowChange& set) {
           return set.could_show() && set_of(set) == set_of(row);
         });
}

/// In every row, for what is undecided; none where failures alone are in doubt.
int replicates_that_would_do(const ResultsChange& result, std::size_t in_doubt) {
  std::map<std::vector<std::string>, std::size_t> rows;
  for (const RowChange& row : result.rows)
    if (row.old_row.steps) ++rows[set_of(row)];
  int needed = 0;
  if (!result.undecided.empty())
    needed =
        replicates_that_show_changes(mapped(rows, [](const auto& one) { return one.second; }), result.level);
  if (in_doubt == 0) return needed;
  const int own = replicates_that_decide(result.tests, result.level);
  return std::max({needed, own, static_cast<int>(in_doubt) + 1});
}

}  // namespace

std::vector<std::string> set_of(const RowChange& row) {
  const RunMetrics &before = row.old_row, &now = row.new_row;
  return {before.engine, before.solver, before.settings, now.engine, now.solver, now.settings};
}

void judge_all(const std::vector<RowPair>& pairs, ResultsChange& result) {
  constexpr double share = 1 - foremost_share;
  judge_share(tests_alone(true, result), foremost_share, result);
  judge_share(tests_of_others(pairs, share * result.level, result), share, result);
  leave_to_rows(result);
}

void find_undecided(const ChangeOptions& options, ResultsChange& result) {
  std::size_t replicates = 0;  // of numbers in doubt
  for (const RowChange& row : result.rows) {
    if (!is_decided_by_set(row, result) && !is_decided(row, options))
      result.undecided.push_back(row.old_row.run);
    for (const QuantityChange& change : row.quantities) {
      const std::string name = change.quantity + " of " + row.new_row.run;
      if (fails_more_often(change, result.level)) {
        result.more_failures.push_back(name);
      } else if (is_in_doubt(result, row, change)) {
        result.in_doubt.push_back(name);
        replicates = std::max(replicates, change.new_values.values);
      }
    }
  }
  result.replicates_needed = replicates_that_would_do(result, replicates);
}

}  // namespace rockstack
