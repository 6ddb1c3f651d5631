#include "comparisons/measures/results/npz.hpp"

#include <fmt/format.h>
#include <minizip/unzip.h>
#include <minizip/zip.h>

#include <algorithm>
#include <bit>
#include <boost/locale/encoding_utf.hpp>
#include <cmath>
#include <cstring>

#include "analytic/scene/lists.hpp"
#include "analytic/scene/messages/input_error.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/files.hpp"

namespace rockstack {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are written as they lie in memory");

constexpr std::string_view array_ending = ".npy", array_magic = "\x93NUMPY\x01";
constexpr std::size_t chunk = 1 << 14;  // bytes that are compressed, or read, at once

std::u32string letters_of(const std::string& text) {
  return boost::locale::conv::utf_to_utf<char32_t>(text);
}

template <class Part>
std::string_view bytes_of(const Part* parts, std::size_t count) {
  return {reinterpret_cast<const char*>(parts), count * sizeof(Part)};
}

/// An archive on its way into a file.
class ZipWriter {
 public:
  ZipWriter(const std::filesystem::path& own, std::filesystem::path shown)
      : shown_(std::move(shown)), zip_(zipOpen64(own.c_str(), APPEND_STATUS_CREATE)) {
    check(zip_ != nullptr);
  }
  ~ZipWriter() {
    if (zip_ != nullptr) zipClose(zip_, nullptr);
  }
  ZipWriter(const ZipWriter&) = delete;
  ZipWriter& operator=(const ZipWriter&) = delete;

  void begin(const std::string& name) {
    zip_fileinfo about{};
    about.tmz_date.tm_year = 1980;  // the first date that archives know, whatever the clock
    about.tmz_date.tm_mday = 1;
    check(zipOpenNewFileInZip64(zip_, name.c_str(), &about, nullptr, 0, nullptr, 0, nullptr, Z_DEFLATED,
                                Z_BEST_SPEED, 1) == ZIP_OK);
  }
  void put(std::string_view bytes) {
    waiting_ += bytes;
    if (waiting_.size() >= chunk) write();
  }
  void end() {
    write();
    check(zipCloseFileInZip(zip_) == ZIP_OK);
  }
  void close(const std::string& comment) {
    check(zipClose(std::exchange(zip_, nullptr), comment.c_str()) == ZIP_OK);
  }

 private:
  void check(bool well) const {
    if (!well) throw std::runtime_error(shown_.string() + ": cannot be written");
  }
  void write() {
    check(zipWriteInFileInZip(zip_, waiting_.data(), static_cast<unsigned>(waiting_.size())) == ZIP_OK);
    waiting_.clear();
  }

  std::filesystem::path shown_;
  zipFile zip_;
  std::string waiting_;
};

/// What an array begins with.
std::string array_head(const std::string& type, std::size_t rows) {
  std::string words = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({},), }}", type, rows);
  constexpr std::size_t before = 10, alignment = 64;
  words.append(alignment - 1 - (before + words.size()) % alignment, ' ');
  words += '\n';
  const auto length = static_cast<std::uint16_t>(words.size());
  return std::string(array_magic) + '\0' + std::string(bytes_of(&length, 1)) + words;
}

void write_numbers(ZipWriter& zip, const FileColumn::Number& cell, std::size_t rows) {
  zip.put(array_head("<f8", rows));
  for (std::size_t row = 0; row < rows; ++row) {
    const double value = cell(row);
    zip.put(bytes_of(&value, 1));
  }
}

void write_texts(ZipWriter& zip, const FileColumn::Text& cell, std::size_t rows) {
  std::size_t width = 1;
  for (std::size_t row = 0; row < rows; ++row) width = std::max(width, letters_of(cell(row)).size());
  zip.put(array_head(fmt::format("<U{}", width), rows));
  for (std::size_t row = 0; row < rows; ++row) {
    std::u32string letters = letters_of(cell(row));
    letters.resize(width);
    zip.put(bytes_of(letters.data(), width));
  }
}

InputError damaged(const std::filesystem::path& file, const std::string& name) {
  return InputError(fmt::format("{}: {}: must be an array as numpy writes it, whole", file.string(), name));
}

/// An archive that is read, closed with this.
using OpenZip = std::unique_ptr<void, decltype(&unzClose)>;

OpenZip open_zip(const std::filesystem::path& file) {
  OpenZip zip(unzOpen64(file.c_str()), &unzClose);
  if (zip == nullptr) throw InputError(file.string() + ": cannot be read as an archive of columns");
  return zip;
}

}  // namespace

void write_npz(const std::filesystem::path& file, const std::vector<FileColumn>& columns, std::size_t rows,
               const std::string& comment) {
  replace_file(file, [&](const std::filesystem::path& own) {
    ZipWriter zip(own, file);
    for (const FileColumn& column : columns) {
      zip.begin(column.name + std::string(array_ending));
      if (const auto* text = std::get_if<FileColumn::Text>(&column.cell)) write_texts(zip, *text, rows);
      if (const auto* number = std::get_if<FileColumn::Number>(&column.cell))
        write_numbers(zip, *number, rows);
      if (const auto* count = std::get_if<FileColumn::Count>(&column.cell))
        write_numbers(
            zip, [&](std::size_t row) { return static_cast<double>((*count)(row)); }, rows);
      zip.end();
    }
    zip.close(comment);
  });
}

