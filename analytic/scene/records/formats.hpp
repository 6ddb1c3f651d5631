#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analytic/scene/record.hpp"
#include "analytic/scene/records/text.hpp"

namespace rockstack::records {

/// All series of acceleration in the text of a record, in the order of the text. `file` is its name in
/// errors.
/// @throws InputError as read_record().
std::vector<Record> read_series(std::string_view file, std::string_view text);

/// A layout of record files. Both functions start at the first line.
struct Format {
  bool (*recognises)(Cursor cursor);
  std::vector<Record> (*read)(Cursor cursor);
};

/// Samples times a factor to m/s².
Record make_record(double interval, std::vector<double> samples, double factor, std::string format);

}  // namespace rockstack::records
