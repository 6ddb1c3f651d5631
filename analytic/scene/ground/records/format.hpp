#pragma once

#include <string>
#include <vector>

#include "analytic/scene/ground/records/record.hpp"
#include "analytic/scene/ground/records/text.hpp"

namespace rockstack::records {

/// A layout of record files. Both functions start at the first line.
struct Format {
  bool (*recognises)(Cursor cursor);
  std::vector<Record> (*read)(Cursor cursor);
};

/// Samples times a factor to m/s².
Record make_record(double interval, std::vector<double> samples, double factor, std::string format);

}  // namespace rockstack::records
