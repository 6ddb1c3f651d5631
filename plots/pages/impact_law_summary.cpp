#include "plots/pages/sections.hpp"

namespace rockstack::plots {
namespace {

/// Entries in falling order of a value.
template <class Entry, class Value>
std::vector<Entry> ranked(std::vector<Entry> entries, const Value& value) {
  std::ranges::stable_sort(entries, std::greater(), value);
  return entries;
}

/// All parts together. Points into them.
template <class Together, class Part>
Together sum_of(const std::vector<Part>& parts) {
  Together all;
  for (const Part& part : parts) all.add(part);
  return all;
}

std::string worst_kinds(const std::vector<LawShare>& kinds) {
  constexpr std::size_t most = 3;
  std::vector<std::string> words;
  for (const LawShare& kind : ranked(kinds, &LawShare::differ_percent))
    if (kind.differ > 0 && words.size() < most)
      words.push_back(fmt::format("{} ({:.1f} %)", kind.of, kind.differ_percent()));
  return joined(words);
}

/// Along either axis, "most from 0.25 to 0.386 (41.2 %), …".
std::string extremes(const std::vector<LawCell>& cells, double LawCell::*from, double LawCell::*to) {
  const auto shares = together_by<LawShare>(
      cells, [&](const LawCell& cell) { return fmt::format("{:.3g} to {:.3g}", cell.*from, cell.*to); });
  const std::vector<LawShare> order = ranked(shares, &LawShare::differ_percent);
  return fmt::format("most from {} ({:.1f} %), least from {} ({:.1f} %)", order.front().of,
                     order.front().differ_percent(), order.back().of, order.back().differ_percent());
}

void add_stacks(int blocks, const std::vector<LawCell>& cells, std::vector<std::string>& sentences) {
  const LawShare all = sum_of<LawShare>(cells);
  const auto kinds = together_by<LawShare>(cells, [](const LawCell& cell) { return cell.kind; });
  const auto differing = std::ranges::count_if(kinds, [](const LawShare& kind) { return kind.differ > 0; });
  const std::string judged = fmt::format("Stacks of {} blocks: {:.0f} impacts of {} were judged. ", blocks,
                                         all.impacts, counted(kinds.size(), "kind"));
  if (differing == 0) {
    sentences.push_back(judged + "The laws have the same pattern after every one.");
  } else {
    sentences.push_back(judged + fmt::format("The laws have different patterns after {:.1f} % of them, in {} "
                                             "of these kinds: {}{}.",
                                             all.differ_percent(), differing,
                                             differing > 3 ? "most often after " : "", worst_kinds(kinds)));
    std::vector<LawCell> where = cells;  // of kinds after which the laws differ at all
    std::erase_if(where, [&](const LawCell& cell) {
      return std::ranges::any_of(
          kinds, [&](const LawShare& kind) { return kind.of == cell.kind && !(kind.differ > 0); });
    });
    sentences.push_back(fmt::format(
        "The share within {} by height over width of the top block: {}; by its mass over that of the block "
        "below: {}.",
        differing == 1 ? "this kind" : "these kinds",
        extremes(where, &LawCell::aspect_ratio_from, &LawCell::aspect_ratio_to),
        extremes(where, &LawCell::mass_ratio_from, &LawCell::mass_ratio_to)));
  }
  if (all.none > 0)
    sentences.push_back(
        fmt::format("After {:.1f} % no pattern is consistent; law consistent then takes that of law paper.",
                    all.none_percent()));
}

/// "a (22 of 24 runs), b (1 of 24 runs)" for the states where `count` is largest.
std::string states_by(const LawResults& results, int LawTally::*count) {
  constexpr std::size_t most = 3;
  std::vector<std::string> words;
  const auto states = together_by<LawTally>(results.runs, [](const LawRun& one) { return one.run.scene; });
  for (const LawTally& state : ranked(states, count))
    if (state.*count > 0 && words.size() < most)
      words.push_back(fmt::format("{} ({} of {} runs)", state.of, state.*count, state.runs()));
  return joined(words);
}

void add_patterns(const LawResults& results, const LawTally& all, std::vector<std::string>& sentences) {
  sentences.push_back(fmt::format(
      "Engines ran into {} where the laws clearly differ, in {}: {} end in the pattern of law consistent, {} "
      "in that of law paper, {} in neither, and {} failed.",
      counted(results.states, "state"), counted(results.runs.size(), "run"), all.consistent, all.paper,
      all.neither, all.failed));
  std::vector<std::string> steps;
  for (const LawTally& step : together_by<LawTally>(
           results.runs, [](const LawRun& one) { return duration_text(value_of(one.run.dt)); }))
    steps.push_back(fmt::format("{} of {} with steps of {}", step.consistent, step.runs(), step.of));
  sentences.push_back(fmt::format("Law consistent's pattern by time step: {}.", joined(steps)));
  const auto solvers =
      ranked(together_by<LawTally>(results.runs, [](const LawRun& one) { return line_label(one.run); }),
             [](const LawTally& tally) { return static_cast<double>(tally.consistent) / tally.runs(); });
  sentences.push_back(fmt::format("By solver: most often {} ({} of {}), least often {} ({} of {}).",
                                  solvers.front().of, solvers.front().consistent, solvers.front().runs(),
                                  solvers.back().of, solvers.back().consistent, solvers.back().runs()));
  if (all.paper > 0)
    sentences.push_back(
        fmt::format("Law paper's pattern is taken in {}.", states_by(results, &LawTally::paper)));
  if (all.neither > 0)
    sentences.push_back(
        fmt::format("Neither law's pattern is taken most in {}.", states_by(results, &LawTally::neither)));
}

void add_velocities(const LawResults& results, const LawTally& all, std::vector<std::string>& sentences) {
  const auto nearer = std::ranges::count_if(
      results.runs, [](const LawRun& one) { return one.from_consistent < one.from_paper; });
  sentences.push_back(fmt::format(
      "The angular velocities after the impact are nearer to law consistent's in {} of {} that came to their "
      "end. Half of them are within {:.2g} of the largest relative one before the impact from law "
      "consistent's, and within {:.2g} from law paper's.",
      nearer, counted(all.from_consistent.size(), "run"), median(all.from_consistent),
      median(all.from_paper)));
  sentences.push_back(fmt::format("Farthest from law consistent is {}, by {:.3g} times that velocity, in {}.",
                                  run_phrase(all.farthest->run), all.farthest->from_consistent,
                                  all.farthest->run.scene));
}

}  // namespace

std::vector<std::string> law_answer(const LawResults& results) {
  std::vector<std::string> sentences;
  if (!results.runs.empty()) {
    const LawTally all = sum_of<LawTally>(results.runs);
    sentences.push_back(
        fmt::format("Where the laws differ, engines take the pattern of law consistent in {} of {}, and that "
                    "of law paper in {}.",
                    all.consistent, counted(results.runs.size(), "run"), all.paper));
  }
  if (!results.cells.empty())
    sentences.push_back(fmt::format("The laws differ after {:.1f} % of the impacts of random stacks.",
                                    sum_of<LawShare>(results.cells).differ_percent()));
  return sentences;
}

std::vector<std::string> law_summary(const LawResults& results) {
  std::map<int, std::vector<LawCell>> by_blocks;
  for (const LawCell& cell : results.cells) by_blocks[cell.blocks].push_back(cell);
  std::vector<std::string> sentences;
  for (const auto& [blocks, cells] : by_blocks) add_stacks(blocks, cells, sentences);
  return sentences;
}

std::vector<std::string> engine_summary(const LawResults& results) {
  std::vector<std::string> sentences;
  if (results.runs.empty()) {
    sentences.emplace_back("No engine was asked.");
  } else {
    const LawTally all = sum_of<LawTally>(results.runs);
    add_patterns(results, all, sentences);
    if (all.farthest != nullptr) add_velocities(results, all, sentences);
  }
  if (!results.left_out.empty())
    sentences.push_back(fmt::format("This build leaves out {}.", joined(results.left_out)));
  return sentences;
}

}  // namespace rockstack::plots
