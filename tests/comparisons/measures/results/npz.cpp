#include "comparisons/measures/results/npz.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>

#include "analytic/scene/messages/input_error.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/long_table.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

/// Doubles of random bits, of every kind, and the ends of their range: more than are read at once.
std::vector<double> any_numbers() {
  std::mt19937_64 random(1);
  std::vector<double> numbers{0.0,      -0.0,      std::nan(""),
                              HUGE_VAL, -HUGE_VAL, std::numeric_limits<double>::denorm_min()};
  for (int i = 0; i < 5000; ++i) numbers.push_back(std::bit_cast<double>(random()));
  return numbers;
}

const std::vector<std::string> any_texts{"", "slide-rock", "Größe, \"µ\"", "=1+1", "地震"};

std::vector<FileColumn> columns_of(const std::vector<double>& numbers) {
  return {{"number", FileColumn::Number([&](std::size_t row) { return numbers[row]; })},
          {"count", FileColumn::Count([](std::size_t row) { return row * 100000; })},
          {"text", FileColumn::Text([](std::size_t row) { return any_texts[row % any_texts.size()]; })}};
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void read_all(const std::filesystem::path& file) {
  for (const std::string& name : npz_names(file))
    for (NpzColumn column(file, name); column.next();) column.text();
}

TEST(Npz, ColumnsComeBackToTheBit) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "table.npz";
  const std::vector<double> numbers = any_numbers();
  write_npz(file, columns_of(numbers), numbers.size(), "what it is of\n");
  EXPECT_EQ(npz_names(file), (std::vector<std::string>{"number", "count", "text"}));
  EXPECT_EQ(npz_comment(file), "what it is of\n");
  NpzColumn number(file, "number"), count(file, "count"), text(file, "text");
  for (std::size_t row = 0; row < numbers.size(); ++row) {
    ASSERT_TRUE(number.next() && count.next() && text.next());
    EXPECT_EQ(std::bit_cast<std::uint64_t>(number.value()), std::bit_cast<std::uint64_t>(numbers[row]));
    EXPECT_EQ(count.value(), static_cast<double>(row) * 1e5);
    EXPECT_EQ(text.text(), any_texts[row % any_texts.size()]);
  }
  EXPECT_FALSE(number.next() || count.next() || text.next());
}

TEST(Npz, ATableWithoutRowsHasItsColumns) {
  const TemporaryFolder folder;
  write_npz(folder.path() / "table.npz", columns_of({}), 0);
  EXPECT_EQ(npz_names(folder.path() / "table.npz").size(), 3U);
  EXPECT_FALSE(NpzColumn(folder.path() / "table.npz", "text").next());
}

// Whatever the clock: archives keep times of their members.
TEST(Npz, BytesDependOnTheTableAlone) {
  const TemporaryFolder folder;
  const std::vector<double> numbers = any_numbers();
  const auto file = folder.path() / "table.npz";
  write_npz(file, columns_of(numbers), numbers.size());
  const std::string bytes = bytes_of(file);
  EXPECT_NE(bytes.find(std::string("\x00\x00\x21\x00", 4)), std::string::npos) << "1 January 1980";
  write_npz(file, columns_of(numbers), numbers.size());
  EXPECT_EQ(bytes_of(file), bytes);
}

// Members have checksums, and their places stand at the end.
TEST(Npz, DamageIsAnError) {
  const TemporaryFolder folder;
  const std::vector<double> numbers = any_numbers();
  const auto file = folder.path() / "table.npz";
  write_npz(file, columns_of(numbers), numbers.size());
  const std::string bytes = bytes_of(file);
  EXPECT_NO_THROW(read_all(file));
  for (const std::size_t place : {bytes.size() / 4, bytes.size() / 2}) {
    std::string wrong = bytes;
    wrong[place] = static_cast<char>(wrong[place] ^ 1);
    folder.write("table.npz", wrong);
    EXPECT_THROW(read_all(file), InputError) << place;
  }
  folder.write("table.npz", bytes.substr(0, bytes.size() / 2));
  EXPECT_THROW(read_all(file), InputError);
  folder.write("table.npz", bytes);
  EXPECT_THROW(NpzColumn(file, "other"), InputError);
  NpzColumn text(file, "text");
  text.next();
  EXPECT_THROW(text.value(), InputError);
}

TEST(Npz, CompressedBytesComeBack) {
  std::string bytes;
  for (const double number : any_numbers()) bytes += number_text(number);
  EXPECT_EQ(uncompressed(compressed(bytes), bytes.size()), bytes);
  EXPECT_EQ(uncompressed(compressed(""), 0), "");
  EXPECT_THROW(uncompressed(compressed(bytes), bytes.size() + 1), std::runtime_error);
}

// A table is named as a .csv file, wherever it lies.
TEST(LongTable, LinesAndColumnsAreTheSameRows) {
  const TemporaryFolder lines, columns;
  std::vector<double> numbers = any_numbers();
  std::erase_if(numbers, [](double number) { return std::isnan(number); });
  write_table(lines.path() / "table.csv", columns_of(numbers), numbers.size());
  write_table(columns.path() / "table.npz", columns_of(numbers), numbers.size());
  const auto line = lines.path() / "table.csv", column = columns.path() / "table.csv";
  EXPECT_EQ(table_file(line).filename(), "table.csv");
  EXPECT_EQ(table_file(column).filename(), "table.npz");
  EXPECT_EQ(column_names(line), column_names(column));
  TableRows a(line, {"text", "number", "count"}), b(column, {"text", "number", "count"});
  for (std::size_t row = 0; row < numbers.size(); ++row) {
    ASSERT_TRUE(a.next() && b.next());
    EXPECT_EQ(a.text(0), b.text(0));
    EXPECT_EQ(a.text(1), b.text(1));
    EXPECT_EQ(std::bit_cast<std::uint64_t>(a.value(1)), std::bit_cast<std::uint64_t>(b.value(1)));
    EXPECT_EQ(a.value(2), b.value(2));
  }
  EXPECT_FALSE(a.next() || b.next());
  EXPECT_EQ(table_columns(line, {"count"}), table_columns(column, {"count"}));
  EXPECT_THROW(TableRows(column, {"other"}), InputError);
  EXPECT_THROW(column_names(lines.path() / "nowhere.csv"), InputError);
}

}  // namespace
}  // namespace rockstack
