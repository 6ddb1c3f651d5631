#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analytic/scene/ground/records/record.hpp"
#include "analytic/scene/ground/records/text.hpp"

namespace rockstack::records {

/// A layout of record files. Both functions start at the first line.
struct Format {
  bool (*recognises)(Cursor cursor);
  std::vector<Record> (*read)(Cursor cursor);
};

/// The names of all layouts, for messages.
inline constexpr std::string_view known_formats =
    "PEER AT2, COSMOS, CSMIP volume 2, USGS SMC, ESM, K-NET/KiK-net, columns of numbers";

/// Samples times a factor to m/s².
Record make_record(double interval, std::vector<double> samples, double factor, std::string format);

}  // namespace rockstack::records
