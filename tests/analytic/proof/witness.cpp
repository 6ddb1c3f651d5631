#include "tests/analytic/proof/witness.hpp"

namespace rockstack::proof {
namespace {

Witness texts(const std::vector<Ball>& values) {
  Witness list = Witness::array();
  for (const Ball& value : values) list.push_back(exact_text(value));
  return list;
}

/// Ends of cells before a time, and that time.
std::vector<Ball> cover_up_to(const std::vector<Ball>& cover, const Ball& end) {
  std::vector<Ball> result;
  for (const Ball& cell : cover)
    if (positive(end - cell)) result.push_back(cell);
  result.push_back(end);
  return result;
}

}  // namespace

Witness step_witness(const Step& step, const std::vector<ZeroSearch>& searches, const Watched* first,
                     const Ball& time) {
  Witness guards = Witness::array();
  const Ball end = first ? upper(time) : step.length();
  for (std::size_t i = 0; i < searches.size(); ++i) {
    const Watched& watched = step.watched()[i];
    const Ball last = &watched == first ? lower(time) : end;
    guards.push_back({{"kind", name(watched.kind)},
                      {"interface", watched.interface + 1},
                      {"side", watched.side},
                      {"cover", texts(cover_up_to(searches[i].cover, last))}});
  }
  Witness witness{{"kind", "step"},
                  {"radius", exact_text(step.enclosure().radius)},
                  {"length", exact_text(step.length())},
                  {"terms", step.terms()},
                  {"angle_reach", texts(step.enclosure().angle_reach)},
                  {"rate_reach", texts(step.enclosure().rate_reach)},
                  {"guards", guards}};
  if (first)
    witness["event"] = {{"kind", name(first->kind)},
                        {"interface", first->interface + 1},
                        {"side", first->side},
                        {"interval", texts({lower(time), upper(time)})}};
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
  return {{"kind", "accumulation"},
          {"interface", interface + 1},
          {"duration", exact_text(box.duration)},
          {"speed", exact_text(box.speed)},
          {"reach", exact_text(box.reach)},
          {"angles", texts(box.angles)},
          {"rates", texts(box.rates)}};
}

}  // namespace rockstack::proof
