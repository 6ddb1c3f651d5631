#include "comparisons/suites/measurement.hpp"

#include <fmt/ranges.h>

#include <numbers>
#include <tuple>

#include "analytic/scene/files/file_text.hpp"
#include "analytic/scene/ground/records/header.hpp"
#include "analytic/scene/ground/records/plain_text.hpp"

namespace rockstack {
namespace {

std::vector<std::string> names_of_columns(const Node& node) {
  if (node.kind != Node::Kind::array) return {text(node)};
  return mapped(entries(node, "a name of a column for each block"), text);
}

/// Factor to rad or m that the key `unit` says.
std::optional<double> stated_factor(const Node* unit, bool point) {
  if (unit == nullptr) return std::nullopt;
  if (point) return choice<double>(*unit, {{"m", 1}, {"cm", 0.01}, {"mm", 1e-3}});
  return choice<double>(*unit, {{"rad", 1}, {"mrad", 1e-3}, {"deg", std::numbers::pi / 180}});
}

/// The column of a name, with or without its unit.
std::size_t column_named(const records::RecordTable& table, const std::string& name) {
  const auto& titles = table.titles;
  for (const auto member : {&records::Title::text, &records::Title::name})
    if (const auto found = std::ranges::find(titles, name, member); found != titles.end()) {
      if (std::ranges::count(titles, name, member) > 1)
        table.cursor.fail_at(table.title_line, fmt::format("several columns are {}: must be one", name));
      return static_cast<std::size_t>(found - titles.begin());
    }
  const auto names = mapped(titles, [](const records::Title& title) { return title.text; });
  table.cursor.fail_at(table.title_line,
                       fmt::format("no column {}; its titles are {}", name,
                                   names.empty() ? "missing" : fmt::format("{}", fmt::join(names, ", "))));
}

std::string_view units_of(records::Quantity quantity) {
  return quantity == records::Quantity::angle  ? "rad, mrad or deg"
         : quantity == records::Quantity::time ? "s, ms or min"
                                               : "m, cm or mm";
}

/// The unit that the title of a column has, or else the header, which the key `unit` must not contradict.
/// @throws InputError also where what stands in the place of a unit is none.
std::optional<double> own_factor(const records::RecordTable& table, std::size_t column,
                                 records::Quantity quantity, std::optional<double> stated) {
  const auto& title = table.titles[column];
  const auto topic = quantity == records::Quantity::angle  ? records::Topic::angle
                     : quantity == records::Quantity::time ? records::Topic::time
                                                           : records::Topic::displacement;
  const bool unread = !title.unit && (!title.unknown_unit.empty() || (title.name != title.text && !stated));
  if (unread || title.scaled || (title.unit && title.unit->quantity != quantity))
    table.cursor.fail_at(table.title_line,
                         fmt::format("{} has no unit of {}: must be {}", table.column_name(column),
                                     records::name(quantity), units_of(quantity)));
  const auto unit = title.unit || stated ? title.unit : records::unit_in_header(table, topic, quantity);
  if (unit && stated && *stated != unit->factor)
    table.cursor.fail_at(table.title_line,
                         fmt::format("{} has another unit than measured.unit", table.column_name(column)));
  return unit ? std::optional(unit->factor) : std::nullopt;
}

/// Refuses angles that no standing block has, where nobody has said that they are in rad.
void require_standing(const Measurement& measured, const Scene& scene, const Node& column) {
  const std::size_t columns = measured.columns.size();
  for (std::size_t k = 0; k < measured.values.size(); ++k) {
    const auto block = static_cast<int>(measured.first_block + k % columns);
    const double least = toppling_angle(scene, block);
    if (!(std::abs(measured.values[k]) > least)) continue;
    throw wrong_value(column,
                      fmt::format("of angles in rad: {:.4g} at {:.6g} s is beyond {:.4g}, where block {} "
                                  "has toppled; say unit = \"deg\", or unit = \"rad\" where it is meant",
                                  measured.values[k], measured.times[k / columns], least, block + 1));
  }
}

std::array<double, 2> read_point(const Node& node, const MeasuredTable& said) {
  const std::vector<double> at = numbers(node);
  if (at.size() != 2) throw wrong_value(node, "[x, y] in m, from the block's middle");
  if (said.columns.size() != 1) throw wrong_value(node, "left out where there are several columns");
  return {at[0], at[1]};
}

MeasuredTable read_measured_table(const Node& table, const Scene& scene) {
  MeasuredTable said;
  said.scene = &scene;
  require_table(table, measured_keys);
  required(table, "file", "a CSV file");
  const Node& column = required(table, "column", "the name of a column");
  read_members(table, measured_keys, said);
  if (said.block + said.columns.size() > scene.blocks.size() + 1)
    throw wrong_value(column, "as many names as there are blocks from `block` up, or fewer");
  return said;
}

/// What the columns of a file hold: times in s, and readings in rad or m, a list a column.
struct Readings {
  std::vector<double> times;
  std::vector<std::vector<double>> columns;
  double factor = 1;       ///< to rad or m
  bool says_unit = false;  ///< whether the file or the table does
};

Readings read_columns_of(const std::string& name, const MeasuredTable& said) {
  const std::string text_of_file = records::plain_text(name, file_text(name));
  std::vector<std::string> names = said.columns;
  names.push_back(said.time);
  records::check_last_line(name, text_of_file);
  const records::RecordTable table = records::read_titled(name, text_of_file, names);
  table.check_even(false);
  const std::optional<double> stated = stated_factor(said.unit, said.point.has_value());
  const std::size_t time = column_named(table, said.time);
  Readings readings{.times = table.column(time, true), .columns = {}, .says_unit = stated.has_value()};
  const double time_factor = own_factor(table, time, records::Quantity::time, std::nullopt).value_or(1);
  for (double& at : readings.times) at *= time_factor;
  const auto quantity = said.point ? records::Quantity::displacement : records::Quantity::angle;
  for (const std::string& one : said.columns) {
    const std::size_t index = column_named(table, one);
    const std::optional<double> unit = own_factor(table, index, quantity, stated);
    readings.factor = unit.value_or(stated.value_or(1));
    readings.says_unit = readings.says_unit || unit;
    readings.columns.push_back(table.column(index, true));
    for (double& value : readings.columns.back()) value = readings.factor * value;
  }
  return readings;
}

/// Adds the readings within the scene's time, row by row.
void add_readings(const Readings& readings, const MeasuredTable& said, const Node& file,
                  Measurement& measured) {
  const std::vector<double>& times = readings.times;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double at = times[i] - said.start;
    if (!(i == 0 || times[i] > times[i - 1]) || std::isnan(at))
      throw wrong_value(
          file, "a file with times that ascend, those of its reading " + std::to_string(i + 1) + " do not");
    if (at < 0 || at > said.scene->duration) continue;
    measured.times.push_back(at);
    for (const std::vector<double>& column : readings.columns) measured.values.push_back(column[i]);
  }
  if (measured.times.empty()) throw wrong_value(file, "a file with readings within the scene's duration");
  if (measured.times.size() == 1 && times.size() > 1)
    throw wrong_value(
        file,
        "a file with more than one reading within the scene's duration: times in ms must say so, as in "
        "\"time (ms)\"");
}

}  // namespace

