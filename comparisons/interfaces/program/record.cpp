#include <fmt/format.h>

#include "analytic/scene/ground/records/record_file.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/interfaces/program/record_limits.hpp"
#include "comparisons/measures/metrics/ground.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/provenance.hpp"

namespace rockstack {
namespace {

struct RecordArguments {
  std::string file;  ///< may name a channel, see read_record()
  std::filesystem::path out;
  std::string base_line = "none";  ///< or "fitted", taken off before anything is measured
};

constexpr double spectrum_damping = 0.05;

/// A record as the command sees it: where it came from, the motion to be measured and what it measures.
struct MeasuredRecord {
  std::string file, channel, format, taken, unit, step;
  BaseLine base_line;
  GroundMotion motion;
  GroundMeasures measures;
};

MeasuredRecord measure_record(const RecordArguments& arguments, RecordLimits limits) {
  Record record = read_record(arguments.file, limits);
  const std::string file = record_file(arguments.file).string();
  const std::string channel = arguments.file == file ? "1" : arguments.file.substr(file.size() + 1);
  GroundMotion motion{record.interval, std::move(record.samples), arguments.file};
  const BaseLine line = arguments.base_line == "fitted" ? fitted_base_line(motion) : BaseLine{};
  motion = without(motion, line);
  const GroundMeasures measures = measure_ground(motion);
  return {file,        channel, record.format,     record.taken, record.unit,
          record.step, line,    std::move(motion), measures};
}

Json to_json(const Peak& peak) {
  return {{"value", peak.value}, {"time", peak.time}};
}

Json to_json(const Span& span) {
  return {{"begin", span.begin}, {"end", span.end}, {"length", span.length()}};
}

/// The size of a motion in sentences.
std::vector<std::string> headline(const GroundMeasures& measures) {
  const auto text = [](const Peak& peak, const char* unit) {
    return fmt::format("{:.4g} {} at {:.4g} s", peak.value, unit, peak.time);
  };
  const Span& span = measures.significant_5_95;
  return {fmt::format("The peak acceleration is {:.3g} g: {}.",
                      std::abs(measures.acceleration.value) / standard_gravity,
                      text(measures.acceleration, "m/s²")),
          fmt::format("The peak velocity is {}, the peak displacement {}.", text(measures.velocity, "m/s"),
                      text(measures.displacement, "m")),
          fmt::format(
              "The significant duration is {:.4g} s, from 5 to 95 % of the Arias intensity of {:.4g} m/s.",
              span.length(), measures.arias_intensity)};
}

Json to_json(const MeasuredRecord& record, const RecordArguments& arguments) {
  const GroundMeasures& measures = record.measures;
  return {{"title", std::filesystem::path(record.file).filename().string()},
          {"headline", headline(measures)},
          {"file", record.file},
          {"channel", record.channel},
          {"format", record.format},
          {"taken", record.taken},
          {"unit", record.unit},
          {"step", record.step},
          {"points", measures.points},
          {"interval", measures.interval},
          {"duration", measures.duration},
          {"base_line",
           {{"treatment", arguments.base_line},
            {"value", record.base_line.value},
            {"slope", record.base_line.slope}}},
          {"gravity", standard_gravity},
          {"peak_acceleration", to_json(measures.acceleration)},
          {"peak_velocity", to_json(measures.velocity)},
          {"peak_displacement", to_json(measures.displacement)},
          {"final_velocity", measures.final_velocity},
          {"final_displacement", measures.final_displacement},
          {"arias_intensity", measures.arias_intensity},
          {"significant_5_95", to_json(measures.significant_5_95)},
          {"significant_5_75", to_json(measures.significant_5_75)}};
}

/// What a record measures, a quantity a line.
std::vector<TableCells> measure_lines(const MeasuredRecord& record, const std::string& base_line) {
  const GroundMeasures& m = record.measures;
  std::vector<TableCells> lines;
  const auto line = [&](const char* name, const std::string& value) { lines.push_back({name, value}); };
  const auto peak = [&](const char* name, const Peak& value, const char* unit) {
    line(name, fmt::format("{:.6g} {} at {:.6g} s", value.value, unit, value.time));
  };
  const auto span = [&](const char* name, const Span& value) {
    line(name, fmt::format("{:.6g} s, from {:.6g} s to {:.6g} s", value.length(), value.begin, value.end));
  };
  line("file", record.file);
  line("format", record.format);
  line("channel", record.channel);
  if (!record.taken.empty()) line("taken", record.taken);
  line("unit", "1 in the file is " + record.unit);
  line("points", fmt::format("{}, {:.12g} s apart, {:.6g} s in all", m.points, m.interval, m.duration));
  line("step by", record.step);
  line("base line taken off",
       base_line == "none"
           ? base_line
           : fmt::format("{:.4g} m/s² {:+.4g} m/s³ t", record.base_line.value, record.base_line.slope));
  peak("peak acceleration", m.acceleration,
       fmt::format("m/s² = {:.4g} g", m.acceleration.value / standard_gravity).c_str());
  peak("peak velocity", m.velocity, "m/s");
  peak("peak displacement", m.displacement, "m");
  line("at the end", fmt::format("{:.4g} m/s, {:.4g} m", m.final_velocity, m.final_displacement));
  line("Arias intensity", fmt::format("{:.6g} m/s", m.arias_intensity));
  span("significant 5-95 %", m.significant_5_95);
  span("significant 5-75 %", m.significant_5_75);
  return lines;
}

void print_measures(const std::vector<TableCells>& lines, TableForm form) {
  const std::vector<TableColumn> columns{{"measure", 22, false, 0}, {"value", 0, false, 0}};
  if (form != TableForm::text) fmt::print("{}", table_head(columns, form));
  for (const TableCells& line : lines) fmt::print("{}", table_line(columns, line, form));
  fmt::print("{}", table_foot(form));
}

std::string record_csv(const GroundMotion& motion) {
  const GroundIntegrals path = ground_integrals(motion);
  const std::vector<double> shares = husid(motion);
  CsvWriter csv;
  csv.line("time", "acceleration", "velocity", "displacement", "husid");
  for (std::size_t i = 0; i < motion.samples.size(); ++i) {
    const double time = motion.interval * static_cast<double>(i);
    for (const double value : {time, motion.samples[i], path.velocities[i], path.displacements[i], shares[i]})
      csv.add(number_text(value));
    csv.end_line();
  }
  return csv.text();
}

std::string spectrum_csv(const GroundMotion& motion) {
  CsvWriter csv;
  csv.line("period", "pseudo_acceleration");
  for (const Response& response : response_spectrum(motion, spectrum_damping))
    csv.line(number_text(response.period), number_text(response.pseudo_acceleration));
  return csv.text();
}

int run_record(const RecordArguments& arguments, const Common& common) {
  const MeasuredRecord record = measure_record(arguments, record_limits(common));
  const Json json = to_json(record, arguments);
  std::optional<ResultsFolder> folder;
  if (!arguments.out.empty()) {
    folder.emplace(arguments.out, Results::record, subject_of(arguments.file), common.replace);
    Json whole = json;
    whole["spectrum_damping"] = spectrum_damping;
    whole["command"] = common.command;
    whole["environment"] = environment({});
    write_file(arguments.out / "record.csv", record_csv(record.motion));
    write_file(arguments.out / "spectrum.csv", spectrum_csv(record.motion));
    write_file(arguments.out / "record.json", whole.dump(2) + "\n");
  }
  std::vector<TableCells> lines = measure_lines(record, arguments.base_line);
  if (common.prints_text() && !arguments.out.empty())
    lines.push_back({"results", one_line(arguments.out.string())});
  print_json(json, common);
  if (common.prints_tables()) print_measures(lines, common.table);
  if (!arguments.out.empty()) show_report(arguments.out, common);
  return 0;
}

void add_record(CLI::App& command, RecordArguments& arguments) {
  command.add_option("file", arguments.file, "record, or record:channel")->required();
  command.add_option("--out", arguments.out, "folder for results; left out: none are written");
  command.add_option("--base-line", arguments.base_line, "line to take off the accelerations first")
      ->check(one_of({"none", "fitted"}))
      ->capture_default_str();
}

}  // namespace

Command record_command() {
  return with_tables(make_command("record", "measure an accelerogram", add_record, run_record));
}

}  // namespace rockstack
