#include "plots/data/spread.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "comparisons/measures/results/csv.hpp"

namespace rockstack::plots {
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

Share toppled_share(const std::vector<MotionTally>& tallies, const std::vector<MotionTally>& exact) {
  Share share;
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    if (tallies[i].failed()) continue;
    ++share.of;
    if (tallies[i].topples) ++share.toppled;
    if (i < exact.size() && !exact[i].failed() && exact[i].topples == tallies[i].topples) ++share.agree;
  }
  return share;
}

}  // namespace rockstack::plots