const KeysOf<MeasuredTable> measured_keys{
    "[measured]",
    "what a test of a scene has measured, for `rockstack fit` and `compare`",
    {{"file", "\"test.csv\"", "", "a file of columns beside the scene, with titles", required_key,
      "the readings", &MeasuredTable::file},
     {{"column", "\"theta_1\"", "", "a name, or an array of one for each block from `block` up", required_key,
       "of the readings: angles, or displacements of a point"},
      [](const Node& node, MeasuredTable& said) { said.columns = names_of_columns(node); }},
     {"time", "\"time\"", "", "a name", "\"time\"",
      "of the column of times, ascending, in s or the unit of its title or header", &MeasuredTable::time},
     {"start", "0.0", "s", any_number, "time of the file at which the scene starts", &MeasuredTable::start},
     {{"unit", "\"rad\"", "", "\"rad\", \"mrad\", \"deg\"; of a point \"m\", \"cm\" or \"mm\"",
       "that of the title or header, or else \"rad\", of a point \"m\"", "of the readings"},
      [](const Node& node, MeasuredTable& said) { said.unit = &node; }},
     {{"block", "1", "", "the number of a block", "1", "that the first column is of"},
      [](const Node& node, MeasuredTable& said) {
        said.block =
            static_cast<std::size_t>(whole_number(node, 1, static_cast<double>(said.scene->blocks.size())));
      }},
     {{"point", "[0.0, 0.5]", "m", "two numbers", "none: angles",
       "of the block, from its middle to the right and up, whose way along the ground is measured"},
      [](const Node& node, MeasuredTable& said) { said.point = read_point(node, said); }},
     {{"uncertainty", "0.001", "rad or m", "> 0", no_default, "standard deviation of a reading, in `unit`"},
      [](const Node& node, MeasuredTable& said) { said.uncertainty = number_above_zero(node); }}}};

