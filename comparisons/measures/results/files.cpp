#include "comparisons/measures/results/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>
#include <system_error>

#include "analytic/scene/messages/input_error.hpp"
#include "analytic/scene/messages/one_line.hpp"

namespace rockstack {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file) {
  throw std::runtime_error(fmt::format("{}: cannot be written: {}", file.string(), std::strerror(errno)));
}

void write_all(int descriptor, std::string_view text, const std::filesystem::path& file) {
  while (!text.empty()) {
    const ssize_t written = write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail(file);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

struct Kind {
  const char* name;
  std::initializer_list<const char*> derived;  ///< from runs, or by a command that has none
};

/// In the order of Results.
constexpr Kind kinds[]{
    {"one motion",
     {"summary.json", "history.csv", "events.csv", "reactions.csv", "energies.csv", "corners.csv",
      "ground.csv", "branches.csv", "branches", "figures", "report.html"}},
    {"a comparison",
     {"comparison.json", "comparison.csv", "fits.csv", "distributions.csv", "spread.csv", "ranking.csv",
      "ground", "figures", "report.html"}},
    {"a lesson",
     {"lesson.html", "slides.html", "slides.pdf", "lesson.json", "comparison.json", "comparison.csv",
      "fits.csv", "distributions.csv", "ground", "figures", "report.html"}},
    {"advice", {"advice.json", "advice.csv", "figures", "report.html"}},
    {"a study of stability",
     {"stability.json", "stability.csv", "steps.csv", "comparison.json", "comparison.csv", "fits.csv",
      "distributions.csv", "ground", "figures", "report.html"}},
    {"a study of impact laws",
     {"impact-laws.json", "impact-laws.csv", "impact-laws-engines.csv", "impact-laws-kinds.csv",
      "impact-laws-answers.csv", "impact-laws-sets.csv", "impact-laws-states.csv", "figures", "report.html"}},
    {"a sweep",
     {"sweep.json", "runs.csv", "timing.json", "fragility.csv", "fragility-fit.csv", "incremental.csv",
      "incremental.npz", "incremental-fractiles.csv", "overturning.csv", "overturning.npz", "modes.csv",
      "modes.npz", "figures", "report.html"}},
    {"a record", {"record.json", "record.csv", "spectrum.csv", "figures", "report.html"}},
    {"results held together", {"diff.json", "diff.csv", "report.html"}},
    {"a canon", {"canon.json", "canon.csv", "checks.json", "checks.csv", "report.html"}},
    {"a course", {"index.html", "glossary.html", "course.json", "solver.js"}},
    {"problem sheets", {}},
    {"a fit", {"fit.json", "fit.csv", "figures", "report.html"}},
    {"a threshold",
     {"threshold.json", "threshold.csv", "threshold-ranges.csv", "threshold-spectrum.csv", "figures",
      "report.html"}},
    {"a round column",
     {"round.json", "history.csv", "events.csv", "threshold.csv", "figures", "report.html"}},
};

namespace fs = std::filesystem;

constexpr const char* mark_name = ".results";

/// What a command that was stopped goes on from.
constexpr std::initializer_list<const char*> gone_on_from{"runs", "runs.journal", "runs.npz", "failures.csv",
                                                          "answers"};

/// The kind of results that a folder holds, and what they are of; empty where it says neither.
std::pair<std::string, std::string> read_mark(const fs::path& folder) {
  std::pair<std::string, std::string> mark;
  std::error_code ignored;
  if (!fs::is_regular_file(folder / mark_name, ignored)) return mark;
  std::ifstream in(folder / mark_name);
  std::getline(in, mark.first);
  std::getline(in, mark.second);
  return mark;
}

InputError no_folder(const fs::path& folder, const std::string& why) {
  return InputError(fmt::format("--out {}: must be a folder that can be written: {}", folder.string(), why));
}

/// Makes a folder with those that it lies in, and returns those that were not there.
std::vector<fs::path> make_folders(const fs::path& folder) {
  std::vector<fs::path> made;
  std::error_code error;
  for (fs::path above = fs::absolute(folder); !fs::exists(above, error) && above != above.root_path();
       above = above.parent_path())
    made.push_back(above);
  fs::create_directories(folder, error);
  if (!error && !fs::is_directory(folder, error)) error = std::make_error_code(std::errc::not_a_directory);
  if (error) throw no_folder(folder, error.message());
  return made;
}

/// The first file that is no mark of ours; hidden ones belong to the desktop.
std::optional<std::string> foreign_file(const fs::path& folder) {
  std::set<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    names.insert(entry.path().filename().string());
  std::erase_if(names, [](const std::string& name) { return name.starts_with('.'); });
  return names.empty() ? std::nullopt : std::optional(*names.begin());
}

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

Descriptor::~Descriptor() {
  if (number_ >= 0) close(number_);
}

FolderLock::FolderLock(const std::filesystem::path& folder)
    : Descriptor(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (number() >= 0 && flock(number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    throw InputError(
        fmt::format("--out {}: must be a folder that no other run writes into just now", folder.string()));
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
  std::string name = one_line(text);
  for (const char leading : {'/', '\\'}) std::ranges::replace(name, leading, '-');
  if (name.starts_with('.')) name.front() = '-';
  if (name == text && !text.empty() && text.size() <= longest) return text;
  std::size_t end = std::min(front, name.size());
  while (end < name.size() && (static_cast<unsigned char>(name[end]) & 0xc0U) == 0x80)
    --end;  // not inside a letter
  return fmt::format("{}-{:016x}", name.substr(0, end), checksum(text));
}

void write_file(const std::filesystem::path& file, std::string_view content) {
  write_file(file, [content](const Sink& put) { put(content); });
}

void write_file(const std::filesystem::path& file, const std::function<void(const Sink&)>& write) {
  replace_file(file, [&](const std::filesystem::path& own) {
    const Descriptor partial(open(own.c_str(), O_WRONLY | O_CLOEXEC));
    if (partial.number() < 0) fail(file);
    write([&](std::string_view text) { write_all(partial.number(), text, file); });
  });
}

void replace_file(const std::filesystem::path& file,
                  const std::function<void(const std::filesystem::path&)>& write) {
  const std::string own = file.string() + ".partial";
  // Made new: what a killed run has left goes, and a link leads nowhere.
  unlink(own.c_str());
  const Descriptor partial(open(own.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (partial.number() < 0) fail(file);
  try {
    write(own);
    // On the disk first, then in its place: a machine that stops leaves it whole or not there.
    const bool on_disk = fsync(partial.number()) == 0 || errno == EINVAL;  // where it cannot be asked
    if (!on_disk || rename(own.c_str(), file.c_str()) != 0) fail(file);
  } catch (...) {
    unlink(own.c_str());
    throw;
  }
}

ResultsFolder::ResultsFolder(const fs::path& folder, Results results, const std::string& subject,
                             bool replace)
    : folder_(folder), made_(make_folders(folder)), lock_(folder) {
  const Kind& kind = kinds[static_cast<std::size_t>(results)];
  const auto [found, of] = read_mark(folder);
  if (!found.empty() && found != kind.name)
    throw InputError(
        fmt::format("--out {}: must be a folder of its own: it holds {}", folder.string(), found));
  const bool other = !of.empty() && !subject.empty() && of != one_line(subject);
  if (other && !replace)
    throw InputError(fmt::format(
        "--out {}: must be a folder of its own: it holds {} of {}; --replace puts {} in its place",
        folder.string(), found, of, subject));
  if (const auto foreign = foreign_file(folder); foreign && found.empty())
    throw InputError(fmt::format("--out {}: must be empty or hold results: {} is there, and is not ours",
                                 folder.string(), *foreign));
  try {
    write_file(folder / mark_name,
               fmt::format("{}\n{}\n", kind.name, subject.empty() ? of : one_line(subject)));
  } catch (const std::runtime_error& failure) {
    throw no_folder(folder, failure.what());
  }
  for (const char* name : kind.derived) fs::remove_all(folder / name);
  if (other)
    for (const char* name : gone_on_from) fs::remove_all(folder / name);
}

ResultsFolder::~ResultsFolder() {
  std::error_code ignored;
  if (made_.empty() || foreign_file(folder_)) return;
  fs::remove(folder_ / mark_name, ignored);
  for (const fs::path& folder : made_) fs::remove(folder, ignored);
}

std::string job_line(const std::string& identity) {
  return fmt::format("rockstack sweep {:016x}\n", checksum(identity));
}

InputError other_job(const std::filesystem::path& folder) {
  return InputError(fmt::format(
      "--out {}: must be a folder of its own: it holds a sweep of another ensemble, in another format, or by another build",
      folder.string()));
}

Journal::Journal(const std::filesystem::path& folder, const std::string& identity)
    : file_(folder / "runs.journal"),
      descriptor_(open(file_.c_str(), O_RDWR | O_APPEND | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666)) {
  if (descriptor_.number() < 0) fail(file_);
  const std::string head = job_line(identity);
  std::ifstream in(file_, std::ios::binary);
  const std::uint64_t size = std::filesystem::file_size(file_);
  std::string found(std::min<std::uint64_t>(size, head.size()), '\0');
  in.read(found.data(), static_cast<std::streamsize>(found.size()));
  if (!head.starts_with(found)) throw other_job(file_.parent_path());
  const bool whole = found.size() == head.size();
  end_ = whole ? head.size() : 0;
  std::size_t part = 0;
  for (std::string text; whole && read_entry(in, size - end_, part, text);) {
    const auto end = static_cast<std::uint64_t>(in.tellg());
    entries_[part] = {end - text.size(), text.size()};
    end_ = end;
  }
  if (ftruncate(descriptor_.number(), static_cast<off_t>(end_)) != 0) fail(file_);
  if (!whole) write(head);
}

void Journal::write(std::string_view text) {
  write_all(descriptor_.number(), text, file_);
  end_ += text.size();
}

void Journal::append(std::size_t part, const std::string& text) {
  write(entry_line(part, text) + text);
  entries_[part] = {end_ - text.size(), text.size()};
}

std::string Journal::text(std::size_t part) const {
  const Entry& entry = entries_.at(part);
  std::string text(entry.length, '\0');
  for (std::size_t there = 0; there < text.size();) {
    const ssize_t got = pread(descriptor_.number(), text.data() + there, text.size() - there,
                              static_cast<off_t>(entry.begin + there));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) throw std::runtime_error(file_.string() + ": cannot be read");
    there += static_cast<std::size_t>(got);
  }
  return text;
}

void Journal::copy_to(const Sink& put) const {
  for (const auto& [part, entry] : entries_) put(text(part));
}

}  // namespace rockstack
