#include "plots/data/spread.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "comparisons/measures/results/csv.hpp"

namespace rockstack::plots {
namespace {

/// One of Wilson's bounds, `side` standard errors of 95 % from the middle.
double wilson(double share, double count, double side) {
  constexpr double normal = 1.959964;  // quantile of 97.5 %
  const double square = normal * normal / count;
  return (share + square / 2 + side * normal * std::sqrt(share * (1 - share) / count + square / 4 / count)) /
         (1 + square);
}

}  // namespace

std::vector<double> draws_of(const Run& run, const std::string& quantity) {
  const auto file = run.folder / "draws.csv";
  if (!std::filesystem::exists(file)) return {};
  std::vector<double> values = read_columns(file, {quantity}).front();
  std::erase_if(values, [](double value) { return std::isnan(value); });
  std::sort(values.begin(), values.end());
  return values;
}

std::map<std::string, SpreadRange> ranges_of(const std::filesystem::path& results,
                                             const std::string& quantity) {
  const auto file = results / "spread.csv";
  std::map<std::string, SpreadRange> ranges;
  if (!std::filesystem::exists(file)) return ranges;
  const Table table = read_table(file);
  const std::size_t run = column(table, "run", file), name = column(table, "quantity", file),
                    least = column(table, "least", file), greatest = column(table, "greatest", file);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto& row = table.rows[i];
    if (row[name] != quantity) continue;
    const std::string place = fmt::format("{}:{}", file.string(), i + 2);
    ranges[row[run]] = {number(row[least], place, "least"), number(row[greatest], place, "greatest")};
  }
  return ranges;
}

double Share::lower() const {
  return wilson(value(), of, -1);
}

double Share::upper() const {
  return wilson(value(), of, 1);
}

Share toppled_share(const Run& run, const Run& exact) {
  const auto answers = read_columns(run.folder / "perturbed.csv", {"run", "toppled"});
  const auto truth = read_columns(exact.folder / "perturbed.csv", {"run", "toppled"});
  std::map<double, double> exact_answer;
  for (std::size_t i = 0; i < truth[0].size(); ++i) exact_answer[truth[0][i]] = truth[1][i];
  Share share;
  for (std::size_t i = 0; i < answers[0].size(); ++i) {
    if (std::isnan(answers[1][i])) continue;
    ++share.of;
    share.toppled += answers[1][i] > 0 ? 1 : 0;
    const auto found = exact_answer.find(answers[0][i]);
    if (found != exact_answer.end() && !std::isnan(found->second))
      share.agree += (answers[1][i] > 0) == (found->second > 0) ? 1 : 0;
  }
  return share;
}

}  // namespace rockstack::plots
