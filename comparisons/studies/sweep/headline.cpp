#include <fmt/format.h>

#include <numeric>

#include "comparisons/measures/results/long_table.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/studies/sweep/sweep.hpp"

// What a sweep comes to, in sentences: the only place where they are made.

namespace rockstack {
namespace {

using Sentences = std::vector<std::string>;

/// `open`: whether runs count as standing that a longer duration may topple.
void add_fit(const std::filesystem::path& file, const std::string& axis, bool open, Sentences& sentences) {
  if (!std::filesystem::exists(file)) return;
  const auto fit = read_columns(file, {"median", "beta"});
  sentences.push_back(
      fit[0].empty()
          ? "No lognormal curve fits: one intensity parts the runs that topple from those that do not, or toppling "
            "does not grow with intensity."
          : fmt::format(
                "Half of the runs topple at {}{}, by the fitted lognormal curve; its logarithmic spread β is "
                "{:.3g}.",
                value_on(axis, fit[0][0]), open ? " or less" : "", fit[1][0]));
}

void add_counts(const std::filesystem::path& folder, const CutShort& cut, Sentences& sentences) {
  std::size_t done = 0, fell = 0, failed = 0, falling = 0;
  for (TableRows row(folder / "runs.csv", {"status", "toppled", "falling", "ground_left"}); row.next();) {
    const bool is_done = row.text(0) == "done";
    ++(is_done ? done : failed);
    if (!is_done) continue;
    fell += row.value(1) != 0;
    falling += row.value(2) != 0 && !(row.value(3) > 0);
  }
  if (done > 0)
    sentences.push_back(fmt::format("Of {} {} topple{}.", counted(done, "run"), fell, fell == 1 ? "s" : ""));
  if (cut.runs > 0)
    sentences.push_back(
        fmt::format("{} more {} while the ground moves on, for up to {:.3g} s, and {} as standing: a longer "
                    "duration decides.",
                    cut.runs, cut.runs == 1 ? "ends" : "end", cut.most, cut.runs == 1 ? "counts" : "count"));
  if (falling > 0)
    sentences.push_back(
        fmt::format("{} more {} past balance at the end, and count as standing: a longer duration decides.",
                    falling, falling == 1 ? "is" : "are"));
  if (failed > 0)
    sentences.push_back(
        fmt::format("{} failed; {} says why.", failed, failures_file(folder).filename().string()));
}

/// The sum of each column of a file, whole numbers; none where there is no such file.
std::vector<double> sums(const std::filesystem::path& file, const std::vector<std::string>& names) {
  std::vector<double> list;
  if (!std::filesystem::exists(file)) return list;
  for (const std::vector<double>& values : read_columns(file, names))
    list.push_back(std::accumulate(values.begin(), values.end(), 0.0));
  return list;
}

void add_maps(const std::filesystem::path& folder, Sentences& sentences) {
  if (const auto counts = sums(folder / "overturning.csv",
                               {"rest", "rocking", "toppled_after_impact", "toppled_without_impact"});
      !counts.empty())
    sentences.push_back(
        fmt::format("{} stay at rest, {} rock and stand, {} topple after an impact, {} without one.",
                    counts[0], counts[1], counts[2], counts[3]));
  if (const auto counts =
          sums(folder / "modes.csv", {"rest", "slide", "rock", "slide_rock", "free_flight", "fall"});
      !counts.empty())
    sentences.push_back(fmt::format("{} rest, {} slide, {} rock, {} do both, {} lift off; {} fall off.",
                                    counts[0], counts[1], counts[2], counts[3], counts[4], counts[5]));
}

}  // namespace

CutShort cut_short(const std::filesystem::path& folder) {
  CutShort cut;
  for (TableRows row(folder / "runs.csv", {"ground_left"}); row.next();)
    if (const double left = row.value(0); left > 0) {
      ++cut.runs;
      cut.most = std::max(cut.most, left);
    }
  return cut;
}

std::vector<std::string> sweep_headline(const std::filesystem::path& folder, const SummaryKeys& keys) {
  Sentences sentences;
  const CutShort cut = cut_short(folder);
  add_fit(folder / "fragility-fit.csv", axis_title(keys.intensity), cut.runs > 0, sentences);
  add_counts(folder, cut, sentences);
  add_maps(folder, sentences);
  return sentences;
}

}  // namespace rockstack
