#pragma once

#include <filesystem>

#include "analytic/scene/history.hpp"
#include "analytic/scene/input/key.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

/// What a test of a scene has measured: the angles of blocks, or how far a point of one has moved along the
/// ground from where it is when the stack stands upright.
struct Measurement {
  std::string file;                                 ///< as the scene names it
  std::vector<std::string> columns;                 ///< of that file, one a block from the first on
  std::size_t first_block = 0;                      ///< index of the block that the first column is of
  std::optional<std::array<double, 2>> point = {};  ///< of that block, from its middle, m; none: angles
  std::vector<double> times;                        ///< s from the start of the scene, ascending from ≥ 0
  std::vector<double> values;  ///< rad or m, times.size() × columns.size(); missing: not a number
  std::optional<double> uncertainty = {};  ///< standard deviation of a reading, rad or m
  const char* unit() const { return point ? "m" : "rad"; }
  /// Whether it tells the angles of so many blocks at all of several times, and so stands beside engines.
  bool is_motion(std::size_t blocks) const;
};

/// What the table [measured] of a scene file says of a test.
struct MeasuredTable {
  const Scene* scene = nullptr;  ///< that was tested
  std::string file, time = "time";
  std::vector<std::string> columns;
  double start = 0;                                 ///< s
  std::size_t block = 1;                            ///< number of that of the first column
  std::optional<std::array<double, 2>> point = {};  ///< m
  const Node* unit = nullptr;                       ///< of the readings: of angles, or of a point's way
  std::optional<double> uncertainty = {};           ///< in that unit
};

/// Every key of it.
extern const KeysOf<MeasuredTable> measured_keys;

/// Reads the table [measured] of a scene; its file is seen from `folder`. Readings before the start or after
/// the scene's duration are left out.
/// @throws InputError with place, key, value and what is allowed; as records::read_titled() of the file;
/// where a unit is none or not known, its last line is cut, times do not ascend, no reading is left or one of
/// several, or angles without a unit are beyond toppling.
Measurement read_measurement(const Node& table, const std::filesystem::path& folder, const Scene& scene);

/// The angles that were measured as a motion, with velocities from the reading before to the one after.
/// Precondition: measured.is_motion().
History motion_of(const Measurement& measured);

/// What a motion has at its samples in the place of what was measured, row by row. `centres`: of mass, x and
/// y of each block in turn, m; a point alone needs them.
std::vector<double> readings_of(const Measurement& measured, const Scene& scene, const History& history,
                                const std::vector<double>& centres);

}  // namespace rockstack
