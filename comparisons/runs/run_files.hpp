#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace rockstack {

/// The files of one run by their names, before they are written: so a run can be made in another process, or
/// on another machine, than the one that keeps the results.
using RunFiles = std::map<std::string, std::string>;

/// The one that is written last: a run with it is whole.
inline constexpr const char* summary_name = "summary.json";

/// Makes the folder anew and writes all files. @throws std::runtime_error where one cannot be written.
void write_files(const RunFiles& files, const std::filesystem::path& folder);

/// Leaves out samples of history.csv, difference.csv, energy.csv, reactions.csv and parts.csv that are nearer
/// than an interval, s, to the one kept before; the first and the last stay. 0: all stay.
void thin_histories(RunFiles& files, double interval);

/// Between files and one text, for a message. unpack() throws std::runtime_error for anything else than what
/// pack() gave.
std::string pack(const RunFiles& files);
RunFiles unpack(const std::string& message);

}  // namespace rockstack
