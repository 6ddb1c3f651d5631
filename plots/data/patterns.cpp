#include "plots/data/patterns.hpp"

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

}  // namespace rockstack::plots
