#include "plots/data/law_counts.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace rockstack::plots {
namespace {

/// The entry of that name, added at the end where there is none.
template <class Entry>
Entry& entry_of(std::vector<Entry>& list, const std::string& name) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const Entry& entry) { return entry.of == name; });
  if (found != list.end()) return *found;
  list.emplace_back();
  list.back().of = name;
  return list.back();
}

void add(LawTally& tally, const LawRun& one) {
  if (!one.run.done()) {
    ++tally.failed;
    return;
  }
  ++(one.follows == "consistent" ? tally.consistent : one.follows == "paper" ? tally.paper : tally.neither);
  tally.from_paper.push_back(one.from_paper);
  tally.from_consistent.push_back(one.from_consistent);
  if (tally.farthest == nullptr || one.from_consistent > tally.farthest->from_consistent)
    tally.farthest = &one;
}

}  // namespace

std::vector<LawShare> shares_by(const std::vector<LawCell>& cells,
                                const std::function<std::string(const LawCell&)>& name) {
  std::vector<LawShare> list;
  for (const LawCell& cell : cells) {
    LawShare& share = entry_of(list, name(cell));
    share.impacts += cell.impacts;
    share.differ += cell.differ;
    share.none += cell.none;
  }
  return list;
}

std::string aspect_ratio_range(const LawCell& cell) {
  return fmt::format("{:.3g} to {:.3g}", cell.aspect_ratio_from, cell.aspect_ratio_to);
}

std::string mass_ratio_range(const LawCell& cell) {
  return fmt::format("{:.3g} to {:.3g}", cell.mass_ratio_from, cell.mass_ratio_to);
}

std::vector<LawTally> tallies_by(const std::vector<LawRun>& runs,
                                 const std::function<std::string(const LawRun&)>& name) {
  std::vector<LawTally> list;
  for (const LawRun& one : runs) add(entry_of(list, name(one)), one);
  return list;
}

}  // namespace rockstack::plots
