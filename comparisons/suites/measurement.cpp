#include "comparisons/suites/measurement.hpp"

#include <numbers>
#include <tuple>

#include "comparisons/measures/results/csv.hpp"

namespace rockstack {
namespace {

std::vector<std::string> names_of_columns(const Node& node) {
  if (node.kind != Node::Kind::array) return {text(node)};
  return each_of(entries(node, "a name of a column for each block"), text);
}

/// Of a reading, to rad or m.
double unit_factor(const Node* unit, bool point) {
  if (unit == nullptr) return 1;
  if (point) return choice<double>(*unit, {{"m", 1}, {"cm", 0.01}, {"mm", 1e-3}});
  return choice<double>(*unit, {{"rad", 1}, {"mrad", 1e-3}, {"deg", std::numbers::pi / 180}});
}

}  // namespace

Measurement read_measurement(const Node& table, const std::filesystem::path& folder, const Scene& scene) {
  require_table(table, measured_keys);
  Measurement measured;
  const Node& file = required(table, "file", "a CSV file");
  const Node& column = required(table, "column", "the name of a column");
  measured.file = text(file);
  measured.columns = names_of_columns(column);
  if (const Node* block = find(table, "block"))
    measured.first_block =
        static_cast<std::size_t>(whole_number(*block, 1, static_cast<double>(scene.blocks.size()))) - 1;
  if (measured.first_block + measured.columns.size() > scene.blocks.size())
    throw wrong_value(column, "as many names as there are blocks from `block` up, or fewer");
  if (const Node* point = find(table, "point")) {
    const std::vector<double> at = numbers(*point);
    if (at.size() != 2) throw wrong_value(*point, "[x, y] in m, from the block's middle");
    if (measured.columns.size() != 1) throw wrong_value(*point, "left out where there are several columns");
    measured.point = {at[0], at[1]};
  }
  const double factor = unit_factor(find(table, "unit"), measured.point.has_value());
  if (const Node* node = find(table, "uncertainty")) measured.uncertainty = factor * number_above_zero(*node);
  const Node* time = find(table, "time");
  std::vector<std::string> names{time == nullptr ? "time" : text(*time)};
  names.insert(names.end(), measured.columns.begin(), measured.columns.end());
  if (!std::filesystem::exists(folder / measured.file))
    throw wrong_value(file, "a CSV file, none is at " + one_line((folder / measured.file).string()));
  const auto columns = read_columns(folder / measured.file, names);
  const double start = number_or(table, "start", 0);
  for (std::size_t i = 0; i < columns[0].size(); ++i) {
    const double at = columns[0][i] - start;
    if (!(i == 0 || columns[0][i] > columns[0][i - 1]) || std::isnan(at))
      throw wrong_value(
          file, "a file with times that ascend, those of its reading " + std::to_string(i + 1) + " do not");
    if (at < 0 || at > scene.duration) continue;
    measured.times.push_back(at);
    for (std::size_t k = 1; k < columns.size(); ++k) measured.values.push_back(factor * columns[k][i]);
  }
  if (measured.times.empty()) throw wrong_value(file, "a file with readings within the scene's duration");
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
