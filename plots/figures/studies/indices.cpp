#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "plots/figures/figure.hpp"
#include "plots/figures/studies/sweep_facts.hpp"

// Which of the values that are drawn decides what comes out.

namespace rockstack::plots {
namespace {

// As those of solvers (plots/drawing/style), in an order that keeps neighbours apart.
constexpr std::array input_colours{"#0072B2", "#C04A00", "#117733", "#AA4499",
                                   "#806600", "#332288", "#882255", "#00695C"};

constexpr auto bounds_line = "with vectors heads size graph 0.004,90 lw 1.6 lc rgb '#1A1A1A'";

/// An input's indices over an outcome: value, lower and upper bound.
struct Bar {
  std::string outcome, input;
  double intensity = 0;  ///< NaN: over all runs
  std::array<double, 3> first{}, total{};
};

std::vector<Bar> read_bars(const fs::path& file) {
  std::vector<Bar> bars;
  for (CsvLine line(file); line.next();) {
    const auto share = [&](const std::string& name) {
      return std::array{line.value(name), line.value(name + "_lower"), line.value(name + "_upper")};
    };
    bars.push_back(
        {line.text("outcome"), line.text("key"), line.value("intensity"), share("first"), share("total")});
  }
  return bars;
}

/// What `of` gives of the bars, each once, in their order.
template <class Of>
auto different(const std::vector<Bar>& bars, Of of) {
  std::vector<std::decay_t<decltype(std::invoke(of, bars.front()))>> list;
  for (const Bar& bar : bars)
    if (std::ranges::find(list, std::invoke(of, bar)) == list.end()) list.push_back(std::invoke(of, bar));
  return list;
}

/// The inputs that are drawn: as many as there are colours, those with the largest total index anywhere.
std::vector<std::string> shown_inputs(const std::vector<Bar>& bars) {
  std::vector<std::string> inputs = different(bars, &Bar::input);
  const auto largest = [&](const std::string& input) {
    double total = 0;
    for (const Bar& bar : bars)
      if (bar.input == input && bar.total[0] > total) total = bar.total[0];
    return total;
  };
  if (inputs.size() <= input_colours.size()) return inputs;
  std::ranges::stable_sort(inputs, std::ranges::greater(), largest);
  inputs.resize(input_colours.size());
  return inputs;
}

/// Where a bar stands: that of its level, from 0, and beside the others there.
struct BarPlaces {
  std::vector<double> levels;
  std::size_t inputs = 0;

  double width() const { return 0.84 / static_cast<double>(inputs); }
  double of(std::size_t level, std::size_t input) const {
    const double middle = (static_cast<double>(inputs) - 1) / 2;
    return static_cast<double>(level) + (static_cast<double>(input) - middle) * width();
  }
};

/// An input's bars: wide and pale the total index, narrow the first-order one, with their bounds.
void add_input(Plots& plots, const std::vector<Bar>& bars, const BarPlaces& places, std::size_t input,
               const std::string& colour) {
  Numbers lines;
  for (const Bar& bar : bars) {
    if (std::isnan(bar.total[0])) continue;
    const auto level = std::ranges::find(places.levels, bar.intensity);
    const auto number =
        level == places.levels.end() ? 0 : static_cast<std::size_t>(level - places.levels.begin());
    const double place = places.of(number, input);
    lines.push_back(
        {place, bar.total[0], bar.total[1], bar.total[2], bar.first[0], bar.first[1], bar.first[2]});
  }
  const double width = places.width();
  plots.add(lines, {fmt::format("using 1:2:({}) with boxes fs solid 1 noborder fc rgb '{}'",
                                plain(0.9 * width), paler(colour, 0.4)),
                    fmt::format("using 1:5:({}) with boxes fs solid 1 noborder fc rgb '{}'",
                                plain(0.4 * width), colour),
                    fmt::format("using ($1+{}):3:(0):($4-$3) {}", plain(0.32 * width), bounds_line),
                    fmt::format("using 1:6:(0):($7-$6) {}", bounds_line)});
}

/// The numbers of the levels, as many as there is room for.
std::string level_tics(const std::vector<double>& levels) {
  constexpr std::size_t most = 16;
  const std::size_t stride = 1 + (levels.size() - 1) / most;
  std::vector<std::string> words;
  for (std::size_t i = 0; i < levels.size(); ++i)
    words.push_back(i % stride == 0 && !std::isnan(levels[i]) ? fmt::format("{:g}", levels[i]) : "");
  return fmt::format("set xtics ({}) scale 0\n", word_tics(words));
}

/// The range that shows all bounds, but of those far out a part.
std::string index_range(const std::vector<Bar>& bars) {
  double low = 0, high = 1;
  for (const Bar& bar : bars)
    for (const auto& share : {bar.first, bar.total}) {
      if (share[1] < low) low = share[1];
      if (share[2] > high) high = share[2];
    }
  return fmt::format("set yrange [{}:{}]\nset ytics 0.2\n", plain(std::max(low, -0.3) - 0.02),
                     plain(std::min(high, 1.4) + 0.02));
}

}  // namespace

Drawings indices(const FolderSubject& subject) {
  const SweepFacts facts = sweep_facts(subject.folder);
  const std::vector<Bar> bars = read_bars(subject.folder / "indices.csv");
  const std::vector<std::string> inputs = shown_inputs(bars), outcomes = different(bars, &Bar::outcome);
  BarPlaces places{different(bars, &Bar::intensity), inputs.size()};
  if (std::ranges::any_of(places.levels, [](double level) { return std::isnan(level); }))
    places.levels = {NAN};
  Legend legend;
  for (std::size_t i = 0; i < inputs.size(); ++i)
    legend.emplace_back(fmt::format("with boxes fs solid 1 noborder fc rgb '{}'", input_colours.at(i)),
                        inputs[i]);
  Sheet sheet = subject.sheet(facts.title, legend, facts.decisive);
  for (const std::string& outcome : outcomes) {
    Plots plots(sheet, "indices_" + outcome);
    const auto of = [&](const std::string& input) {
      std::vector<Bar> list = bars;
      std::erase_if(list, [&](const Bar& bar) { return bar.outcome != outcome || bar.input != input; });
      return list;
    };
    for (std::size_t i = 0; i < inputs.size(); ++i)
      add_input(plots, of(inputs[i]), places, i, input_colours.at(i));
    const std::string across =
        std::isnan(places.levels.front()) || outcome != outcomes.back() ? "" : facts.intensity;
    sheet.panel(
        outcomes.size() > 1 ? 300 : 420, 46,
        fmt::format("set xrange [-0.5:{}]\n{}{}set xlabel {} noenhanced\nset ylabel {} noenhanced\n",
                    plain(static_cast<double>(places.levels.size()) - 0.5), level_tics(places.levels),
                    index_range(bars), in_quotes(across), in_quotes("share of the variance of " + outcome)) +
            grid_lines,
        plots.list());
  }
  const std::size_t all = different(bars, &Bar::input).size();
  std::string note = "dark: a key alone (first order); pale: with all others (total); lines: bounds of 95 %";
  if (all > inputs.size())
    note +=
        fmt::format("; {} more with smaller indices are in indices.csv", counted(all - inputs.size(), "key"));
  sheet.note(note);
  return {{"", sheet.finish()}};
}

}  // namespace rockstack::plots
