#pragma once

#include <filesystem>
#include <functional>
#include <map>

#include "comparisons/measures/statistics/ranking.hpp"
#include "comparisons/measures/statistics/samples.hpp"

namespace rockstack {

/// A run as a comparison has left it.
struct RecordedRun {
  RunMetrics row;                                ///< the one run, at the step that is named
  std::vector<RunMetrics> replicates;            ///< that one and all like it; empty where it stands alone
  std::map<std::string, std::string> checksums;  ///< of its files, by their names
};

/// What a comparison has left in a folder.
struct RecordedResults {
  using Facts = std::map<std::string, std::string>;

  std::filesystem::path folder;
  Facts environment;                    ///< versions, flags, processor
  std::map<std::string, Facts> scenes;  ///< by name: what was asked, how replicates were made; values as JSON
  std::vector<RecordedRun> runs;
};

/// Reads comparison.json of a folder, and of each run summary.json and, where it has replicates, draws.json;
/// nothing else has to be there. Or reads all of it from one file that holds packed_results().
/// @throws InputError naming the file and what is wrong in it.
RecordedResults read_recorded_results(const std::filesystem::path& results);

/// Everything that read_recorded_results() has read, as the text of one file.
std::string packed_results(const RecordedResults& results);

/// One row of the old results with the one of the new results that answers the same question.
struct RowPair {
  const RecordedRun* old_run;
  const RecordedRun* new_run;
};

/// All rows of two comparisons.
struct RowPairs {
  std::vector<RowPair> pairs;                   ///< in the order of the old results
  std::vector<std::string> only_old, only_new;  ///< names of runs that one alone has
  std::vector<std::string> other_questions;     ///< "scene drum-column: gravity": not held together
};

/// What tells rows of one comparison apart: scene, engine, solver, settings and dt.
const std::vector<std::string>& row_names();

/// Pairs rows that agree in all row_names(), then of the others those that agree in all but `across`. Scenes
/// of one name that ask something else, or make replicates another way, are left out unless `across` has
/// "scene".
/// @throws InputError where several rows of one folder agree so, or no row has a partner.
/// The pairs point into both results.
RowPairs pair_rows(const RecordedResults& old_results, const RecordedResults& new_results,
                   const std::vector<std::string>& across);

/// A number of a run, or of a replicate, that may get better or worse.
struct ReportedQuantity {
  enum class Better {
    less,
    more,
    nearer_zero,
    neither,  ///< a matter of the scene
  };

  std::string name;   ///< of its column where it has one
  std::string words;  ///< of the field: "first impact"
  std::string unit;   ///< "rad", "%" of a share, "" of a count, "rad or m" where it depends on the scene
  std::string definition;
  Better better = Better::less;
  bool foremost = false;  ///< of those that share half of the level
  bool told = false;      ///< of those that a headline names first
  std::function<std::optional<double>(const RunMetrics&)> signed_value;

  /// Value without its sign where none is the best.
  std::optional<double> value(const RunMetrics& row) const;
  /// With two digits, in the unit that suits it: "49 mrad".
  std::string text(double value) const;
};

/// "failed" first, 1 where a run is not done, else 0; "other_verdict", 1 where engine or exact solution
/// topples alone, else 0; then the columns that tell how near an engine is to the exact motion, one of those
/// that say the same. The numbers of a run that is not done are left empty.
const std::vector<ReportedQuantity>& reported_quantities();

/// The quantity of that name, "step_time" too. Precondition: there is one.
const ReportedQuantity& quantity_named(const std::string& name);

/// Its values over the replicates of a run, or of the run by itself; none of those that have none.
std::vector<double> values_of(const ReportedQuantity& quantity, const RecordedRun& run);

/// What has become of a number.
enum class Trend { none, better, other, worse };

/// "", "better", "changed", "worse".
std::string name(Trend trend);

/// A number over replicates: the values of ranks ⌈n/4⌉, ⌈n/2⌉ and ⌈3n/4⌉; of a time over repeats its least,
/// median and greatest.
struct ValueSpread {
  double lower = 0, median = 0, upper = 0;
  std::size_t values = 0;
  double least = lower, greatest = upper;  ///< of all of them
  double signed_median = median;           ///< of values with their sign
};

/// One number of one row in both results.
struct QuantityChange {
  std::string quantity;
  ReportedQuantity::Better better;
  bool foremost = false;
  ValueSpread old_values, new_values;
  std::optional<MannWhitney> test = {};         ///< where both have several values
  std::optional<double> adjusted_p_value = {};  ///< of it among all tests
  bool could_show = false;                      ///< whether its test could show a change at the level
  Trend trend = Trend::none;
};

struct ChangeOptions {
  double level =
      change_level;  ///< chance that anything is reported where nothing has changed, between 0 and 1
  // From how many times on numbers are reported that no test can judge; empty: none is.
  std::optional<double> single = {};     ///< of single runs
  std::optional<double> cost = {};       ///< the time of a step, where no repeat of one is within the other's
  std::vector<std::string> across = {};  ///< of row_names(): as pair_rows()
  bool common_alone = false;             ///< whether nothing is asked of what the old results alone have
};

/// The change of a quantity, tested but not yet judged by its test; empty where either has no value of it.
/// A run that is done in the one and not in the other is better or worse whatever the options.
std::optional<QuantityChange> change_of(const ReportedQuantity& quantity, const RowPair& pair,
                                        const ChangeOptions& options);

/// The change of a quantity over several rows: ranks are those within each (mann_whitney()), the spreads
/// those of all values together. Empty where no row has values in both. Precondition: all have replicates in
/// both.
std::optional<QuantityChange> change_of(const ReportedQuantity& quantity, const std::vector<RowPair>& pairs);

/// The change of the wall time of a step, s; of the exact solver, that of the whole motion. Empty where runs
/// shared the machine.
std::optional<QuantityChange> cost_change(const RowPair& pair, const ChangeOptions& options);

/// Judges by the adjusted p-value: at or below the level the number has turned to where its ranks have gone.
/// Changes of median and both quartiles by less than a hundredth, or 1e-12, are not reported.
void judge(double level, QuantityChange& change);

/// Whether a number is worse in every new replicate than in any old one, or, where its own test could not
/// show that, its median is five times worse and either worse than any old value or so at the level before
/// any correction. Where a test of its set judges it, only what is five times worse, and in the median or
/// throughout than any old value, looks so.
bool looks_worse(const QuantityChange& change, bool judged_by_set, double level);

/// Whether more replicates fail, or more topple otherwise and their test could not show that, where none did
/// before or by more than chance has it at the level before any correction; and the test has not said so.
bool fails_more_often(const QuantityChange& change, double level);

/// One row in both results; or all rows of a set, whose scene, step and bits are empty.
struct RowChange {
  RunMetrics old_row, new_row;
  /// "same" or "different" bytes in the files that both kept, "" where none are; "nominal" where they are the
  /// same, but other numbers are not: of replicates, say.
  std::string bits;
  bool replicated = false;  ///< whether both have replicates
  std::vector<QuantityChange> quantities;

