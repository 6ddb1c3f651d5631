#include "comparisons/measures/results/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

#include "analytic/scene/messages/input_error.hpp"

namespace rockstack {
namespace {

/// A file that grows beside its place, and goes away unless it is finished.
class PartialFile {
 public:
  explicit PartialFile(const std::filesystem::path& file) : file_(file), own_(file.string() + ".partial") {
    // Made new: what a killed run has left goes, and a link leads nowhere.
    unlink(own_.c_str());
    descriptor_ = open(own_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0) fail();
  }
  ~PartialFile() {
    if (descriptor_ < 0) return;
    close(descriptor_);
    unlink(own_.c_str());
  }
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;

  void append(std::string_view text) {
    while (!text.empty()) {
      const ssize_t written = write(descriptor_, text.data(), text.size());
      if (written < 0 && errno != EINTR) fail();
      text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
    }
  }

  /// On the disk first, then in its place: a machine that stops leaves it whole or not there.
  void finish() {
    const bool on_disk = fsync(descriptor_) == 0 || errno == EINVAL;  // where a file system cannot be asked
    if (!on_disk || rename(own_.c_str(), file_.c_str()) != 0) fail();
    close(std::exchange(descriptor_, -1));
  }

 private:
  [[noreturn]] void fail() const {
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", file_.string(), std::strerror(errno)));
  }

  std::filesystem::path file_;
  std::string own_;
  int descriptor_ = -1;
};

}  // namespace

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

std::uint64_t checksum(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char letter : text) {
    hash ^= static_cast<unsigned char>(letter);
    hash *= 0x100000001b3;
  }
  return hash;
}

std::string folder_name(const std::string& text) {
  constexpr std::size_t longest = 128, front = 100;
  if (text.size() <= longest) return text;
  std::size_t end = front;
  while ((static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80) --end;  // not inside a letter of UTF-8
  return fmt::format("{}-{:016x}", text.substr(0, end), checksum(text));
}

void write_file(const std::filesystem::path& file, std::string_view content) {
  write_file(file, [content](const Sink& put) { put(content); });
}

void write_file(const std::filesystem::path& file, const std::function<void(const Sink&)>& write) {
  PartialFile partial(file);
  write([&](std::string_view text) { partial.append(text); });
  partial.finish();
}

}  // namespace rockstack
