#include "comparisons/suites/trajectory_table.hpp"

#include <fmt/format.h>

#include <cmath>

#include "analytic/scene/lists.hpp"
#include "analytic/scene/messages/one_line.hpp"

namespace rockstack {
namespace {

const PoseForm& form_of(const CsvLine& line, const std::filesystem::path& file) {
  if (line.has("z_1") || line.has("qw_1")) return in_space;
  if (line.has("x_1")) return in_plane;
  if (line.has("theta_1")) return angles_alone;
  throw InputError(
      fmt::format("{}:1: no column theta_1: must have time and, for each block from 1 up, theta_1; x_1, y_1, "
                  "theta_1; or x_1, y_1, z_1, qw_1, qx_1, qy_1, qz_1",
                  file.string()));
}

double finite_number(const CsvLine& line, std::size_t column) {
  return line.named(column, [](const std::string& text) {
    const auto value = number_in(text);
    if (!value || !(std::abs(*value) <= largest_number))
      throw std::invalid_argument(fmt::format("\"{}\": must be a number", one_line(text)));
    return *value;
  });
}

}  // namespace

const PoseForm in_space{
    {"x_", "y_", "z_"}, {"qw_", "qx_", "qy_", "qz_"}, {"vx_", "vy_", "vz_"}, {"wx_", "wy_", "wz_"}},
    in_plane{{"x_", "y_"}, {"theta_"}, {"vx_", "vy_"}, {"omega_"}},
    angles_alone{{}, {"theta_"}, {}, {"omega_"}};

BodyTable::BodyTable(const CsvLine& line, const PoseForm& form, int number) {
  const auto named = [&](const std::vector<std::string>& stems) {
    return line.indices(
        mapped(stems, [&](const std::string& stem) { return stem + std::to_string(number); }));
  };
  const auto if_there = [&](const std::vector<std::string>& stems) {
    const bool there = !stems.empty() && line.has(stems.front() + std::to_string(number));
    return there ? named(stems) : CsvLine::Indices();
  };
  place = named(form.place);
  velocity = if_there(form.velocity);
  if (number == 0) return;  // the ground does not turn
  turn = named(form.turn);
  spin = if_there(form.spin);
}

void BodyTable::add(const CsvLine& line) {
  for (const auto& [columns, list] : {std::pair(&place, &places), std::pair(&turn, &turns),
                                      std::pair(&velocity, &velocities), std::pair(&spin, &spins)})
    for (const std::size_t column : *columns) list->push_back(finite_number(line, column));
}

InputError MotionTable::wrong(std::size_t sample, const std::string& what) const {
  return InputError(fmt::format("{}:{}: {}", file, sample + 2, what));
}

MotionTable read_motion_table(const std::filesystem::path& file, const Scene& scene) {
  CsvLine line(file);
  MotionTable table{.file = file.string(), .form = &form_of(line, file)};
  const auto blocks = static_cast<int>(scene.blocks.size());
  for (int k = 1; k <= blocks; ++k) table.bodies.emplace_back(line, *table.form, k);
  if (const std::string more = fmt::format("{}{}", table.form->turn.front(), blocks + 1); line.has(more))
    throw InputError(fmt::format("{}:1: {}: must be left out, the scene has {}", table.file, more,
                                 blocks == 1 ? "one block" : fmt::format("{} blocks", blocks)));
  if (table.form == &angles_alone && leaves_pivots(scene.law))
    throw InputError(fmt::format("{}:1: no column x_1: must be there under law {}, as blocks slip",
                                 table.file, name(scene.law)));
  if (!table.form->place.empty() && line.has("x_0")) table.ground.emplace(line, *table.form, 0);
  const std::size_t time = line.index("time");
  while (line.next()) {
    const double now = finite_number(line, time);
    if (!table.times.empty() && !(now > table.times.back()))
      throw table.wrong(table.times.size(),
                        fmt::format("time = {}: must be above {}, the time before", now, table.times.back()));
    table.times.push_back(now);
    for (BodyTable& body : table.bodies) body.add(line);
    if (table.ground) table.ground->add(line);
  }
  if (table.times.size() < 2) throw InputError(fmt::format("{}: must have two samples or more", table.file));
  return table;
}

}  // namespace rockstack
