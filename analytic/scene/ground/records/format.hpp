#pragma once

#include <utility>

#include "analytic/scene/ground/records/record.hpp"
#include "analytic/scene/ground/records/text.hpp"

namespace rockstack::records {

/// A layout of record files. Both functions start at the first line.
struct Format {
  bool (*recognises)(Cursor cursor);
  std::vector<Record> (*read)(Cursor cursor);
};

extern const Format knet, esm, cosmos, smc, geonet, volume2, peer, plain_columns;

/// The names of all layouts, for messages.
inline constexpr std::string_view known_formats =
    "PEER AT2, COSMOS, CSMIP volume 2, USGS SMC, ESM, K-NET/KiK-net, GeoNet, columns of numbers";

/// Samples times a factor to m/s².
inline Record make_record(double interval, std::vector<double> samples, double factor, std::string format) {
  for (double& sample : samples) sample *= factor;
  return {interval, std::move(samples), std::move(format)};
}

}  // namespace rockstack::records
