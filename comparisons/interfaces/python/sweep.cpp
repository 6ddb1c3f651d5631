#include "comparisons/interfaces/python/sweep.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <mutex>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "analytic/scene/input/toml_reader.hpp"
#include "comparisons/interfaces/python/interrupts.hpp"
#include "comparisons/interfaces/python/nodes.hpp"
#include "comparisons/measures/statistics/fragility.hpp"
#include "comparisons/runs/execution/executor.hpp"
#include "comparisons/studies/sweep/runs.hpp"
#include "comparisons/studies/sweep/sweep.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack::python {
namespace {

namespace py = pybind11;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// A column that is made once, at its full length, and into which runs write from any thread.
template <class Number>
class Column {
 public:
  Column(py::dict& columns, const std::string& name, std::size_t runs)
      : array_(static_cast<py::ssize_t>(runs)), numbers_(array_.mutable_data()) {
    columns[py::str(name)] = array_;
  }
  Number& operator[](std::size_t run) { return numbers_[run]; }

 private:
  py::array_t<Number> array_;
  Number* numbers_;
};

/// The values that runs have of one variation: numbers, or texts by their number in a list.
class VariedColumn {
 public:
  VariedColumn(py::dict& columns, py::dict& words, const Variation& variation, std::size_t runs) {
    const bool numbers =
        std::all_of(variation.values.begin(), variation.values.end(),
                    [](const Value& value) { return value.node.kind == Node::Kind::number; });
    if (numbers) {
      numbers_.emplace(columns, variation.name(), runs);
      return;
    }
    codes_.emplace(columns, variation.name(), runs);
    py::list texts;
    for (const Value& value : variation.values)
      if (code_of_.emplace(value.text, static_cast<std::int32_t>(code_of_.size())).second)
        texts.append(value.text);
    words[py::str(variation.name())] = texts;
  }

  void write(std::size_t run, const Value& value) {
    if (numbers_) {
      (*numbers_)[run] = value.node.number;
    } else {
      (*codes_)[run] = code_of_.at(value.text);
    }
  }

 private:
  std::optional<Column<double>> numbers_;
  std::optional<Column<std::int32_t>> codes_;
  std::map<std::string, std::int32_t> code_of_;
};

/// All columns of a sweep, one row a run; names and meanings are those of runs.csv.
class Table {
 public:
  explicit Table(const Ensemble& ensemble) : runs_(run_count(ensemble)) {
    for (const Variation& variation : ensemble.variations)
      varied_.emplace_back(columns, words, variation, runs_);
    const std::size_t blocks = find(ensemble.base.root, "blocks")->children.size();
    for (std::size_t k = 1; k <= blocks; ++k)
      peaks_.emplace_back(columns, "peak_" + std::to_string(k), runs_);
    for (const auto& [name, of] : measures()) measured_.emplace_back(columns, name, runs_);
    for (const auto& [name, of] : counts()) counted_.emplace_back(columns, name, runs_);
    for (const auto& [name, of] : modes()) {
      mode_columns_.emplace_back(columns, name, runs_);
      py::list names;
      for (const MotionMode mode : motion_modes) names.append(rockstack::name(mode));
      words[name] = names;
    }
  }

  void write(const RunResult& result) {
    for (std::size_t v = 0; v < varied_.size(); ++v) varied_[v].write(result.run, result.values[v]);
    const RunOutcome* outcome = result.outcome;
    for (std::size_t k = 0; k < peaks_.size(); ++k)
      peaks_[k][result.run] = outcome ? outcome->peaks[k] : nothing;
    for (std::size_t i = 0; i < measured_.size(); ++i)
      measured_[i][result.run] = outcome ? measures()[i].of(*outcome) : nothing;
    for (std::size_t i = 0; i < counted_.size(); ++i)
      counted_[i][result.run] = outcome ? counts()[i].of(*outcome) : 0;
    for (std::size_t i = 0; i < mode_columns_.size(); ++i)
      mode_columns_[i][result.run] =
          outcome ? static_cast<std::int8_t>(modes()[i].of(*outcome)) : std::int8_t{-1};
    if (outcome != nullptr) return;
    const std::lock_guard lock(mutex_);
    failures_[result.run] = result.reason;
  }

  /// Columns, the words that the numbers of some stand for, and why runs failed.
  py::tuple result() const { return py::make_tuple(columns, words, failures_); }

  py::dict columns, words;

 private:
  template <class Number>
  struct Entry {
    const char* name;
    Number (*of)(const RunOutcome&);
  };

  static double if_finite(double least, double value) { return std::isfinite(least) ? value : nothing; }

