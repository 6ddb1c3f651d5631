#include "comparisons/measures/results/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "analytic/scene/messages/input_error.hpp"

namespace rockstack {
namespace {

std::string entry_line(std::size_t part, std::string_view text) {
  return fmt::format("part {} {} {:016x}\n", part, text.size(), checksum(text));
}

/// The next entry of a journal: its number and text. False where none follows whole.
bool read_entry(std::istream& in, std::uint64_t rest, std::size_t& part, std::string& text) {
  std::string line, word;
  if (!std::getline(in, line) || in.eof()) return false;
  std::istringstream words(line);
  std::uint64_t length = 0;
  if (!(words >> word >> part >> length) || length > rest) return false;
  text.resize(length);
  in.read(text.data(), static_cast<std::streamsize>(length));
  return in && line + "\n" == entry_line(part, text);
}

}  // namespace

Journal::Journal(const std::filesystem::path& folder, const std::string& identity)
    : file_(folder / "runs.journal") {
  descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor_ < 0) {
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", file_.string(), std::strerror(errno)));
  }
  try {
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
      throw InputError(
          fmt::format("--out {}: must be left alone while another sweep writes into it", folder.string()));
    }
    scan(fmt::format("rockstack sweep {:016x}\n", checksum(identity)));
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

Journal::~Journal() {
  ::close(descriptor_);
}

void Journal::scan(const std::string& head) {
  std::ifstream in(file_, std::ios::binary);
  const std::uint64_t size = std::filesystem::file_size(file_);
  std::string found(std::min<std::uint64_t>(size, head.size()), '\0');
  in.read(found.data(), static_cast<std::streamsize>(found.size()));
  if (!head.starts_with(found)) {
    throw InputError(fmt::format(
        "--out {}: must be a folder of its own: it holds a sweep of another ensemble, or by another build",
        file_.parent_path().string()));
  }
  const bool whole = found.size() == head.size();
  end_ = whole ? head.size() : 0;
  std::size_t part = 0;
  for (std::string text; whole && read_entry(in, size - end_, part, text);) {
    const auto end = static_cast<std::uint64_t>(in.tellg());
    entries_[part] = {end - text.size(), text.size()};
    end_ = end;
  }
  if (::ftruncate(descriptor_, static_cast<off_t>(end_)) != 0) {
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", file_.string(), std::strerror(errno)));
  }
  if (!whole) write(head);
}

void Journal::write(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::pwrite(descriptor_, text.data(), text.size(), static_cast<off_t>(end_));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      throw std::runtime_error(
          fmt::format("{}: cannot be written: {}", file_.string(), std::strerror(errno)));
    }
    end_ += static_cast<std::uint64_t>(written);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void Journal::append(std::size_t part, const std::string& text) {
  write(entry_line(part, text) + text);
  entries_[part] = {end_ - text.size(), text.size()};
}

void Journal::copy_to(const Sink& put) const {
  std::ifstream in(file_, std::ios::binary);
  std::string text;
  for (const auto& [part, entry] : entries_) {
    text.resize(entry.length);
    in.seekg(static_cast<std::streamoff>(entry.begin));
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    put(text);
  }
  if (!in) throw std::runtime_error(file_.string() + ": cannot be read");
}

}  // namespace rockstack
