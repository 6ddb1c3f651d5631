#include "analytic/scene/files/file_text.hpp"

#include <cstdint>
#include <fstream>
#include <system_error>

#include "analytic/scene/messages/input_error.hpp"

namespace rockstack {

std::string file_text(const std::filesystem::path& file) {
  constexpr std::uintmax_t largest = 64U << 20U;  // bytes
  const auto refuse = [&](const char* reason) {
    const std::string name = file.empty() ? "\"\"" : file.string();
    return InputError(name + ": must be a file, " + reason);
  };
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) throw refuse("nothing is there");
  if (!std::filesystem::is_regular_file(status)) throw refuse("this is a folder, a pipe or a device");
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) throw refuse("this one cannot be read");
  if (size > largest) throw refuse("at most 64 MiB large");
  std::string text(static_cast<std::size_t>(size), '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(text.data(), static_cast<std::streamsize>(size))) throw refuse("this one cannot be read");
  return text;
}

}  // namespace rockstack