Measurement read_measurement(const Node& table, const std::filesystem::path& folder, const Scene& scene) {
  const MeasuredTable said = read_measured_table(table, scene);
  const Node& file = *find(table, "file");
  const std::string name = (folder / said.file).string();
  if (!std::filesystem::exists(name)) throw wrong_value(file, "a CSV file, none is at " + one_line(name));
  Measurement measured{said.file, said.columns, said.block - 1, said.point, {}, {}};
  const Readings readings = read_columns_of(name, said);
  if (said.uncertainty) measured.uncertainty = readings.factor * *said.uncertainty;
  add_readings(readings, said, file, measured);
  if (!said.point && !readings.says_unit) require_standing(measured, scene, *find(table, "column"));
  return measured;
}

bool Measurement::is_motion(std::size_t blocks) const {
  return !point && columns.size() == blocks && times.size() > 1 &&
         std::ranges::none_of(values, [](double value) { return std::isnan(value); });
}

History motion_of(const Measurement& measured) {
  const auto& [times, values] = std::tie(measured.times, measured.values);
  const std::size_t blocks = measured.columns.size(), last = times.size() - 1;
  History history;
  history.blocks = static_cast<int>(blocks);
  history.times = times;
  history.angles = values;
  for (std::size_t i = 0; i <= last; ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, last);
    for (std::size_t k = 0; k < blocks; ++k)
      history.velocities.push_back((values[after * blocks + k] - values[before * blocks + k]) /
                                   (times[after] - times[before]));
  }
  return history;
}

std::vector<double> readings_of(const Measurement& measured, const Scene& scene, const History& history,
                                const std::vector<double>& centres) {
  const std::size_t blocks = scene.blocks.size(), block = measured.first_block;
  std::vector<double> list;
  for (std::size_t i = 0; i < history.size(); ++i) {
    if (!measured.point) {
      const auto angles = history.angles_at(i).subspan(block, measured.columns.size());
      list.insert(list.end(), angles.begin(), angles.end());
      continue;
    }
    const auto [x, y] = *measured.point;
    const double angle = history.angles_at(i)[block];
    double upright = x;
    for (std::size_t k = 0; k <= block && !scene.initial.offsets.empty(); ++k)
      upright += scene.initial.offsets[k];
    list.push_back(centres[2 * (i * blocks + block)] + (x - scene.blocks[block].offset_x) * std::cos(angle) +
                   (y - scene.blocks[block].offset_y) * std::sin(angle) - upright);
  }
  return list;
}

}  // namespace rockstack
