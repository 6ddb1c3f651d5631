#include "comparisons/ensemble/run_table.hpp"

#include <cmath>
#include <exception>
#include <optional>

#include "analytic/scene/messages/number_text.hpp"
#include "analytic/solve_batch.hpp"
#include "comparisons/ensemble/run_outcome.hpp"
#include "comparisons/results/csv_writer.hpp"

namespace rockstack {
namespace {

const std::vector<ColumnMeaning>& outcome_columns() {
  static const std::vector<ColumnMeaning> list{
      {"peak_ratio", "largest angle over slenderness, of the block where that is largest"},
      {"toppled", "number of the block that toppled, 0: none"},
      {"topple_time", "when it passed its toppling angle, s; the run ends there"},
      {"impacts", "number of impacts, with those that end chatter"},
      {"events", "number of openings, impacts and closures"},
      {"last_event_time", "time of the last event, s"},
      {"least_normal_force", "least normal force at any interface, N; negative: the stack would lift off"},
      {"force_friction", "largest friction coefficient needed between impacts"},
      {"least_normal_impulse", "least normal impulse of any impact, N s; negative: likewise"},
      {"impulse_friction", "largest friction coefficient needed by impacts"},
      {"onset", "mode in which motion begins: slide, rock, slide-rock or free flight; or rest"},
      {"motion",
       "all of the motion: topple or fall where it ends so; else rest, slide, rock, slide-rock or free "
       "flight"},
      {"status", "done or failed"},
      {"reason", "why a run failed"},
      {"slip", "largest slip left at the end at any interface, m; under law unilateral"},
      {"lift", "highest lift of any block off what is below it, m; likewise"}};
  return list;
}

std::size_t block_count(const Ensemble& ensemble) {
  return find(ensemble.base.root, "blocks")->children.size();
}

void add_outcome(CsvWriter& line, const RunOutcome& outcome) {
  const auto cell = [](bool there, double value) { return there ? number_text(value) : ""; };
  for (const double peak : outcome.peaks) line.add(number_text(peak));
  line.add(number_text(outcome.peak_ratio), outcome.toppled, cell(outcome.toppled > 0, outcome.topple_time),
           outcome.impacts, outcome.events, cell(outcome.events > 0, outcome.last_event_time));
  for (const Demand& demand : {outcome.force, outcome.impulse}) {
    const bool there = std::isfinite(demand.least_normal);
    line.add(cell(there, demand.least_normal), cell(there, demand.friction));
  }
  line.add(name(outcome.onset), name(outcome.motion), "done", "");
  for (const auto& length : {outcome.slip, outcome.lift})
    line.add(cell(length.has_value(), length.value_or(0)));
}

void add_failure(CsvWriter& line, std::size_t blocks, const std::string& reason) {
  const std::size_t status_to_lift = 4;
  const std::vector<std::string> no_cells(blocks + outcome_columns().size() - status_to_lift);
  line.add(no_cells, "failed", reason, "", "");
}

/// The lines of consecutive runs, whose scenes it makes one after the other.
class Lines {
 public:
  Lines(const Ensemble& ensemble, std::size_t first, std::size_t last, MotionLibrary& library)
      : ensemble_(ensemble), first_(first), library_(library), document_(ensemble.base) {
    lines_.resize(last - first);
  }

  /// The scene of the next run that has one; a run that has none says why in its line.
  std::optional<Scene> next_scene() {
    for (; begun_ < lines_.size(); ++begun_) {
      const std::vector<Value> values = values_of(ensemble_, first_ + begun_);
      CsvWriter& line = lines_[begun_];
      line.add(first_ + begun_);
      for (const Value& value : values) line.add(value.text);
      std::optional<Scene> scene;
      or_failure(line, [&] {
        for (std::size_t v = 0; v < values.size(); ++v)
          set_values(document_, ensemble_.variations[v], values[v]);
        scene = make_scene(document_, library_);
      });
      if (!scene) continue;
      of_scene_.push_back(begun_++);
      return scene;
    }
    return std::nullopt;
  }

  void take(const Solved& solved) {
    CsvWriter& line = lines_[of_scene_[solved.number]];
    or_failure(line, [&] {
      if (solved.failure) std::rethrow_exception(solved.failure);
      add_outcome(line, run_outcome(solved.scene, solved.history));
    });
  }

  std::string text() {
    std::string text;
    for (CsvWriter& line : lines_) {
      line.end_line();
      text += line.text();
    }
    return text;
  }

 private:
  template <class Part>
  void or_failure(CsvWriter& line, const Part& part) const {
    try {
      part();
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& error) {
      add_failure(line, block_count(ensemble_), error.what());
    }
  }

  const Ensemble& ensemble_;
  std::size_t first_;
  MotionLibrary& library_;
  SceneDocument document_;
  std::vector<CsvWriter> lines_;
  std::size_t begun_ = 0;
  std::vector<std::size_t> of_scene_;  ///< the line of each scene
};

}  // namespace

std::vector<ColumnMeaning> run_columns(const Ensemble& ensemble) {
  std::vector<ColumnMeaning> columns{{"run", "number of the run, from 0"}};
  for (const Variation& variation : ensemble.variations) {
    std::string meaning = "scene key";
    for (std::size_t k = 1; k < variation.keys.size(); ++k) meaning += ", also of " + variation.keys[k];
    columns.emplace_back(variation.name(), meaning);
  }
  for (std::size_t k = 1; k <= block_count(ensemble); ++k) {
    const std::string number = std::to_string(k);
    columns.emplace_back("peak_" + number, "largest absolute angle of block " + number + ", rad");
  }
  columns.insert(columns.end(), outcome_columns().begin(), outcome_columns().end());
  return columns;
}

std::string header_line(const Ensemble& ensemble) {
  CsvWriter csv;
  for (const auto& [name, meaning] : run_columns(ensemble)) csv.add(name);
  csv.end_line();
  return csv.text();
}

std::string run_lines(const Ensemble& ensemble, std::size_t first, std::size_t last, MotionLibrary& library) {
  Lines lines(ensemble, first, last, library);
  solve_batch([&] { return lines.next_scene(); }, run_options(ensemble.tolerance),
              [&](const Solved& solved) { lines.take(solved); });
  return lines.text();
}

}  // namespace rockstack