  Trend worst() const;
  bool could_show() const;  ///< whether a test of its quantities could show a change
};

/// Two results held against each other.
struct ResultsChange {
  std::vector<RowChange> rows;
  std::vector<RowChange> sets = {};  ///< of an engine, where several of its rows have replicates
  std::vector<std::string> only_old, only_new, other_questions;  ///< as RowPairs
  std::vector<std::string> lost = {};          ///< quantities that some old row has, and none of the new ones
  std::vector<std::string> other_environment;  ///< "compiler: GNU 12.2.0, GNU 13.1.0"
  std::size_t tests = 0;                       ///< numbers that have replicates on both sides, and vary
  std::size_t counted = 0;                     ///< of them, those that could show a change at the level
  double level = 0;
  bool common_alone = false;  ///< as ChangeOptions
  /// Names of engines' old rows of which nothing can be said: other bits, and no number that could show a
  /// change, neither of its own nor of its set.
  std::vector<std::string> undecided = {};
  std::vector<std::string> in_doubt = {};       ///< "sinking of RUN": looks_worse(), and no test says it
  std::vector<std::string> more_failures = {};  ///< "failed of RUN": fails_more_often()
  int replicates_needed = 0;                    ///< in every row, with which none of both would be

  bool worse() const;

  /// Whether a row of an engine is in both, or there is nothing but exact motions.
  bool judges_engines() const;

  /// What the old results alone have, or ask otherwise; nothing where that is not asked.
  std::vector<std::string> judged_no_more() const;

  /// Whether there is none of the above.
  bool decided() const;

  /// In one sentence: what is worse, that nothing is, or what cannot be said.
  std::string headline() const;
};

/// Holds new results against old ones. A number of replicates, of a row or of all rows of a set, is reported
/// as changed where its test, corrected for how many there are, says so at the level; a run by itself where
/// the options say so. Times are reported on one processor alone. @throws InputError as pair_rows().
ResultsChange hold_against(const RecordedResults& old_results, const RecordedResults& new_results,
                           const ChangeOptions& options);

/// Everything that was held together, for programs: what diff.json holds.
Json changes_json(const ResultsChange& result);

/// A line a row and number, and of a set likewise with scene and dt empty:
/// scene,engine,solver,dt,old_settings,new_settings,old_run,new_run,bits,quantity,turn,
/// old_lower,old_median,old_upper,old_values,new_…,superiority,p_value,adjusted_p_value.
std::string changes_csv(const ResultsChange& result);

/// A number of a row that has turned.
struct TurnedNumber {
  const RowChange* row;
  const QuantityChange* change;

  /// The new median over the old one; infinite over 0.
  double ratio() const;
};

/// All of them, worst first: worse ones, then changed ones, then better ones, each by how much. They point
/// into the result.
std::vector<TurnedNumber> turned_numbers(const ResultsChange& result);

/// A number of before and now, in one unit and with its sign: "−4.9 → −67 ms".
std::string change_text(const QuantityChange& change);

/// Steps that cost as much as before, or more or less, over all rows of engines that tell times: the ratio of
/// medians, its median over rows, and its least and greatest; no values where there is none.
ValueSpread cost_ratio(const ResultsChange& result);

/// What tells the set of a row from others: engine, solver and settings of both results.
std::vector<std::string> set_of(const RowChange& row);

/// Judges all numbers by their tests: the foremost each by itself, and so the others, but those of a row that
/// by themselves could show nothing all together (joint_chances()). What they are is told by sizes and ties
/// of both samples together alone, so that the level holds. Precondition: the rows are those of the pairs.
void judge_all(const std::vector<RowPair>& pairs, ResultsChange& result);

/// Names what no test has judged: numbers in doubt, more failures than before, and rows of which nothing can
/// be said; and how many replicates would do.
void find_undecided(const ChangeOptions& options, ResultsChange& result);

}  // namespace rockstack
