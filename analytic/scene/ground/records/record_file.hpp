#pragma once

#include <filesystem>
#include <string_view>

#include "analytic/scene/ground/records/record.hpp"

namespace rockstack {

/// The file that a record's name stands for: the name itself, without a channel as in "FILE:2".
std::filesystem::path record_file(const std::filesystem::path& name);

/// Reads a ground-motion record; the format is recognised by content, units come from the file, 1 g = 9.80665
/// m/s². Of several channels "FILE" is the first series of acceleration, "FILE:2" the second.
/// @throws InputError with file and line: as file_text(), empty, binary, cut short, wrong count, unknown
/// format or units, a channel that is not there; as check_usual() unless there are no limits.
Record read_record(const std::filesystem::path& name, RecordLimits limits = RecordLimits::usual);

/// Refuses a step below 10 µs or above 0.5 s and a peak above 10 g (98.0665 m/s²), which come as a rule of a
/// unit read wrongly. `read_as` is description(). @throws InputError.
void check_usual(const std::string& file, const std::string& read_as, double interval,
                 const std::vector<double>& samples);

namespace records {

/// All series of acceleration in the text of a record, in its order. `file` is its name in errors.
/// @throws InputError as read_record().
std::vector<Record> read_series(std::string_view file, std::string_view text);

}  // namespace records
}  // namespace rockstack
