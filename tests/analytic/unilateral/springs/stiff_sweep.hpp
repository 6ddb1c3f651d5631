#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace rockstack::testing {

/// What springs of one stiffness and damping ratio come to in one case, and what rigid laws do.
struct StiffRow {
  std::string quantity;  ///< with its unit
  double stiffness = 0;  ///< N/m at each corner
  double ratio = 0;      ///< of damping
  double springs = 0;    ///< not a number where they are too soft for the stack to stand
  double paper = 0, consistent = 0, unilateral = 0;
};

/// Damping ratios of a sweep.
inline constexpr double damping_ratios[] = {0.01, 0.1, 1, 10};

/// One block's velocity ratio and the base's angle of each case of stiff_cases(), from 10^least to 10^most
/// N/m, two stiffnesses a decade. Of a motion that cannot be followed to its end, standard error says so.
std::vector<StiffRow> stiff_sweep(int least, int most);

/// Columns of comma-separated values with one header line.
void write_rows(const std::vector<StiffRow>& rows, std::ostream& out);

/// A panel a quantity, a line a damping ratio, and rigid laws as levels: `stem`.png, .svg and .pdf.
void draw(const std::vector<StiffRow>& rows, const std::filesystem::path& stem);

}  // namespace rockstack::testing
