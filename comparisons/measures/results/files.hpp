#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace rockstack {

/// Keeps a folder for this process until destroyed: two runs in one folder would spoil each other's files.
class FolderLock {
 public:
  /// @throws InputError where another process has the folder. Where the file system knows no locks there is
  /// none.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

/// The 64-bit checksum FNV-1a of Fowler, Noll & Vo.
std::uint64_t checksum(std::string_view text);

/// A text as the name of a file or folder, with room for an ending: itself where it is short, else its front
/// and a checksum of the whole.
std::string folder_name(const std::string& text);

/// Takes text piece by piece.
using Sink = std::function<void(std::string_view)>;

/// Writes a file whole or not at all: beside its place first, onto the disk, then renamed. Nothing that lies
/// at the temporary name, file or link, is written to.
/// @throws std::runtime_error naming the file and the reason.
void write_file(const std::filesystem::path& file, std::string_view content);

/// The same, of what `write` puts out.
void write_file(const std::filesystem::path& file, const std::function<void(const Sink&)>& write);

}  // namespace rockstack
