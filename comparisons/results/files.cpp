#include "comparisons/results/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "analytic/scene/messages/input_error.hpp"

namespace rockstack {

void prepare_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error && !std::filesystem::is_directory(folder, error))
    error = std::make_error_code(std::errc::not_a_directory);
  if (error)
    throw InputError(
        fmt::format("--out {}: must be a folder that can be written: {}", folder.string(), error.message()));
  try {
    const auto probe = folder / ".writable";
    write_file(probe, "");
    std::filesystem::remove(probe);
  } catch (const std::runtime_error& failure) {
    throw InputError(
        fmt::format("--out {}: must be a folder that can be written: {}", folder.string(), failure.what()));
  }
}

FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ < 0 || flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(descriptor_);
  throw InputError(
      fmt::format("--out {}: must be a folder that no other run writes into just now", folder.string()));
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) close(descriptor_);
}

void write_file(const std::filesystem::path& file, std::string_view content) {
  write_file(file, [content](std::ostream& stream) {
    stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  });
}

void write_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write) {
  auto partial = file;
  partial += ".partial";
  errno = 0;
  std::ofstream stream(partial, std::ios::binary);
  write(stream);
  stream.close();
  if (!stream) {
    const std::string reason = std::strerror(errno);
    std::error_code ignored;
    std::filesystem::remove(partial, ignored);
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", file.string(), reason));
  }
  std::filesystem::rename(partial, file);
}

}  // namespace rockstack
