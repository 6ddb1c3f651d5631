#include "comparisons/studies/sweep/sweep.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <numeric>

#include "comparisons/interfaces/python/convert.hpp"
#include "comparisons/measures/statistics/fragility.hpp"
#include "comparisons/studies/sweep/make_runs.hpp"
#include "comparisons/studies/threshold/threshold.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack::python {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// All columns of a sweep, one row a run; names and meanings are those of runs.csv.
class SweepTable {
 public:
  explicit SweepTable(const Ensemble& ensemble) : runs_(static_cast<py::ssize_t>(run_count(ensemble))) {
    for (std::size_t v = 0; v < ensemble.variations.size(); ++v) add_variation(ensemble.variations[v], v);
    const bool is_design = !ensemble.summary.indices.empty();
    if (is_design) add_matrices(ensemble);
    std::vector<OutcomeColumn> columns = outcome_columns(block_count(ensemble));
    std::ranges::stable_sort(columns, {}, [](const OutcomeColumn& column) { return column.value.index(); });
    for (const OutcomeColumn& column : columns) add_outcome(column);
    for (const Axis& axis : ensemble.axes)
      axes_.append(py::make_tuple(
          mapped(axis.variations, [&](std::size_t v) { return ensemble.variations[v].name(); }),
          axis.length));
    axes_.append(py::make_tuple(py::list(), ensemble.samples));
    if (is_design) axes_.append(py::make_tuple(std::vector{matrix_column}, sample_size(ensemble)));
  }

  /// From any thread.
  void write(const RunResult& result) {
    for (const auto& write : writers_) write(result);
    if (result.outcome != nullptr) return;
    const std::lock_guard lock(mutex_);
    failures_[result.run] = result.reason;
  }

  /// Columns, the words that the numbers of some stand for, why runs failed, and the names and the length of
  /// each direction of the grid, the last that of what is drawn.
  py::tuple result() const { return py::make_tuple(columns_, words_, failures_, axes_); }

 private:
  /// A column that is made once, at its full length; `of` is what it has of a RunResult.
  template <class Number, class Of>
  void add(const std::string& name, const Of& of) {
    py::array_t<Number> array(runs_);
    writers_.push_back([numbers = array.mutable_data(), of](const RunResult& result) {
      numbers[result.run] = static_cast<Number>(of(result));
    });
    columns_[py::str(name)] = std::move(array);
  }

  void add_outcome(const OutcomeColumn& column) {
    if (const auto* measure = std::get_if<OutcomeColumn::Measure>(&column.value))
      add<double>(column.name, [of = *measure](const RunResult& result) {
        return result.outcome ? of(*result.outcome).value_or(nothing) : nothing;
      });
    if (const auto* count = std::get_if<OutcomeColumn::Count>(&column.value))
      add<std::int32_t>(column.name, [of = *count](const RunResult& result) {
        return result.outcome ? of(*result.outcome) : 0;
      });
    const auto* mode = std::get_if<OutcomeColumn::Mode>(&column.value);
    if (mode == nullptr) return;
    add<std::int8_t>(column.name, [of = *mode](const RunResult& result) {
      return result.outcome ? static_cast<int>(result.outcome->*of) : -1;
    });
    words_[py::str(column.name)] = mapped(motion_modes, [](MotionMode one) { return name(one); });
  }

  /// What each run is in its sample.
  void add_matrices(const Ensemble& ensemble) {
    const std::size_t size = sample_size(ensemble);
    py::list matrices;
    for (std::size_t run = 0; run < size; ++run) matrices.append(matrix_of(ensemble, run));
    words_[py::str(matrix_column)] = matrices;
    add<std::int32_t>(matrix_column, [size](const RunResult& result) { return result.run % size; });
  }

  /// The values that runs have of one variation: numbers, or texts by their number in a list.
  void add_variation(const Variation& variation, std::size_t index) {
    const auto is_number = [](const Value& value) { return value.node.kind == Node::Kind::number; };
    if (std::ranges::all_of(variation.values, is_number))
      return add<double>(variation.name(),
                         [index](const RunResult& result) { return result.values[index].node.number; });
    std::map<std::string, std::int32_t> codes;
    py::list texts;
    for (const Value& value : variation.values)
      if (codes.emplace(value.text, static_cast<std::int32_t>(codes.size())).second) texts.append(value.text);
    words_[py::str(variation.name())] = texts;
    add<std::int32_t>(variation.name(), [index, codes](const RunResult& result) {
      return codes.at(result.values[index].text);
    });
  }