  static const std::vector<Entry<double>>& measures() {
    static const std::vector<Entry<double>> list{
        {"peak_ratio", [](const RunOutcome& of) { return of.peak_ratio; }},
        {"topple_time", [](const RunOutcome& of) { return of.toppled > 0 ? of.topple_time : nothing; }},
        {"last_event_time",
         [](const RunOutcome& of) { return of.events > 0 ? of.last_event_time : nothing; }},
        {"least_normal_force",
         [](const RunOutcome& of) { return if_finite(of.force.least_normal, of.force.least_normal); }},
        {"force_friction",
         [](const RunOutcome& of) { return if_finite(of.force.least_normal, of.force.friction); }},
        {"least_normal_impulse",
         [](const RunOutcome& of) { return if_finite(of.impulse.least_normal, of.impulse.least_normal); }},
        {"impulse_friction",
         [](const RunOutcome& of) { return if_finite(of.impulse.least_normal, of.impulse.friction); }},
        {"slip", [](const RunOutcome& of) { return of.slip.value_or(nothing); }},
        {"lift", [](const RunOutcome& of) { return of.lift.value_or(nothing); }}};
    return list;
  }

  static const std::vector<Entry<std::int32_t>>& counts() {
    static const std::vector<Entry<std::int32_t>> list{
        {"toppled", [](const RunOutcome& of) { return of.toppled; }},
        {"impacts", [](const RunOutcome& of) { return static_cast<std::int32_t>(of.impacts); }},
        {"events", [](const RunOutcome& of) { return static_cast<std::int32_t>(of.events); }}};
    return list;
  }

  static const std::vector<Entry<MotionMode>>& modes() {
    static const std::vector<Entry<MotionMode>> list{
        {"onset", [](const RunOutcome& of) { return of.onset; }},
        {"motion", [](const RunOutcome& of) { return of.motion; }}};
    return list;
  }

  std::size_t runs_;
  std::vector<VariedColumn> varied_;
  std::vector<Column<double>> peaks_, measured_;
  std::vector<Column<std::int32_t>> counted_;
  std::vector<Column<std::int8_t>> mode_columns_;
  std::mutex mutex_;
  std::map<std::size_t, std::string> failures_;
};

py::tuple run(const Ensemble& ensemble, MotionLibrary& library, std::size_t threads) {
  Table table(ensemble);
  const std::size_t runs = run_count(ensemble), size = block_size(runs);
  std::vector<std::size_t> blocks((runs + size - 1) / size);
  std::iota(blocks.begin(), blocks.end(), 0);
  beside_interpreter([&](const std::atomic<bool>& stop) {
    const std::function<bool()> unwanted = [&] { return stop.load(); };
    const auto take = [&](const RunResult& result) {
      if (stop) throw Unwanted();
      table.write(result);
    };
    const auto compute = [&](std::size_t block) {
      make_runs(ensemble, block * size, std::min(runs, (block + 1) * size), library, take, &unwanted);
      return std::string();
    };
    make_threads(threads)->run(blocks, {compute, [](std::size_t, const std::string&) {}, unwanted});
  });
  return table.result();
}

py::tuple sweep_file(const std::string& name, const std::vector<std::string>& overrides,
                     std::size_t threads) {
  MotionLibrary library;
  return run(read_ensemble(find_file(name, "ensembles"), overrides, library), library, threads);
}

py::tuple sweep_made(const py::object& mapping, const std::filesystem::path& folder,
                     const std::vector<std::string>& overrides, std::size_t threads) {
  MotionLibrary library;
  const Node root = read_document(mapping, "ensemble");
  return run(make_ensemble(root, folder / "ensemble", overrides, library), library, threads);
}

/// Median and beta of the fitted curve; None where there is none.
std::optional<std::pair<double, double>> fit(const std::vector<double>& intensities,
                                             const std::vector<std::size_t>& runs,
                                             const std::vector<std::size_t>& toppled) {
  std::vector<Level> levels;
  for (std::size_t i = 0; i < intensities.size(); ++i)
    levels.push_back({intensities[i], runs[i], toppled[i], 0});
  const std::optional<Fragility> curve = fit_fragility(levels);
  if (!curve) return std::nullopt;
  return std::pair(curve->median, curve->beta);
}

std::pair<double, double> bounds(std::size_t toppled, std::size_t runs) {
  const Bounds wilson = wilson_bounds(toppled, runs);
  return {wilson.lower, wilson.upper};
}

}  // namespace

void add_sweep(py::module_& core) {
  core.def("sweep_file", &sweep_file);
  core.def("sweep_made", &sweep_made);
  core.def("fit_fragility", &fit);
  core.def("wilson_bounds", &bounds);
}

}  // namespace rockstack::python
