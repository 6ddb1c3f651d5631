#include "comparisons/measures/results/csv.hpp"
#include "plots/data/run_files.hpp"
#include "plots/figures/figure.hpp"

// The motion of a scene for print: a panel for each quantity over time that was asked for.

namespace rockstack::plots {
namespace {

constexpr double metre = 1e3;  // mm

/// What can be drawn over time: of each block, or where `of_block` is not set once.
struct TimedQuantity {
  const char *name, *other;  ///< and as keyboards have it
  const char* unit;          ///< empty: that of angles; "/s": that of angles a second
  double scale = 1;          ///< from SI units
  std::vector<double> History::*rows = nullptr;
  bool letter = true, of_block = true;
};

constexpr auto difference_name = "Δθ", ground_name = "ground";
constexpr std::array timed_quantities{
    TimedQuantity{"θ", "theta", "", 1, &History::angles},
    TimedQuantity{"ω", "omega", "/s", 1, &History::velocities},
    TimedQuantity{difference_name, "dtheta", ""},
    TimedQuantity{"slip", "slip", "mm", metre, &History::slips, false},
    TimedQuantity{"gap", "gap", "mm", metre, &History::gaps, false},
    TimedQuantity{ground_name, ground_name, "m/s²", 1, nullptr, false, false}};

/// A panel with a curve of each run that has one.
struct PrintPanel {
  const TimedQuantity* quantity;
  int block = 0;  ///< from 0
  std::vector<Curve> curves = {};
  Extent extent = {};
  std::string unit = {};

