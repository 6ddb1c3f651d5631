#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "analytic/scene/messages/input_error.hpp"

namespace rockstack {

/// A file that the system has open, closed with this.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor();
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }  ///< negative where it could not be opened

 private:
  int number_;
};

/// Keeps a folder for this process until destroyed: two runs in one folder would spoil each other's files.
class FolderLock : Descriptor {
 public:
  /// @throws InputError where another process has the folder. Where the file system knows no locks there is
  /// none.
  explicit FolderLock(const std::filesystem::path& folder);
};

/// The 64-bit checksum FNV-1a of Fowler, Noll & Vo.
std::uint64_t checksum(std::string_view text);

/// A text as the name of a file or folder, with room for an ending: itself where it is short and plain, else
/// its front and a checksum of the whole. Plain: one line that leads to no other folder and is not hidden.
std::string folder_name(const std::string& text);

/// Takes text piece by piece.
using Sink = std::function<void(std::string_view)>;

/// Writes a file whole or not at all: beside its place first, onto the disk, then renamed. Nothing that lies
/// at the temporary name, file or link, is written to.
/// @throws std::runtime_error naming the file and the reason.
void write_file(const std::filesystem::path& file, std::string_view content);

/// Writes what `write` puts out.
void write_file(const std::filesystem::path& file, const std::function<void(const Sink&)>& write);

/// Writes a file in this way by what `write` does with the empty file whose name it is given.
void replace_file(const std::filesystem::path& file,
                  const std::function<void(const std::filesystem::path&)>& write);

/// What a folder holds, by the command that fills it.
enum class Results {
  motion,
  comparison,
  lesson,
  advice,
  stability,
  impact_laws,
  sweep,
  record,
  diff,
  canon,
  course,
  sheets,
  fit,
  threshold,
  round
};

/// A folder that this process alone fills, with results of one kind. Runs that are there stay for the command
/// to judge; tables, figures and pages that were made of them go before anything is made again, so that
/// nothing of before stands beside what is new. A folder that was made for this and that nothing has come
/// into goes again.
class ResultsFolder {
 public:
  /// `subject`: the name of the scene or suite that the results are of; empty: of none. `replace`: those of
  /// another one go, runs too.
  /// @throws InputError where the folder cannot be written, is being written by another process, or holds
  /// results of another kind or, unless they are to be replaced, of another subject, or files of others.
  ResultsFolder(const std::filesystem::path& folder, Results kind, const std::string& subject = "",
                bool replace = false);
  ~ResultsFolder();
  ResultsFolder(const ResultsFolder&) = delete;
  ResultsFolder& operator=(const ResultsFolder&) = delete;

 private:
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> made_;  ///< inmost first
  FolderLock lock_;
};

/// The line by which files know the job that they are of.
std::string job_line(const std::string& identity);

/// The error of a folder with the runs of another job.
InputError other_job(const std::filesystem::path& folder);

/// Finished parts of a job in a file that only grows, so that a job that was killed can go on: a head line
/// that names the job, then one entry a part, with its length and checksum. An entry that is torn, and what
/// follows it, is dropped when the file is opened again.
class Journal {
 public:
  /// Opens DIR/runs.journal, or starts one for the job of that identity. The folder is this process's own.
  /// @throws InputError where it belongs to another job; std::runtime_error where it cannot be written.
  Journal(const std::filesystem::path& folder, const std::string& identity);

  bool has(std::size_t part) const { return entries_.contains(part); }

  /// Adds a part that is not there yet. @throws std::runtime_error where it cannot be written.
  void append(std::size_t part, const std::string& text);

  /// A part that is there. @throws std::runtime_error where it cannot be read.
  std::string text(std::size_t part) const;

  /// Writes all parts in the order of their numbers.
  void copy_to(const Sink& put) const;

 private:
  struct Entry {
    std::uint64_t begin, length;  ///< of the text in the file, bytes
  };

  void write(std::string_view text);

  std::filesystem::path file_;
  Descriptor descriptor_;
  std::uint64_t end_ = 0;  ///< of the last whole entry, bytes
  std::map<std::size_t, Entry> entries_;
};

}  // namespace rockstack
