#include "comparisons/measures/results/run_metrics.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "rockstack_measures_texts.hpp"

namespace rockstack {
namespace {

/// Those of quartiles stand behind the one that they are of.
std::vector<Column> all_columns() {
  const std::map<std::string, Column::Field> fields{
#include "comparisons/measures/results/run_metrics_fields.inc"
  };
  std::vector<Column> all;
  for (const auto& [name, kind, meaning] : paragraphs(columns_txt)) {
    const auto is = [&kind = kind](const char* word) { return kind.find(word) != std::string::npos; };
    all.push_back({name, meaning, fields.at(name), is("measured"), is("median")});
    if (!is("quartiles")) continue;
    const Column::Field lower = fields.at(name + "_lower"), upper = fields.at(name + "_upper");
    all.back().lower = lower, all.back().upper = upper;
    all.push_back({name + "_lower", "lower quartile of the same over replicates", lower});
    all.push_back({name + "_upper", "upper quartile", upper});
  }
  return all;
}

}  // namespace

const std::vector<Column>& columns() {
  static const std::vector<Column> list = all_columns();
  return list;
}

const Column& column_named(const std::string& name) {
  const auto found = std::ranges::find(columns(), name, &Column::name);
  if (found == columns().end()) throw std::logic_error(name + ": no column of a comparison");
  return *found;
}

}  // namespace rockstack