  std::string name() const { return quantity->name + (quantity->of_block ? std::to_string(block + 1) : ""); }
  std::string words() const {
    const std::string number = quantity->letter ? subscript(block + 1) : fmt::format(" {}", block + 1);
    return fmt::format("{}{} ({})", quantity->name, quantity->of_block ? number : "", unit);
  }
};

/// The samples of a run, or of the ground, in SI units; none where there are none.
Curve timed_samples(const Run& run, const ComparedScene& scene, const PrintPanel& panel) {
  const auto from_file = [&](const fs::path& file, const std::string& column) {
    if (!fs::exists(file)) return Curve{};
    auto columns = read_columns(file, {"time", column});
    return Curve{std::move(columns[0]), std::move(columns[1])};
  };
  if (panel.quantity->name == std::string_view(ground_name))
    return run.exact() && !scene.ground_motion.empty() ? from_file(scene.ground_motion, "horizontal")
                                                       : Curve{};
  if (panel.quantity->rows == nullptr)
    return run.exact() ? Curve{}
                       : from_file(run.shown_folder() / "difference.csv",
                                   fmt::format("difference_{}", panel.block + 1));
  const auto history = history_of(run);
  if (((*history).*panel.quantity->rows).empty()) return {};
  return {history->times, column_of(*history, panel.quantity->rows, panel.block)};
}

std::vector<PrintPanel> panels_with_curves(const SceneSubject& subject, const std::vector<Run>& runs) {
  std::vector<PrintPanel> panels;
  for (const TimedQuantity& quantity : timed_quantities)
    for (int block = 0; block < (quantity.of_block ? subject.scene.block_count() : 1); ++block) {
      PrintPanel panel{&quantity, block};
      for (const Run& run : runs) panel.curves.push_back(timed_samples(run, subject.scene, panel));
      if (std::ranges::any_of(panel.curves, [](const Curve& curve) { return curve.size() > 0; }))
        panels.push_back(std::move(panel));
    }
  return panels;
}

/// Those asked for, in their order: "θ2", or "θ" for all blocks.
std::vector<PrintPanel> chosen_panels(const SceneSubject& subject, const std::vector<PrintPanel>& all) {
  const std::vector<std::string> asked =
      subject.print->panels.empty() ? std::vector<std::string>{"θ"} : subject.print->panels;
  std::vector<PrintPanel> chosen;
  for (const std::string& name : asked) {
    const std::size_t before = chosen.size();
    for (const PrintPanel& panel : all) {
      const std::string number = std::to_string(panel.block + 1);
      for (const std::string stem : {panel.quantity->name, panel.quantity->other})
        if (name == stem || (panel.quantity->of_block && name == stem + number)) {
          chosen.push_back(panel);
          break;
        }
    }
    if (chosen.size() == before)
      throw InputError(fmt::format("panels = \"{}\": must be among {}, which {} has", one_line(name),
                                   joined_texts(
                                       all, [](const PrintPanel& one) { return one.name(); }, ", "),
                                   subject.scene.title));
  }
  return chosen;
}

/// Leaves out runs that tell nothing of the panels, variants that lie on the exact motion, and engines beyond
/// those that one panel bears.
std::vector<std::string> choose_runs(std::vector<Run>& runs, std::vector<PrintPanel>& panels) {
  std::vector<std::vector<Curve>*> curves;
  curves.reserve(panels.size());
  for (PrintPanel& panel : panels) curves.push_back(&panel.curves);
  std::vector<std::string> left_out = mapped(take_out_hidden(runs, curves), [](const std::string& label) {
    return label + ": lies on the exact motion";
  });
  const auto leave_out = [&](std::size_t run, const std::string& reason) {
    left_out.push_back(run_label(runs[run]) + ": " + reason);
    const auto at = static_cast<std::ptrdiff_t>(run);
    runs.erase(runs.begin() + at);
    for (std::vector<Curve>* of_panel : curves) of_panel->erase(of_panel->begin() + at);
  };
  for (std::size_t i = runs.size(); i-- > 1;)
    if (std::ranges::all_of(curves, [&](const auto* of_panel) { return (*of_panel)[i].size() == 0; }))
      leave_out(i, "has none of these panels");
  while (are_many(runs)) {
    const auto error = [](const Run& run) { return run.exact() ? -1 : run.error.value_or(HUGE_VAL); };
    const auto worst = std::ranges::max_element(runs, {}, error) - runs.begin();
    leave_out(static_cast<std::size_t>(worst),
              fmt::format("{} are nearer to the exact motion, a panel bears no more", most_series));
  }
  return left_out;
}

/// Cuts and scales a panel's curves to what is drawn.
void prepare(PrintPanel& panel, const SceneSubject& subject, const std::vector<Run>& runs,
             const TimeAxis& axis, std::size_t bins) {
  for (Curve& curve : panel.curves)
    if (curve.size() > 0) curve = thin(curve, axis, bins);
  const std::string own = panel.quantity->unit;
  AngleUnit unit{own.c_str(), panel.quantity->scale};
  if (own.empty() || own == "/s") {
    double largest = 0;
    for (const Curve& curve : panel.curves) largest = std::max(largest, curve.largest());
    unit = subject.unit(largest);
    panel.unit = unit.name + own;
  } else {
    panel.unit = own;
  }
  scale(panel.curves, unit.scale);
  panel.extent = extent_of(runs, panel.curves, 2, 1e-9);
}

/// The panel with its place in the figure; the ground's curve is no run's.
GridPanel grid_panel(Sheet& sheet, PrintPanel panel, const TimeAxis& axis, std::size_t number) {
  const Extent up = panel.extent;
  const auto axes = [=](double width, double height) {
    return time_range(axis) + linear_tics("x", axis.begin, axis.end, width) +
           linear_range("y", up.low, up.high, height) + grid_lines;
  };
  const std::string words = panel.words(), stem = fmt::format("printed_{}", number);
  GridPanel grid{{"time (s)", words, words, true, axes}, up, std::move(panel.curves), stem};
  if (!panel.quantity->of_block) {
    const Curve ground = std::exchange(grid.curves, {}).front();
    sheet.data(data_block(stem, ground));
    sheet.tell({"time (s)", words, false, {{ground_name, "#1A1A1A", ground}}});
    grid.panel.under = {plot_of(stem, "with lines lw 1.5 lc rgb '#1A1A1A'")};
  } else if (grid.curves.front().size() > 0 && panel.quantity->rows != nullptr) {
    grid.panel.over = {exact_core(stem + "_0")};
  }
  return grid;
}

}  // namespace

Drawing printed_motion(const SceneSubject& subject) {
  std::vector<Run> runs =
      all_runs(subject.scene.alone ? RunSelection{done_runs(subject.comparison, subject.scene.name), {}}
                                   : shown_runs(subject.comparison, subject.scene.name));
  std::vector<PrintPanel> panels = chosen_panels(subject, panels_with_curves(subject, runs));
  const std::vector<std::string> left_out = choose_runs(runs, panels);
  const TimeAxis axis = subject.time_axis(runs);
  for (PrintPanel& panel : panels) prepare(panel, subject, runs, axis, bins_for(panels.size() * runs.size()));
  Legend legend = legend_of(runs, curve_style);
  explain_shade(axis, legend);
  Sheet sheet = subject.sheet(legend, "");
  std::vector<GridPanel> grid;
  grid.reserve(panels.size());
  for (PrintPanel& panel : panels) grid.push_back(grid_panel(sheet, std::move(panel), axis, grid.size()));
  add_grid(sheet, std::move(grid), runs);
  sheet.note(marks_note(runs));
  Drawing drawing = sheet.finish();
  drawing.left_out = left_out;
  return drawing;
}

}  // namespace rockstack::plots
