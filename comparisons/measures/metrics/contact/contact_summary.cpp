#include "comparisons/measures/metrics/contact/contact_summary.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace rockstack {

std::vector<InterfaceSummary> contact_summary(const History& history) {
  if (history.slips.empty()) return {};
  const auto blocks = static_cast<std::size_t>(history.blocks);
  std::vector<InterfaceSummary> list(blocks);
  for (std::size_t i = 0; i < history.slips.size(); ++i) {
    InterfaceSummary& one = list[i % blocks];
    one.final_slip = history.slips[i];
    one.largest_slip = std::max(one.largest_slip, std::abs(history.slips[i]));
    if (!history.gaps.empty() && std::isfinite(history.gaps[i]))
      one.highest_lift = std::max(one.highest_lift, history.gaps[i]);
  }
  for (const Event& event : history.events) {
    for (std::size_t k = 0; k < blocks; ++k) {
      list[k].slips += event.from.slides[k] == 0 && event.to.slides[k] != 0;
      list[k].lift_offs += event.from.contacts[k] != Contact::apart && event.to.contacts[k] == Contact::apart;
    }
  }
  return list;
}

nlohmann::ordered_json contact_json(const History& history) {
  auto json = nlohmann::ordered_json::array();
  int interface = 0;
  for (const InterfaceSummary& one : contact_summary(history)) {
    json.push_back({{"interface", ++interface},
                    {"final_slip", one.final_slip},
                    {"largest_slip", one.largest_slip},
                    {"highest_lift", one.highest_lift},
                    {"slips", one.slips},
                    {"lift_offs", one.lift_offs}});
  }
  return json;
}

}  // namespace rockstack
