#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <filesystem>
#include <fstream>
#include <locale>

#include "analytic/scene/ground/records/record_file.hpp"
#include "analytic/scene/messages/input_error.hpp"
#include "tests/analytic/scene/ground/records/layouts.hpp"
#include "tests/analytic/scene/ground/records/mutations.hpp"

namespace rockstack {
namespace {

class RecordFile : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  std::string error_of(const std::string& name) const {
    try {
      read_record(folder_ / name);
    } catch (const InputError& error) {
      const std::string line = error.what();
      return line.substr(line.find("/here/") + 6);
    }
    return {};
  }

  /// One a test: tests run at the same time.
  const std::filesystem::path folder_ = std::filesystem::temp_directory_path() / "rockstack-records" /
                                        testing::UnitTest::GetInstance()->current_test_info()->name() /
                                        "here";
};

TEST_F(RecordFile, NameDoesNotMatterForTheFormat) {
  EXPECT_EQ(read_record(write("record.smc", peer_text(made_up_samples()))).format, "PEER AT2");
}

TEST_F(RecordFile, FirstChannelIsReadUnlessAnotherIsNamed) {
  const std::string name =
      write("three.v2", volume2_channel(made_up_samples(4)) + volume2_channel(made_up_samples(5)) +
                            volume2_channel(made_up_samples(6)))
          .string();
  EXPECT_EQ(read_record(name).samples.size(), 4U);
  EXPECT_EQ(read_record(name + ":1").samples.size(), 4U);
  EXPECT_EQ(read_record(name + ":3").samples.size(), 6U);
  EXPECT_EQ(record_file(name + ":3"), name);
  EXPECT_EQ(record_file(name), name);
  EXPECT_EQ(error_of("three.v2:4"), "three.v2: no channel 4: must be 1 to 3");
  EXPECT_EQ(error_of("three.v2:0"), "three.v2: no channel 0: must be 1 to 3");
}

TEST_F(RecordFile, ColonMayBelongToTheName) {
  const auto name = write("a:2", peer_text(made_up_samples()));
  EXPECT_EQ(record_file(name), name);
  EXPECT_EQ(read_record(name).samples.size(), 19U);
  EXPECT_EQ(error_of("a:b"), "a:b: must be a file, nothing is there");
}

TEST_F(RecordFile, MissingEmptyAndOtherFilesAreRefused) {
  EXPECT_EQ(error_of("nothing.at2"), "nothing.at2: must be a file, nothing is there");
  EXPECT_EQ(error_of("nothing.at2:2"), "nothing.at2: must be a file, nothing is there");
  std::filesystem::create_directory(folder_ / "folder");
  EXPECT_EQ(error_of("folder"), "folder: must be a file, this is a folder, a pipe or a device");
  write("empty", "");
  EXPECT_EQ(error_of("empty"), "empty:1: the file is empty");
  write("blank", "\xEF\xBB\xBF\r\n \n\n");
  EXPECT_EQ(error_of("blank"), "blank:1: the file is empty");
  write("prose", "Dear Sir,\nno record here.\n");
  EXPECT_EQ(error_of("prose"),
            "prose:1: not a known format: must be PEER AT2, COSMOS, CSMIP volume 2, USGS SMC, ESM, "
            "K-NET/KiK-net, GeoNet, ObsPy, columns of numbers");
}

TEST_F(RecordFile, BinaryIsRefusedAtItsFirstControlCharacter) {
  write("padding", std::string(9, '\0'));
  EXPECT_EQ(error_of("padding"), "padding:1: the file is empty");
  write("binary", "one\ntwo\n" + std::string("a\0b", 3));
  EXPECT_EQ(error_of("binary"), "binary:3: byte 0: not a text file");
}

TEST_F(RecordFile, CountsOfARecorderAreRefusedWithTheWayToConvertThem) {
  const std::string needs =
      " has no unit of acceleration: must be converted to columns of numbers, after the instrument's response "
      "is taken off (in ObsPy remove_response(inventory, output=\"ACC\"))";
  write("two.mseed", "000001D " + std::string(56, '\0'));
  EXPECT_EQ(error_of("two.mseed"), "two.mseed:1: MiniSEED" + needs);
  write("three.mseed", "MS\x03" + std::string(61, '\0'));
  EXPECT_EQ(error_of("three.mseed"), "three.mseed:1: MiniSEED" + needs);
  for (const std::size_t at : {304U, 307U}) {  // the lowest byte first, or last
    std::string sac(640, '\0');
    sac[at] = 6;
    write("a.sac", sac);
    EXPECT_EQ(error_of("a.sac"), "a.sac:1: SAC" + needs);
  }
}

TEST_F(RecordFile, WindowsLineEndsPaddingOfDosAndByteOrderMarkChangeNothing) {
  for (const std::string& text : one_of_each_layout()) {
    const Record plain = read_record(write("plain", text));
    for (const std::string& padding : {std::string("\x1A"), std::string(93, '\x1A'), std::string(93, '\0'),
                                       std::string("\x1A\r\n"), "\x1A" + std::string(7, '\0')}) {
      const Record dressed =
          read_record(write("dressed", "\xEF\xBB\xBF" + with_windows_line_ends(text) + padding));
      EXPECT_EQ(dressed.samples, plain.samples) << text;
      EXPECT_EQ(dressed.interval, plain.interval);
      EXPECT_EQ(dressed.format, plain.format);
    }
  }
}

TEST_F(RecordFile, LastLineNeedsNoEndWhereItsDigitsShowThatItIsWhole) {
  for (std::string text : one_of_each_layout()) {
    const Record whole = read_record(write("whole", text));
    text.pop_back();
    EXPECT_EQ(read_record(write("cut", text)).samples, whole.samples) << text;
  }
  for (const char* rows : {"0.1\n0.25\n0.3", "1\n12\n3", "0.5\n"})
    EXPECT_EQ(error_of_text(std::string("# dt = 0.01, units: m/s2\n") + rows).empty(),
              std::string(rows).ends_with('\n'));
}

TEST_F(RecordFile, CutInsideItsLastNumberIsRefused) {
  // The peak would be 64.8 instead of 8.83.
  EXPECT_EQ(error_of_text("# dt = 0.01, units: m/s2\n8.83e-00\n6.48e+0"),
            "file:3: this line has no end: its last number may be cut short; add a line end");
  for (std::string text : one_of_each_layout()) {
    const std::vector<double> whole = read_record(write("whole", text)).samples;
    for (text.pop_back(); !text.empty(); text.pop_back()) {
      if (outcome_of(text) == Outcome::refused) continue;
      const std::vector<double> rest = read_record(write("cut", text)).samples;
      ASSERT_LE(rest.size(), whole.size());
      EXPECT_TRUE(std::equal(rest.begin(), rest.end(), whole.begin())) << text;
    }
  }
}

struct DecimalComma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

TEST_F(RecordFile, LocaleChangesNothing) {
  const auto name = write("record", peer_text(made_up_samples()));
  const Record before = read_record(name);
  const std::locale standard = std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
  std::setlocale(LC_ALL, "de_DE.UTF-8");  // where there is such a one, for C's functions too
  const Record record = read_record(name);
  const std::string error = error_of_text(peer_text(made_up_samples(), "19", "-.01"));
  std::locale::global(standard);
  std::setlocale(LC_ALL, "C");
  EXPECT_EQ(record.samples, before.samples);
  EXPECT_EQ(record.interval, 0.005);
  EXPECT_EQ(error, "file:4: time step is -0.01 s: must be > 0");
}

}  // namespace
}  // namespace rockstack
