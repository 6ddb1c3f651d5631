#include "comparisons/measures/results/csv.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

#include "analytic/scene/messages/input_error.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

std::filesystem::path file_with(const std::string& text) {
  static const TemporaryFolder folder;
  return folder.write("table.csv", text);
}

/// The error that `read` raises; the test fails where there is none.
template <class Read>
std::string error_of(const Read& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InputError";
  return "";
}

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(Table, ReadsQuotedCellsAndEmptyOnes) {
  const Table table = read_table(file_with("a,b,c\n1,\"x, \"\"y\"\"\",\n,,3\r\n"));
  EXPECT_EQ(table.columns, (std::vector<std::string>{"a", "b", "c"}));
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0], (std::vector<std::string>{"1", "x, \"y\"", ""}));
  EXPECT_EQ(table.rows[1], (std::vector<std::string>{"", "", "3"}));
}

TEST(CsvWriter, TextsReadBackAsTheyWere) {
  for (const std::string text : {"plain", "with, comma", "with \"quotes\"", ""}) {
    CsvWriter csv;
    csv.line("a", "b");
    csv.line(text, "");
    EXPECT_EQ(read_table(file_with(csv.text())).rows[0][0], text);
  }
  CsvWriter csv;
  csv.line("two\nlines");
  EXPECT_EQ(csv.text(), "\"two lines\"\n");
}

TEST(CsvWriter, TextsThatASpreadsheetWouldComputeAreGuardedAndReadBackAsTheyWere) {
  for (const std::string text : {"=1+1", "@SUM(A1)", "-x", "+x", "\tx", "'=1", "''=1", "=a,b"}) {
    CsvWriter csv;
    csv.line(text);
    EXPECT_TRUE(csv.text().starts_with('\'') || csv.text().starts_with("\"'")) << csv.text();
    EXPECT_EQ(read_table(file_with("a\n" + csv.text())).rows[0][0], text);
  }
  CsvWriter csv;
  csv.line("-0.5", "-0.5 1e-3", "'quoted'");
  EXPECT_EQ(csv.text(), "-0.5,-0.5 1e-3,'quoted'\n");
}

TEST(CsvWriter, ACellANumberATruthAnElementAndAnOptional) {
  CsvWriter csv;
  csv.add(0.1 + 0.2, -3, std::size_t{7}, true);
  csv.line(std::vector<double>{1, 0.5}, std::optional<int>(), std::optional(2.5));
  csv.line("next", std::vector<std::string>{"a", "b"});
  EXPECT_EQ(csv.text(), "0.30000000000000004,-3,7,true,1,0.5,,2.5\nnext,a,b\n");
}

TEST(CsvWriter, NumbersReadBackToTheSameDouble) {
  for (const double number : {1.0 / 3, 1e-300, -0.0, 4.9406564584124654e-324, 1.7976931348623157e308, 1e16}) {
    CsvWriter csv;
    csv.line("x");
    csv.line(number);
    const double read = read_columns(file_with(csv.text()), {"x"})[0][0];
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read), std::bit_cast<std::uint64_t>(number)) << number;
  }
}

TEST(Table, NumbersReadBackToTheSameDoubleAndEmptyIsNotANumber) {
  const auto columns =
      read_columns(file_with("time,x,y\n0.1,1e-300,5\n0.30000000000000004,,6\n"), {"x", "time"});
  EXPECT_EQ(columns[0][0], 1e-300);
  EXPECT_TRUE(std::isnan(columns[0][1]));
  EXPECT_EQ(columns[1][1], 0.1 + 0.2);
}

TEST(Table, ARowOfAnotherWidthIsNamedByFileAndLine) {
  const auto file = file_with("a,b\n1,2\n3\n");
  expect_part(error_of([&] { read_table(file); }), file.string() + ":3: 1 cells; must be 2");
}

TEST(Table, AWordInPlaceOfANumberIsNamedByFileLineAndColumn) {
  const auto file = file_with("time,x\n0,1\n1,two\n");
  expect_part(error_of([&] { read_columns(file, {"x"}); }),
              file.string() + ":3: x = \"two\": must be a number");
}

TEST(Table, AWholeNumberIsWithinItsRangeOrNamed) {
  const auto whole = [](const std::string& cell) {
    CsvLine line(file_with("number,interface\n1," + cell + "\n"));
    line.next();
    return line.whole(line.index("interface"), 1, 3);
  };
  EXPECT_EQ(whole("3"), 3);
  for (const char* cell : {"0", "4", "1.5", "1e300", "-1e300", "inf", "nan", ""})
    expect_part(error_of([&] { whole(cell); }), "table.csv:2: interface = ");
}

TEST(Table, AMissingColumnIsNamed) {
  const auto file = file_with("time\n0\n");
  expect_part(error_of([&] { read_columns(file, {"theta_1"}); }), file.string() + ":1: no column theta_1");
}

TEST(Table, OpenQuotesEmptyFilesAndMissingFilesAreErrors) {
  expect_part(error_of([] { read_table(file_with("a\n\"b\n")); }), ":2: a quote is not closed");
  expect_part(error_of([] { read_table(file_with("a\n\"b\"c\n")); }), ":2: text after a closing quote");
  expect_part(error_of([] { read_table(file_with("")); }), ":1: empty");
  expect_part(error_of([] { read_table("no/such.csv"); }), "no/such.csv: must be a file, nothing is there");
  for (const char* name : {"/dev/zero", "/dev/null", "/tmp"})
    expect_part(error_of([&] { read_table(name); }), "must be a file, this is a folder, a pipe or a device");
}

}  // namespace
}  // namespace rockstack
