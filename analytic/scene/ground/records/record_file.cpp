#include "analytic/scene/ground/records/record_file.hpp"

#include <charconv>
#include <system_error>
#include <utility>

#include "analytic/scene/files/file_text.hpp"
#include "analytic/scene/ground/records/formats.hpp"
#include "analytic/scene/messages/input_error.hpp"

namespace rockstack {
namespace {

struct Place {
  std::filesystem::path file;
  std::size_t channel = 1;
};

bool is_there(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::exists(file, error);
}

/// Takes a channel's suffix off a name, unless a file has that very name.
Place place_of(const std::filesystem::path& name) {
  const std::string text = name.string();
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos || is_there(name)) return {name};
  std::size_t channel = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data() + colon + 1, end, channel);
  if (error != std::errc() || rest != end) return {name};
  return {text.substr(0, colon), channel};
}

}  // namespace

std::filesystem::path record_file(const std::filesystem::path& name) {
  return place_of(name).file;
}

Record read_record(const std::filesystem::path& name) {
  const Place place = place_of(name);
  std::vector<Record> series = records::read_series(place.file.string(), file_text(place.file));
  if (place.channel < 1 || place.channel > series.size()) {
    throw InputError(place.file.string() + ": no channel " + std::to_string(place.channel) +
                     ": must be 1 to " + std::to_string(series.size()));
  }
  return std::move(series[place.channel - 1]);
}

}  // namespace rockstack