  py::ssize_t runs_;
  py::dict columns_, words_;
  py::list axes_;
  std::vector<std::function<void(const RunResult&)>> writers_;
  std::mutex mutex_;
  std::map<std::size_t, std::string> failures_;
};

py::tuple run(const Ensemble& ensemble, MotionLibrary& library, std::size_t threads, const py::object& tell) {
  SweepTable table(ensemble);
  const std::size_t runs = run_count(ensemble), size = block_size(runs);
  ToldProgress progress{tell, 0, runs};
  std::vector<std::size_t> blocks((runs + size - 1) / size);
  std::iota(blocks.begin(), blocks.end(), 0);
  beside_interpreter(
      [&](const std::function<bool()>& stopped) {
        const auto take = [&](const RunResult& result) {
          if (stopped()) throw Cancelled();
          table.write(result);
          ++progress.done;
        };
        const auto compute = [&](std::size_t block) {
          make_runs(ensemble, block * size, std::min(runs, (block + 1) * size), library, take, &stopped);
          return std::string();
        };
        make_threads(threads)->run(blocks, {compute, [](std::size_t, const std::string&) {}, stopped});
      },
      progress);
  return table.result();
}

py::tuple sweep_file(const std::string& name, const std::vector<std::string>& overrides, std::size_t threads,
                     const py::object& tell) {
  MotionLibrary library;
  return run(read_ensemble(find_file(name, "ensembles"), overrides, library), library, threads, tell);
}

py::tuple sweep_made(const py::object& mapping, const std::filesystem::path& folder,
                     const std::vector<std::string>& overrides, std::size_t threads, const py::object& tell) {
  MotionLibrary library;
  const Node root = read_document(mapping, "ensemble");
  return run(make_ensemble(root, folder / "ensemble", overrides, library), library, threads, tell);
}

/// The first threshold of a scene's number, None where there is none, and the ranges of outcomes.
py::tuple threshold_made(const py::object& mapping, const std::filesystem::path& folder,
                         const std::string& vary, const std::string& outcome, std::size_t values) {
  MotionLibrary library;
  const SceneDocument document{read_document(mapping, "scene"), folder, ""};
  const std::size_t blocks = make_scene(document, library).blocks.size();
  const ThresholdRequest request{varied_key("vary", vary), outcome_named(outcome, blocks), values};
  const Threshold found = [&] {
    const py::gil_scoped_release released;
    return threshold(document, request, library);
  }();
  py::list ranges;
  for (const OutcomeRange& range : found.ranges)
    ranges.append(py::make_tuple(range.from, range.to, range.happens));
  return py::make_tuple(found.first(), ranges);
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

/// Indices of outcomes of shape (samples, 2 + inputs): a row an input, each index with its bounds, the first
/// one first.
py::array_t<double> indices_of(
    const py::array_t<double, py::array::c_style | py::array::forcecast>& outcomes) {
  const auto values = outcomes.unchecked<2>();
  std::vector<SobolSample> samples;
  for (py::ssize_t row = 0; row < values.shape(0); ++row) {
    const double* first = values.data(row, 0);
    samples.push_back({first[0], first[1], {first + 2, first + values.shape(1)}});
  }
  const auto indices = sobol_indices(samples, static_cast<std::size_t>(values.shape(1) - 2));
  py::array_t<double> table({static_cast<py::ssize_t>(indices.size()), py::ssize_t{6}});
  double* cell = table.mutable_data();
  for (const SobolIndices& one : indices)
    for (const VarianceShare& share : {one.first, one.total})
      for (const double value : {share.value, share.lower, share.upper}) *cell++ = value;
  return table;
}

}  // namespace

void add_sweep(py::module_& core) {
  core.def("sweep_file", &sweep_file);
  core.def("sweep_made", &sweep_made);
  core.def("threshold", &threshold_made);
  core.def("fit_fragility", &fit);
  core.def("sobol_indices", &indices_of);
  core.def("wilson_bounds", [](std::size_t toppled, std::size_t runs) {
    const Bounds wilson = wilson_bounds(toppled, runs);
    return std::pair(wilson.lower, wilson.upper);
  });
}

}  // namespace rockstack::python
