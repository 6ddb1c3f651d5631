#pragma once

#include <string_view>
#include <vector>

#include "analytic/scene/ground/records/record.hpp"

namespace rockstack::records {

/// All series of acceleration in the text of a record, in the order of the text. `file` is its name in
/// errors.
/// @throws InputError as read_record().
std::vector<Record> read_series(std::string_view file, std::string_view text);

}  // namespace rockstack::records
