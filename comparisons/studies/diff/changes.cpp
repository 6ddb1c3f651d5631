#include "comparisons/studies/diff/changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "comparisons/measures/statistics/samples.hpp"

namespace rockstack {
namespace {

SameBits bits_of(const RowPair& pair) {
  SameBits bits = SameBits::unknown;
  for (const auto& [file, sum] : pair.old_run->checksums) {
    const auto other = pair.new_run->checksums.find(file);
    if (other == pair.new_run->checksums.end()) continue;
    if (other->second != sum) return SameBits::different;
    bits = SameBits::same;
  }
  return bits;
}

RowChange row_change(const RowPair& pair, const ChangeFactors& factors, bool timed) {
  RowChange row{pair.old_run->row,
                pair.new_run->row,
                bits_of(pair),
                !pair.old_run->draws.empty() && !pair.new_run->draws.empty(),
                {}};
  for (const TellingQuantity& quantity : telling_quantities())
    if (auto change = change_of(quantity, pair, factors)) row.quantities.push_back(std::move(*change));
  if (timed)
    if (auto change = cost_change(pair, factors)) row.quantities.push_back(std::move(*change));
  return row;
}

const TellingQuantity& quantity_of(const QuantityChange& change) {
  return *std::find_if(telling_quantities().begin(), telling_quantities().end(),
                       [&](const TellingQuantity& quantity) { return quantity.name == change.quantity; });
}

/// Corrects all tests for how many there are, and judges by them.
void judge_all(ResultsChange& result) {
  std::vector<QuantityChange*> tested;
  std::vector<TestChance> chances;
  for (RowChange& row : result.rows) {
    for (QuantityChange& change : row.quantities) {
      if (!change.test) continue;
      tested.push_back(&change);
      chances.push_back({change.test->p_value, change.test->least_p_value});
    }
  }
  const AdjustedTests adjusted = adjust(chances, result.level);
  result.counted = adjusted.counted;
  result.tests = static_cast<std::size_t>(std::count_if(
      chances.begin(), chances.end(), [](const TestChance& chance) { return chance.least_p_value < 1; }));
  for (std::size_t i = 0; i < tested.size(); ++i) {
    tested[i]->adjusted_p_value = adjusted.p_values[i];
    judge(quantity_of(*tested[i]), result.level, *tested[i]);
  }
}

std::vector<std::string> other_environment(const RecordedResults& old_results,
                                           const RecordedResults& new_results) {
  std::vector<std::string> others;
  for (const auto& [key, value] : old_results.environment) {
    const auto other = new_results.environment.find(key);
    if (other != new_results.environment.end() && other->second != value)
      others.push_back(fmt::format("{}: {}, {}", key, value, other->second));
  }
  return others;
}

bool same_processor(const RecordedResults& old_results, const RecordedResults& new_results) {
  const auto name = old_results.environment.find("processor"),
             other = new_results.environment.find("processor");
  return name != old_results.environment.end() && other != new_results.environment.end() &&
         name->second == other->second;
}

}  // namespace

std::string name(SameBits bits) {
  constexpr std::array<const char*, 3> names{"same", "different", ""};
  return names.at(static_cast<std::size_t>(bits));
}

Turn RowChange::worst() const {
  Turn worst = Turn::none;
  for (const QuantityChange& change : quantities) worst = std::max(worst, change.turn);
  return worst;
}

bool ResultsChange::worse() const {
  return std::any_of(rows.begin(), rows.end(),
                     [](const RowChange& row) { return row.worst() == Turn::worse; });
}

std::size_t ResultsChange::draws_needed() const {
  const double chance = level / static_cast<double>(std::max<std::size_t>(tests, 1));
  std::size_t draws = 1;
  // Of two samples of n values the least chance is 2/C(2n, n), which is 1 for n = 1.
  for (double least = 1; least > chance; ++draws) {
    const auto n = static_cast<double>(draws);
    least *= (n + 1) / (2 * (2 * n + 1));
  }
  return draws;
}

ResultsChange hold_against(const RecordedResults& old_results, const RecordedResults& new_results,
                           const ChangeOptions& options) {
  RowPairs pairs = pair_rows(old_results, new_results, options.across);
  ResultsChange result;
  result.level = options.level;
  result.only_old = std::move(pairs.only_old);
  result.only_new = std::move(pairs.only_new);
  result.other_questions = std::move(pairs.other_questions);
  result.other_environment = other_environment(old_results, new_results);
  const bool timed = same_processor(old_results, new_results);
  result.rows.reserve(pairs.pairs.size());
  for (const RowPair& pair : pairs.pairs) result.rows.push_back(row_change(pair, options.factors, timed));
  judge_all(result);
  return result;
}

}  // namespace rockstack
