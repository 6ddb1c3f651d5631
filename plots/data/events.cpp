#include "plots/data/events.hpp"

#include <algorithm>

namespace rockstack::plots {

std::vector<PatternSpan> pattern_spans(const History& history) {
  if (history.times.empty() || (history.events.empty() && history.patterns.empty())) return {};
  std::vector<PatternSpan> spans{
      {0, 0, history.events.empty() ? history.patterns.front() : history.events.front().from}};
  for (const Event& event : history.events) {
    if (event.to == spans.back().pattern) continue;
    spans.back().to = event.time;
    spans.push_back({event.time, event.time, event.to});
  }
  spans.back().to = std::max(history.times.back(), spans.back().from);
  return spans;
}

std::vector<double> impact_times(const History& history, int interface) {
  std::vector<double> times;
  for (const Event& event : history.events)
    if (event.kind == EventKind::impact && event.interface == interface) times.push_back(event.time);
  return times;
}

std::string shown_pattern(const Pattern& pattern) {
  std::string text;
  for (const char letter : name(pattern))
    text += letter == '<' ? "←" : letter == '>' ? "→" : letter == '-' ? "–" : std::string(1, letter);
  return text;
}

ContactSummary read_contact_summary(const Run& run) {
  const std::filesystem::path file = run.folder / "summary.json";
  if (!std::filesystem::exists(file)) return {};
  return read_json(file, [](const Json& json) {
    ContactSummary summary;
    for (const Json& one : json.value("contact", Json::array()))
      summary.interfaces.push_back({one.at("final_slip").get<double>(), one.at("largest_slip").get<double>(),
                                    one.at("highest_lift").get<double>(), one.at("slips").get<int>(),
                                    one.at("lift_offs").get<int>()});
    summary.warnings = json.value("validity_warnings", std::vector<std::string>());
    return summary;
  });
}

}  // namespace rockstack::plots
