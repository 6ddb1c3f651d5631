#include "analytic/scene/ground/records/record_file.hpp"

#include <charconv>
#include <cstdint>
#include <fstream>
#include <system_error>
#include <utility>

#include "analytic/scene/ground/records/formats.hpp"
#include "analytic/scene/messages/input_error.hpp"

namespace rockstack {
namespace {

constexpr std::uintmax_t largest_file = 64U << 20U;  // bytes

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

std::string load(const std::filesystem::path& file) {
  std::error_code error;
  if (!is_there(file)) throw InputError(file.string() + ": no such file");
  if (!std::filesystem::is_regular_file(file, error)) throw InputError(file.string() + ": not a file");
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) throw InputError(file.string() + ": cannot be read");
  if (size > largest_file) throw InputError(file.string() + ": larger than 64 MiB, more than any record");
  std::string text(static_cast<std::size_t>(size), '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(text.data(), static_cast<std::streamsize>(size))) {
    throw InputError(file.string() + ": cannot be read");
  }
  return text;
}

}  // namespace

std::filesystem::path record_file(const std::filesystem::path& name) {
  return place_of(name).file;
}

Record read_record(const std::filesystem::path& name) {
  const Place place = place_of(name);
  std::vector<Record> series = records::read_series(place.file.string(), load(place.file));
  if (place.channel < 1 || place.channel > series.size()) {
    throw InputError(place.file.string() + ": no channel " + std::to_string(place.channel) +
                     ": must be 1 to " + std::to_string(series.size()));
  }
  return std::move(series[place.channel - 1]);
}

}  // namespace rockstack
