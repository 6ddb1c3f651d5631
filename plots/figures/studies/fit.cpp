#include "comparisons/measures/results/csv.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

constexpr auto motion_style = "with lines lw 2 lc rgb '#0B4F8A'";

}  // namespace

/// What was measured and the fitted motion, and under both what they differ by, of each column.
Drawings fit(const FolderSubject& subject) {
  const Json json = read_json(subject.folder / "fit.json");
  const std::string unit = json.at("unit");
  Sheet sheet = subject.figure.sheet(
      json.at("title"), {{reading_style, "measured"}, {motion_style, "fitted"}}, json.at("meaning").front());
  const double horizon = json.at("horizon");
  int panels = 0;
  for (const std::string column : json.at("columns")) {
    const auto read =
        read_columns(subject.folder / "fit.csv", {"time", "measured_" + column, "fitted_" + column});
    Numbers both, off;
    for (std::size_t i = 0; i < read[0].size(); ++i) {
      if (std::isnan(read[1][i])) continue;
      both.push_back({read[0][i], read[1][i], read[2][i]});
      off.push_back({read[0][i], read[2][i] - read[1][i]});
    }
    const std::string range =
        fmt::format("set xrange [0:{0}]\nset arrow from {1}, graph 0 to {1}, graph 1 nohead dt 2\n",
                    plain(read[0].back()), plain(horizon));
    const std::string number = std::to_string(++panels);
    Plots motion(sheet, "motion_" + number), residual(sheet, "residual_" + number);
    motion.add(both, {fmt::format("using 1:2 {}", reading_style), fmt::format("using 1:3 {}", motion_style)});
    residual.add(off, {fmt::format("using 1:2 {}", reading_style)});
    sheet.panel(
        300, 16,
        range + without_horizontal_labels() +
            fmt::format("set ylabel {} offset 0.5\n", in_quotes(fmt::format("{} ({})", column, unit))),
        motion.list());
    sheet.panel(150, 16, range + time_numbers + fmt::format("set ylabel 'residual ({})' offset 0.5\n", unit),
                residual.list());
  }
  return {{"", sheet.finish()}};
}

}  // namespace rockstack::plots
