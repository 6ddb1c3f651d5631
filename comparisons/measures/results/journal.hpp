#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "comparisons/measures/results/files.hpp"

namespace rockstack {

/// Finished parts of a job in a file that only grows, so that a job that was killed can go on: a head line
/// that names the job, then one entry a part, with its length and checksum. An entry that is torn, and what
/// follows it, is dropped when the file is opened again.
class Journal {
 public:
  /// Opens DIR/runs.journal, or starts one for the job of that identity.
  /// @throws InputError where it belongs to another job or another process is writing it; std::runtime_error
  /// where it cannot be written.
  Journal(const std::filesystem::path& folder, const std::string& identity);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  bool has(std::size_t part) const { return entries_.contains(part); }
  std::size_t size() const { return entries_.size(); }

  /// Adds a part that is not there yet. @throws std::runtime_error where it cannot be written.
  void append(std::size_t part, const std::string& text);

  /// Writes all parts in the order of their numbers.
  void copy_to(const Sink& put) const;

 private:
  struct Entry {
    std::uint64_t begin, length;  ///< of the text in the file, bytes
  };

  void scan(const std::string& head);
  void write(std::string_view text);

  std::filesystem::path file_;
  int descriptor_ = -1;
  std::uint64_t end_ = 0;  ///< of the last whole entry, bytes
  std::map<std::size_t, Entry> entries_;
};

}  // namespace rockstack
