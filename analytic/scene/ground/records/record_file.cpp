#include "analytic/scene/ground/records/record_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

#include "analytic/scene/files/file_text.hpp"
#include "analytic/scene/ground/records/format.hpp"
#include "analytic/scene/ground/records/plain_text.hpp"
#include "analytic/scene/messages/input_error.hpp"
#include "analytic/scene/messages/number_text.hpp"

namespace rockstack {
namespace records {

std::vector<Record> read_series(std::string_view file, std::string_view bytes) {
  const std::string text = plain_text(file, bytes);
  const Cursor cursor(file, text);
  const std::array formats{&knet, &esm, &cosmos, &smc, &geonet, &volume2, &obspy, &columns};
  for (const Format* format : formats) {
    if (!format->recognises(cursor)) continue;
    std::vector<Record> series;
    for (Cursor rest = cursor; !rest.at_end();) format->read(rest, series);
    check_last_line(file, text);
    if (series.empty()) cursor.fail("holds no series of acceleration");
    for (std::size_t k = 0; k < series.size() && series.size() > 1; ++k)
      if (series[k].taken.empty())
        series[k].taken = "channel " + std::to_string(k + 1) + " of " + std::to_string(series.size());
    return series;
  }
  cursor.fail("not a known format: must be " + std::string(known_formats));
}

Record make_record(const Interval& interval, std::vector<double> samples, const Unit& unit,
                   std::string format) {
  for (double& sample : samples) sample *= unit.factor;
  return {interval.length, std::move(samples), std::move(format), text(unit), interval.place};
}

}  // namespace records

namespace {

struct Place {
  std::filesystem::path file;
  std::size_t channel = 1;
};

/// Takes a channel's suffix off a name, unless a file has that very name.
Place place_of(const std::filesystem::path& name) {
  const std::string text = name.string();
  const std::size_t colon = text.rfind(':');
  std::error_code ignored;
  if (colon == std::string::npos || std::filesystem::exists(name, ignored)) return {name};
  std::size_t channel = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data() + colon + 1, end, channel);
  if (error != std::errc() || rest != end) return {name};
  return {text.substr(0, colon), channel};
}

}  // namespace

void check_usual(const std::string& file, const std::string& read_as, double interval,
                 const std::vector<double>& samples) {
  constexpr double shortest = 1e-5, longest = 0.5;  // s
  constexpr double largest = 10;                    // g
  double peak = 0;
  for (const double sample : samples) peak = std::max(peak, std::abs(sample) / records::standard_gravity);
  const bool usual_step = interval >= shortest && interval <= longest;
  if (usual_step && peak <= largest) return;
  const std::string step = "steps by " + number_text(interval, 6) + " s, ";
  throw InputError(
      file + ": read as " + read_as + ": " +
      (usual_step
           ? "peaks at " + number_text(peak, 6) +
                 " g, more than 10 g: must be in the unit that its title or header says, without marks of missing data"
           : step + (interval > longest ? "more than 0.5 s" : "less than 1e-05 s") +
                 ": a unit of time other than s must be in the title or header, as in \"time (ms)\"") +
      "; where that is meant, say limits = \"none\" beside the record in a scene, or --set limits=none");
}

std::filesystem::path record_file(const std::filesystem::path& name) {
  return place_of(name).file;
}

Record read_record(const std::filesystem::path& name, RecordLimits limits) {
  const Place place = place_of(name);
  std::vector<Record> series = records::read_series(place.file.string(), file_text(place.file));
  if (place.channel < 1 || place.channel > series.size())
    throw InputError(place.file.string() + ": no channel " + std::to_string(place.channel) +
                     ": must be 1 to " + std::to_string(series.size()));
  Record& record = series[place.channel - 1];
  if (limits == RecordLimits::usual)
    check_usual(place.file.string(), description(record), record.interval, record.samples);
  return std::move(record);
}

}  // namespace rockstack
