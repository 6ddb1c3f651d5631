#pragma once

#include <filesystem>
#include <optional>

#include "analytic/scene/scene.hpp"
#include "comparisons/measures/results/csv.hpp"

namespace rockstack {

/// Stems of columns: of where a body is, how it is turned, and the rates of both.
struct PoseForm {
  std::vector<std::string> place, turn, velocity, spin;
};
extern const PoseForm in_space, in_plane, angles_alone;

/// Motion of one body as a file has it, row by row; lists that the file does not have are empty.
struct BodyTable {
  CsvLine::Indices place, turn, velocity, spin;
  std::vector<double> places = {}, turns = {}, velocities = {}, spins = {};

  /// Finds the columns at a file's header; the ground, 0, does not turn. @throws InputError for a missing
  /// one.
  BodyTable(const CsvLine& line, const PoseForm& form, int number);

  void add(const CsvLine& line);
};

/// A file of motion as it stands there. The line of a sample is its number and 2.
struct MotionTable {
  std::string file;
  const PoseForm* form = nullptr;
  std::vector<double> times = {};
  std::vector<BodyTable> bodies = {};
  std::optional<BodyTable> ground = {};

  /// An error at a sample.
  InputError wrong(std::size_t sample, const std::string& what) const;
};

/// @throws InputError with file, line and column.
MotionTable read_motion_table(const std::filesystem::path& file, const Scene& scene);

}  // namespace rockstack
