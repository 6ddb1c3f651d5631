#include <fmt/core.h>

#include "plots/data/run_files.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/drawing/style.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

struct TopplingShare {
  Run run;
  Share share;
};

std::vector<TopplingShare> answers_of(const Comparison& comparison, const std::string& scene) {
  std::vector<TopplingShare> answers;
  const std::vector<Run> runs = perturbed_runs(comparison, scene);
  for (const Run& run : runs)
    if (const Share share = toppled_share(*tallies_of(run), *tallies_of(runs.front())); share.of > 0)
      answers.push_back({run, share});
  return answers;
}

std::string words_of(const TopplingShare& answer) {
  return answer.run.exact() ? fmt::format("{} of {}", answer.share.toppled, answer.share.of)
                            : fmt::format("{} of {}; {} as the exact solution says", answer.share.toppled,
                                          answer.share.of, answer.share.agree);
}

}  // namespace

Drawing toppling(const SceneSubject& subject) {
  const Comparison& comparison = subject.comparison;
  const ComparedScene& scene = subject.scene;
  const std::vector<TopplingShare> answers = answers_of(comparison, scene.name);
  if (answers.empty() || !answers.front().run.exact())
    return subject.nothing("No exact answers over perturbed scenes to compare with.");
  const Share& exact = answers.front().share;
  Sheet sheet = subject.sheet({}, fmt::format("By the exact solution {} of {}", exact.toppled, exact.of));
  std::string settings = fmt::format(
      "set object rectangle from {}, graph 0 to {}, graph 1 fillcolor rgb '#E6E6E6' fillstyle solid noborder behind\n",
      plain(exact.bounds().lower), plain(exact.bounds().upper));
  std::vector<std::string> plots;
  std::string tics;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const Share& share = answers[i].share;
    sheet.data(fmt::format("$share_{} << END\n{} {} {} {}\nEND\n", i, plain(share.value()), i,
                           plain(share.bounds().lower), plain(share.bounds().upper)));
    plots.push_back(fmt::format("$share_{} using 1:2:3:4 with xerrorbars lw 2 lc rgb '{}' pt 0 notitle", i,
                                style_of(answers[i].run).colour));
    plots.push_back(fmt::format("$share_{} using 1:2 {} notitle", i, mark_style(answers[i].run, 1.8)));
    tics += fmt::format("{}{} {}", i > 0 ? ", " : "", in_quotes(run_label(answers[i].run)), i);
    const bool right = share.value() > 0.5;  // words stay inside the panel
    settings +=
        fmt::format("set label {} noenhanced at {}, {} {} offset 0,0.9 font ',11' front\n",
                    in_quotes(words_of(answers[i])),
                    plain(right ? share.bounds().upper : share.bounds().lower), i, right ? "right" : "left");
  }
  constexpr double row = 52, left = 0.4;
  sheet.row(row * static_cast<double>(answers.size()), 0,
            {{settings + fmt::format("set xrange [0:1]\nset yrange [{}:-0.7]\nset ytics ({}) noenhanced\n"
                                     "set grid x lt 1 dt solid lw 1 lc rgb '#E4E4E4'\n"
                                     "set xlabel 'share of scenes that topple'\n",
                                     static_cast<double>(answers.size()) - 0.5, tics),
              plots}},
            1, left);
  sheet.note("bars: 95 % bounds of each share; grey: those of the exact one", "#000000");
  return sheet.finish();
}

}  // namespace rockstack::plots
