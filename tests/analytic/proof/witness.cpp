#include "tests/analytic/proof/witness.hpp"

namespace rockstack::proof {
namespace {

Witness texts(const std::vector<Ball>& values) {
  Witness list = Witness::array();
  for (const Ball& value : values) list.push_back(exact_text(value));
  return list;
}

/// Ends of cells between 0 and a time.
std::vector<Ball> inner_ends(const std::vector<Ball>& cover, const Ball& end) {
  std::vector<Ball> result;
  for (const Ball& cell : cover)
    if (positive(cell) && positive(end - cell)) result.push_back(cell);
  return result;
}

Witness identity(const Watched& watched) {
  return {{"kind", name(watched.kind)}, {"interface", watched.interface + 1}, {"side", watched.side}};
}

/// A disc, and cells up to the end, or up to another end of one guard.
Witness smooth_witness(const Step& step, const std::vector<ZeroSearch>& searches, const Ball& end,
                       const Watched* first, const Ball& end_of_first) {
  Witness cells = Witness::array();
  for (std::size_t i = 0; i < searches.size(); ++i) {
    const Watched& watched = step.watched()[i];
    const auto ends = inner_ends(searches[i].cover, &watched == first ? end_of_first : end);
    if (ends.empty()) continue;
    cells.push_back(identity(watched));
    cells.back()["ends"] = texts(ends);
  }
  return {{"kind", "step"},
          {"radius", exact_text(step.enclosure().radius)},
          {"angle_reach", texts(step.enclosure().angle_reach)},
          {"rate_reach", texts(step.enclosure().rate_reach)},
          {"cells", cells}};
}

}  // namespace

Witness step_witness(const Step& step, const std::vector<ZeroSearch>& searches, bool ends_piece) {
  Witness witness = smooth_witness(step, searches, step.length(), nullptr, {});
  if (!ends_piece) witness["length"] = exact_text(step.length());
  return witness;
}

Witness event_witness(const Step& step, const std::vector<ZeroSearch>& searches, const Watched& first,
                      const Ball& time) {
  Witness witness = smooth_witness(step, searches, upper(time), &first, lower(time));
  witness["event"] = identity(first);
  witness["event"]["interval"] = texts({lower(time), upper(time)});
  return witness;
}

Witness decision_witness(const char* kind, std::size_t interface, const Decision& decision) {
  Witness tried = Witness::array();
  for (const Trial& trial : decision.tried)
    tried.push_back({{"pattern", letters(trial.pattern)},
                     {"violates", trial.violated->name},
                     {"interface", trial.violated->interface + 1}});
  return {
      {"kind", kind}, {"interface", interface + 1}, {"pattern", letters(decision.pattern)}, {"tried", tried}};
}

Witness accumulation_witness(std::size_t interface, const Accumulation& accumulation) {
  const Box& box = accumulation.box;
  Witness impacts = Witness::array();
  for (const Decision& decision : accumulation.impacts)
    impacts.push_back(decision_witness("impact", interface, decision));
  return {{"kind", "accumulation"},
          {"interface", interface + 1},
          {"duration", exact_text(box.duration)},
          {"speed", exact_text(box.speed)},
          {"reach", exact_text(box.reach)},
          {"angles", texts(box.angles)},
          {"rates", texts(box.rates)},
          {"impacts", impacts}};
}

}  // namespace rockstack::proof
