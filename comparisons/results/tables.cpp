#include "comparisons/results/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "comparisons/results/csv.hpp"

namespace rockstack {
namespace {

using Json = nlohmann::ordered_json;

/// A cell of comma-separated values; numbers read back to the same double.
std::string csv_cell(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_number_float()) return fmt::format("{}", value.get<double>());
  if (!value.is_string()) return value.dump();
  return text_cell(value.get_ref<const std::string&>());
}

/// Text that grows line by line.
class Lines {
 public:
  template <class... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Values>(values)...);
  }

  template <class Range>
  void add_numbers(const Range& values) {
    for (const double number : values) add(",{}", number);
  }

  void add_names(const char* stem, int count) {
    for (int k = 1; k <= count; ++k) add(",{}_{}", stem, k);
  }

  std::string text() const { return fmt::to_string(buffer_); }

 private:
  fmt::memory_buffer buffer_;
};

const char* side_name(Contact side) {
  return side == Contact::left ? "left" : side == Contact::right ? "right" : "closed";
}

/// Times that show all of the ground motion up to the end of the scene, s.
std::vector<double> ground_times(const Scene& scene) {
  std::vector<double> times{0, scene.duration};
  for (const GroundMotion* motion : {&scene.horizontal, &scene.vertical}) {
    const double interval = motion->pulse ? 1e-3 : motion->interval;
    const double end = std::min(motion->end(), scene.duration);
    for (int i = 1; interval > 0 && i * interval <= end; ++i) times.push_back(i * interval);
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace

std::string comparison_csv(const std::vector<Row>& rows) {
  Json list = Json::array();
  for (const Row& row : rows) list.push_back(row_json(row));
  return csv_of(list);
}

std::string csv_of(const Json& list) {
  Lines lines;
  const char* separator = "";
  for (const auto& [name, cell] : list.at(0).items()) {
    lines.add("{}{}", separator, name);
    separator = ",";
  }
  lines.add("\n");
  for (const Json& row : list) {
    separator = "";
    for (const Json& cell : row) {
      lines.add("{}{}", separator, csv_cell(cell));
      separator = ",";
    }
    lines.add("\n");
  }
  return lines.text();
}

std::string history_csv(const History& history) {
  Lines lines;
  lines.add("time");
  lines.add_names("theta", history.blocks);
  lines.add_names("omega", history.blocks);
  lines.add("{}\n", history.patterns.empty() ? "" : ",pattern");
  for (std::size_t i = 0; i < history.size(); ++i) {
    lines.add("{}", history.times[i]);
    lines.add_numbers(history.angles_at(i));
    lines.add_numbers(history.velocities_at(i));
    if (!history.patterns.empty()) lines.add(",{}", name(history.patterns[i]));
    lines.add("\n");
  }
  return lines.text();
}

std::string events_csv(const History& history) {
  Lines lines;
  lines.add("time,kind,interface,from,to");
  lines.add_names("theta", history.blocks);
  lines.add_names("omega_before", history.blocks);
  lines.add_names("omega_after", history.blocks);
  lines.add(",consistency\n");
  for (const Event& event : history.events) {
    lines.add("{},{},{},{},{}", event.time, name(event.kind), event.interface, name(event.from),
              name(event.to));
    lines.add_numbers(event.angles);
    lines.add_numbers(event.before);
    lines.add_numbers(event.after);
    lines.add(",{}\n", name(event.consistency));
  }
  return lines.text();
}

std::string ground_csv(const Scene& scene) {
  Lines lines;
  lines.add("time,horizontal,vertical\n");
  for (const double time : ground_times(scene))
    lines.add("{},{},{}\n", time, acceleration(scene.horizontal, time), acceleration(scene.vertical, time));
  return lines.text();
}

std::string difference_csv(const Difference& difference) {
  Lines lines;
  lines.add("time");
  lines.add_names("difference", static_cast<int>(difference.blocks));
  lines.add("\n");
  for (std::size_t i = 0; i < difference.times.size(); ++i) {
    lines.add("{}", difference.times[i]);
    for (std::size_t k = 0; k < difference.blocks; ++k)
      lines.add(",{}", difference.angles[i * difference.blocks + k]);
    lines.add("\n");
  }
  return lines.text();
}

std::string impacts_csv(const std::vector<AlignedImpact>& alignment) {
  const auto cell = [](const auto& value) { return value ? fmt::format("{}", *value) : std::string(); };
  Lines lines;
  lines.add("number,interface,exact_time,engine_time,difference,verdict,exact_side,engine_side\n");
  for (const AlignedImpact& line : alignment) {
    const bool both = line.exact && line.engine;
    const std::string apart = both ? fmt::format("{}", *line.engine - *line.exact) : "";
    lines.add("{},{},{},{},{},{},{},{}\n", cell(line.number), line.interface, cell(line.exact),
              cell(line.engine), apart,
              both         ? "matched"
              : line.exact ? "missed"
                           : "extra",
              line.exact ? side_name(line.exact_side) : "", line.engine ? side_name(line.engine_side) : "");
  }
  return lines.text();
}

std::string patterns_csv(const std::vector<PatternShare>& shares) {
  Lines lines;
  lines.add("exact,engine,share\n");
  for (const PatternShare& one : shares)
    lines.add("{},{},{}\n", name(one.exact), name(one.engine), one.share);
  return lines.text();
}

std::string energy_csv(const std::vector<double>& times, const std::vector<double>& exact,
                       const std::vector<double>& engine, const std::vector<double>& input) {
  Lines lines;
  lines.add("time,exact,engine,input\n");
  for (std::size_t i = 0; i < times.size(); ++i) {
    lines.add("{},{},{},{}\n", times[i], exact[i], engine[i], input[i]);
  }
  return lines.text();
}

}  // namespace rockstack