std::vector<std::string> npz_names(const std::filesystem::path& file) {
  const OpenZip zip = open_zip(file);
  std::vector<std::string> names;
  for (int found = unzGoToFirstFile(zip.get()); found == UNZ_OK; found = unzGoToNextFile(zip.get())) {
    unz_file_info64 about{};
    unzGetCurrentFileInfo64(zip.get(), &about, nullptr, 0, nullptr, 0, nullptr, 0);
    std::string& name = names.emplace_back(about.size_filename, '\0');
    unzGetCurrentFileInfo64(zip.get(), nullptr, name.data(), about.size_filename, nullptr, 0, nullptr, 0);
    if (!name.ends_with(array_ending)) throw damaged(file, name);
    name.resize(name.size() - array_ending.size());
  }
  return names;
}

std::string npz_comment(const std::filesystem::path& file) {
  const OpenZip zip = open_zip(file);
  unz_global_info64 about{};
  unzGetGlobalInfo64(zip.get(), &about);
  std::string comment(about.size_comment, '\0');
  if (unzGetGlobalComment(zip.get(), comment.data(), about.size_comment) < 0) throw damaged(file, "comment");
  return comment;
}

std::string compressed(std::string_view bytes) {
  unsigned long size = compressBound(bytes.size());
  std::string into(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(into.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                bytes.size(), Z_BEST_SPEED) != Z_OK)
    throw std::runtime_error("bytes cannot be compressed");
  into.resize(size);
  return into;
}

std::string uncompressed(std::string_view bytes, std::size_t size) {
  unsigned long there = size;
  std::string into(size, '\0');
  if (uncompress(reinterpret_cast<Bytef*>(into.data()), &there, reinterpret_cast<const Bytef*>(bytes.data()),
                 bytes.size()) != Z_OK ||
      there != size)
    throw std::runtime_error("compressed bytes are damaged");
  return into;
}

struct NpzColumn::Source {
  Source(std::filesystem::path its_file, std::string its_name)
      : file(std::move(its_file)), name(std::move(its_name)), zip(open_zip(file)) {
    const std::string member = name + std::string(array_ending);
    if (unzLocateFile(zip.get(), member.c_str(), 1) != UNZ_OK)
      throw InputError(fmt::format("{}: no column {}", file.string(), name));
    if (unzOpenCurrentFile(zip.get()) != UNZ_OK) throw damaged(file, name);
    read_head();
  }

  /// So many bytes; fewer at the end alone.
  std::string read(std::size_t count) {
    std::string piece(count, '\0');
    std::size_t there = 0;
    while (there < count) {
      const int got =
          unzReadCurrentFile(zip.get(), piece.data() + there, static_cast<unsigned>(count - there));
      if (got < 0) throw damaged(file, name);
      if (got == 0) break;
      there += static_cast<std::size_t>(got);
    }
    piece.resize(there);
    return piece;
  }

  void read_head() {
    const std::string before = read(10);
    std::uint16_t length = 0;
    if (before.size() < 10 || !before.starts_with(array_magic)) throw damaged(file, name);
    std::memcpy(&length, before.data() + 8, sizeof length);
    const std::string words = read(length);
    unsigned long long count = 0;
    unsigned width = 2;  // a number's, in letters
    is_text = std::sscanf(words.c_str(), "{'descr': '<U%u', 'fortran_order': False, 'shape': (%llu,)", &width,
                          &count) == 2;
    if (!is_text &&
        std::sscanf(words.c_str(), "{'descr': '<f8', 'fortran_order': False, 'shape': (%llu,)", &count) != 1)
      throw damaged(file, name);
    rows = count;
    size = width * sizeof(char32_t);
  }

  /// Goes on; false at the end, where the archive's checksum has been held against what was read.
  bool next() {
    if (left == 0) {
      if (rows == 0) return false;
      left = std::min<std::size_t>(rows, std::max<std::size_t>(1, chunk / size));
      bytes = read(left * size);
      if (bytes.size() < left * size) throw damaged(file, name);
      rows -= left;
      if (rows == 0 && (!read(1).empty() || unzCloseCurrentFile(zip.get()) != UNZ_OK))
        throw damaged(file, name);
      place = 0;
    } else {
      place += size;
    }
    --left;
    return true;
  }

  std::filesystem::path file;
  std::string name;
  OpenZip zip;
  bool is_text = false;
  std::size_t size = 0;             ///< of a cell, bytes
  std::size_t rows = 0;             ///< not read yet
  std::string bytes;                ///< read
  std::size_t place = 0, left = 0;  ///< of the cell in them; cells behind it
};

NpzColumn::NpzColumn(const std::filesystem::path& file, const std::string& name)
    : source_(std::make_unique<Source>(file, name)) {}
NpzColumn::~NpzColumn() = default;
NpzColumn::NpzColumn(NpzColumn&&) noexcept = default;

bool NpzColumn::next() {
  return source_->next();
}

double NpzColumn::value() const {
  if (source_->is_text)
    throw InputError(fmt::format("{}: {}: must be numbers", source_->file.string(), source_->name));
  double number = 0;
  std::memcpy(&number, source_->bytes.data() + source_->place, sizeof number);
  return number;
}

std::string NpzColumn::text() const {
  if (!source_->is_text) return std::isnan(value()) ? "" : number_text(value());
  std::u32string letters(source_->size / sizeof(char32_t), U'\0');
  std::memcpy(letters.data(), source_->bytes.data() + source_->place, source_->size);
  letters.resize(std::min(letters.find(U'\0'), letters.size()));
  return boost::locale::conv::utf_to_utf<char>(letters);
}

}  // namespace rockstack
