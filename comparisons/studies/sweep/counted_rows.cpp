#include "comparisons/studies/sweep/counted_rows.hpp"

#include "comparisons/studies/sweep/ensemble.hpp"

namespace rockstack {

std::vector<std::string> varied_columns(const std::filesystem::path& runs) {
  std::vector<std::string> names = column_names(runs);
  names.erase(std::ranges::find(names, "peak_1"), names.end());
  if (!names.empty()) names.erase(names.begin());
  return names;
}

void each_counted(const std::filesystem::path& runs, std::vector<std::string> names,
                  const std::function<void(const TableRows&)>& take) {
  const std::vector<std::string> varied = varied_columns(runs);
  const bool is_design = std::ranges::find(varied, matrix_column) != varied.end();
  const std::size_t matrix = names.size();
  if (is_design) names.push_back(matrix_column);
  for (TableRows row(runs, names); row.next();)
    if (!is_design || row.text(matrix) == "A" || row.text(matrix) == "B") take(row);
}

}  // namespace rockstack
