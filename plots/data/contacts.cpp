#include "plots/data/contacts.hpp"

#include <algorithm>

#include "plots/data/events.hpp"
#include "plots/data/json_file.hpp"

namespace rockstack::plots {

std::vector<NamedContact> contacts_in(const std::string& pattern, int blocks) {
  std::vector<NamedContact> contacts;
  const auto named = std::find_if(two_block_patterns().begin(), two_block_patterns().end(),
                                  [&](const NamedSides& one) { return blocks == 2 && one.first == pattern; });
  if (named != two_block_patterns().end()) {
    for (const int side : named->second) contacts.push_back({side});
    return contacts;
  }
  for (const char letter : pattern) {
    if (letter == '<' || letter == '>') {
      if (!contacts.empty()) contacts.back().slide = letter == '<' ? -1 : 1;
    } else {
      contacts.push_back({letter == 'L' ? -1 : letter == 'R' ? 1 : letter == '-' ? 2 : 0});
    }
  }
  contacts.resize(static_cast<std::size_t>(blocks));
  return contacts;
}

std::string shown_pattern(const std::string& name) {
  std::string text;
  for (const char letter : name)
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
                                    one.at("highest_lift").get<double>(), one.at("slips").get<std::size_t>(),
                                    one.at("lift_offs").get<std::size_t>()});
    summary.warnings = json.value("validity_warnings", std::vector<std::string>());
    return summary;
  });
}

}  // namespace rockstack::plots
