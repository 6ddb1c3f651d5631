#include "analytic/scene/files/file_text.hpp"

#include <fstream>
#include <system_error>

#include "analytic/scene/messages/input_error.hpp"
#include "analytic/scene/messages/one_line.hpp"

namespace rockstack {

namespace {

InputError no_file(const std::filesystem::path& file, const std::string& reason) {
  const std::string name = file.empty() ? "\"\"" : one_line(file.string());
  return InputError(name + ": must be a file, " + reason);
}

}  // namespace

const std::filesystem::path& regular_file(const std::filesystem::path& file) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(file, ignored);
  if (!std::filesystem::exists(status)) throw no_file(file, "nothing is there");
  if (!std::filesystem::is_regular_file(status)) throw no_file(file, "this is a folder, a pipe or a device");
  return file;
}

std::string file_text(const std::filesystem::path& file, std::uintmax_t largest) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(regular_file(file), error);
  if (error) throw no_file(file, "this one cannot be read");
  if (size > largest) throw no_file(file, "at most " + std::to_string(largest >> 20U) + " MiB large");
  std::string text(static_cast<std::size_t>(size), '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(text.data(), static_cast<std::streamsize>(size)))
    throw no_file(file, "this one cannot be read");
  return text;
}

}  // namespace rockstack
