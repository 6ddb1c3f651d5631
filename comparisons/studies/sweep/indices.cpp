#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/long_table.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/studies/sweep/sweep.hpp"

// Which of the values that are drawn decides.

namespace rockstack {
namespace {

/// The samples of one outcome at one intensity.
struct Design {
  std::vector<SobolSample> samples;
  std::size_t left_out = 0;
};

/// NaN where a run has none.
double outcome_in(double value, const std::string& outcome) {
  const bool is_block = outcome == "toppled" || outcome == "falling";
  return is_block && value > 0 ? 1 : value;
}

/// The outcomes of one sample's runs, in their order, as one row of the design of each.
void add_sample(const std::vector<std::vector<double>>& runs, std::vector<Design>& designs) {
  for (std::size_t o = 0; o < designs.size(); ++o) {
    const auto of_run = [&](const std::vector<double>& outcomes) { return outcomes[o]; };
    const std::vector<double> values = mapped(runs, of_run);
    if (std::ranges::any_of(values, [](double value) { return !std::isfinite(value); }))
      ++designs[o].left_out;
    else
      designs[o].samples.push_back({values[0], values[1], {values.begin() + 2, values.end()}});
  }
}

/// The designs of all outcomes, by the intensity of the grid.
struct Designs {
  std::vector<std::string> inputs;
  std::map<std::optional<double>, std::vector<Design>> levels;
};

Designs read_designs(const std::filesystem::path& file, const SummaryKeys& keys) {
  Designs designs;
  std::vector<std::string> names = keys.indices;
  names.push_back(matrix_column);
  if (!keys.intensity.empty()) names.push_back(keys.intensity);
  const std::size_t outcomes = keys.indices.size();
  TableRows row(file, names);
  bool more = row.next();
  while (more) {
    std::vector<std::string> matrices;
    std::vector<std::vector<double>> runs;
    std::optional<double> intensity;
    if (!keys.intensity.empty()) intensity = row.value(outcomes + 1);
    do {
      matrices.push_back(row.text(outcomes));
      std::vector<double>& values = runs.emplace_back();
      for (std::size_t o = 0; o < outcomes; ++o) values.push_back(outcome_in(row.value(o), keys.indices[o]));
      more = row.next();
    } while (more && row.text(outcomes) != "A");
    designs.inputs.assign(matrices.begin() + 2, matrices.end());
    if (std::ranges::find(designs.inputs, keys.intensity) != designs.inputs.end()) intensity.reset();
    std::vector<Design>& level = designs.levels[intensity];
    level.resize(outcomes);
    add_sample(runs, level);
  }
  return designs;
}

std::string number_or_none(double value) {
  return std::isnan(value) ? "" : number_text(value);
}

void add_cells(CsvWriter& csv, const VarianceShare& share) {
  csv.add(number_or_none(share.value), number_or_none(share.lower), number_or_none(share.upper));
}

Json json_of(const VarianceShare& share) {
  return Json{{"value", share.value}, {"lower", share.lower}, {"upper", share.upper}};
}

std::string with_bounds(const VarianceShare& share) {
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", share.value, share.lower, share.upper);
}

/// The inputs of an outcome at the intensity at which it varies most, the largest total index first.
std::vector<InputIndices> decisive(std::vector<InputIndices> list, const std::string& outcome) {
  std::erase_if(list, [&](const InputIndices& one) {
    return one.outcome != outcome || std::isnan(one.indices.total.value);
  });
  if (list.empty()) return list;
  const auto most = std::ranges::max_element(list, {}, &InputIndices::deviation)->intensity;
  std::erase_if(list, [&](const InputIndices& one) { return one.intensity != most; });
  std::ranges::stable_sort(list, std::ranges::greater(),
                           [](const InputIndices& one) { return one.indices.total.value; });
  return list;
}

}  // namespace

std::vector<InputIndices> input_indices(const std::filesystem::path& folder, const SummaryKeys& keys) {
  std::vector<InputIndices> list;
  const Designs designs = read_designs(folder / "runs.csv", keys);
  for (const auto& [intensity, outcomes] : designs.levels)
    for (std::size_t o = 0; o < outcomes.size(); ++o) {
      const Design& design = outcomes[o];
      const std::vector<SobolIndices> indices = sobol_indices(design.samples, designs.inputs.size());
      for (std::size_t i = 0; i < indices.size(); ++i)
        list.push_back({intensity, keys.indices[o], designs.inputs[i], indices[i], deviation(design.samples),
                        design.samples.size(), design.left_out});
    }
  return list;
}

void write_indices(const std::filesystem::path& folder, const std::vector<InputIndices>& list) {
  CsvWriter csv;
  csv.line("intensity", "outcome", "key", "first", "first_lower", "first_upper", "total", "total_lower",
           "total_upper", "deviation", "samples", "left_out");
  for (const InputIndices& one : list) {
    csv.add(one.intensity ? number_text(*one.intensity) : "", one.outcome, one.key);
    add_cells(csv, one.indices.first);
    add_cells(csv, one.indices.total);
    csv.line(number_or_none(one.deviation), one.samples, one.left_out);
  }
  write_file(folder / "indices.csv", csv.text());
}

Json json_of(const InputIndices& one) {
  return Json{{"intensity", one.intensity ? Json(*one.intensity) : Json()},
              {"outcome", one.outcome},
              {"key", one.key},
              {"first", json_of(one.indices.first)},
              {"total", json_of(one.indices.total)},
              {"deviation", one.deviation},
              {"samples", one.samples},
              {"left_out", one.left_out}};
}

std::vector<std::string> index_sentences(const std::vector<InputIndices>& list, const std::string& axis) {
  std::vector<std::string> sentences, outcomes;
  for (const InputIndices& one : list)
    if (std::ranges::find(outcomes, one.outcome) == outcomes.end()) outcomes.push_back(one.outcome);
  for (const std::string& outcome : outcomes) {
    const std::vector<InputIndices> inputs = decisive(list, outcome);
    if (inputs.empty()) continue;
    const InputIndices& first = inputs[0];
    std::string sentence =
        fmt::format("{}{} decides most over {}: its total Sobol index is {}, its first-order index {}",
                    first.intensity ? "At " + value_on(axis, *first.intensity) + " " : "", first.key, outcome,
                    with_bounds(first.indices.total), with_bounds(first.indices.first));
    if (inputs.size() > 1) {
      const VarianceShare& next = inputs[1].indices.total;
      sentence += fmt::format("; the next is {} with {}{}", inputs[1].key, with_bounds(next),
                              next.upper > first.indices.total.lower ? ", and the bounds overlap" : "");
    }
    sentences.push_back(sentence + ".");
  }
  return sentences;
}

}  // namespace rockstack
