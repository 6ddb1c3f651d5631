#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rockstack {

/// A column of a table on its way into a file: what each row has, by its number from 0.
struct FileColumn {
  using Number = std::function<double(std::size_t row)>;  ///< NaN: none
  using Count = std::function<std::size_t(std::size_t row)>;
  using Text = std::function<std::string(std::size_t row)>;

  std::string name;
  std::variant<Number, Count, Text> cell;
};

/// Writes a table that numpy.load() reads column by column: a zip archive of one array a column, shape
/// (rows,), numbers as float64, texts as UTF-32 of the longest one's length. Cells are asked for column by
/// column, from the first row to the last, those of texts twice. `comment` is that of the archive. The bytes
/// depend on these alone.
/// Source: "NumPy enhancement proposal 1: a simple file format for NumPy arrays", version 1.0.
/// @throws std::runtime_error where the file cannot be written.
void write_npz(const std::filesystem::path& file, const std::vector<FileColumn>& columns, std::size_t rows,
               const std::string& comment = "");

/// The names of the columns, in the order of the file. @throws InputError where it is no such file.
std::vector<std::string> npz_names(const std::filesystem::path& file);

/// The comment of the archive. @throws InputError where it is none.
std::string npz_comment(const std::filesystem::path& file);

/// Bytes as zlib compresses them, and back from where they are known to be so many. @throws
/// std::runtime_error where they are not.
std::string compressed(std::string_view bytes);
std::string uncompressed(std::string_view bytes, std::size_t size);

/// One column of a file by write_npz(), row after row; a few kilobytes of it are in memory.
class NpzColumn {
 public:
  /// Stands before the first row. @throws InputError naming file and column: what is missing or malformed.
  NpzColumn(const std::filesystem::path& file, const std::string& name);
  ~NpzColumn();
  NpzColumn(NpzColumn&&) noexcept;
  NpzColumn& operator=(NpzColumn&&) = delete;

  /// Goes on to the next row; false at the end. @throws InputError where the file is damaged.
  bool next();
  /// The number in this row. @throws InputError in a column of texts.
  double value() const;
  /// The text in this row, or of a number number_text(); empty where there is none.
  std::string text() const;

 private:
  struct Source;
  std::unique_ptr<Source> source_;
};

}  // namespace rockstack
