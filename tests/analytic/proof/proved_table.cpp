#include "tests/analytic/proof/proved_table.hpp"

#include <algorithm>

namespace rockstack::proof {
namespace {

constexpr slong decimal_places = 30;
constexpr double last_of_chatter = 1e-6;  // s

/// Whether each event is in the table.
std::vector<bool> kept(const std::vector<ProvedEvent>& events) {
  std::vector<bool> result(events.size(), true);
  for (std::size_t last = 0; last < events.size(); ++last) {
    if (events[last].kind != EventKind::accumulation) continue;
    for (std::size_t i = last; i-- > 0;) {
      const ProvedEvent& event = events[i];
      if (event.kind != EventKind::impact || event.interface != events[last].interface ||
          approximate(events[last].time - event.time) > last_of_chatter)
        break;
      result[i] = false;
    }
  }
  return result;
}

std::string told(const ProvedEvent& event) {
  if (event.kind != EventKind::accumulation) return name(event.kind);
  const bool rests = std::all_of(event.to.begin(), event.to.end(), [](int side) { return side == 0; });
  return rests ? "rest" : "closure";
}

}  // namespace

void write_table(std::ostream& output, const Proof& proof) {
  const std::vector<bool> keeps = kept(proof.events);
  output << "event,interface,from,to,time_lower,time_upper";
  const std::size_t blocks = proof.events.empty() ? 0 : proof.events[0].angles.size();
  for (std::size_t k = 1; k <= blocks; ++k) output << ",angle_" << k << "_lower,angle_" << k << "_upper";
  output << '\n';
  for (std::size_t i = 0; i < proof.events.size(); ++i) {
    if (!keeps[i]) continue;
    const ProvedEvent& event = proof.events[i];
    output << told(event) << ',' << event.interface + 1 << ',' << letters(event.from) << ','
           << letters(event.to);
    const auto write_bounds = [&](const Ball& value) {
      const DecimalBounds bounds = decimal_bounds(value, decimal_places);
      output << ',' << bounds.lower << ',' << bounds.upper;
    };
    write_bounds(event.time);
    for (const Ball& angle : event.angles) write_bounds(angle);
    output << '\n';
  }
}

}  // namespace rockstack::proof
