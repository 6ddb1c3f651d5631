#include <gtest/gtest.h>

#include <cmath>

#include "analytic/scene/ground/records/record_file.hpp"
#include "tests/analytic/scene/ground/records/layouts.hpp"

namespace rockstack {
namespace {

void expect_samples(const Record& record, const std::vector<double>& samples, double unit) {
  ASSERT_EQ(record.samples.size(), samples.size());
  for (std::size_t k = 0; k < samples.size(); ++k) EXPECT_DOUBLE_EQ(record.samples[k], samples[k] * unit);
}

TEST(CosmosRecord, TakesUnitFromTheDataLineAndStepFromTheRealHeader) {
  const Record record = read_text(cosmos_channel(made_up_samples()));
  EXPECT_EQ(record.format, "COSMOS");
  EXPECT_DOUBLE_EQ(record.interval, 0.01);
  expect_samples(record, made_up_samples(), gal);
}

TEST(CosmosRecord, UnitMayBeGravity) {
  const std::string text =
      with(cosmos_channel(made_up_samples(), "acceleration", "g(02)"), "       4", "       2");
  expect_samples(read_text(text), made_up_samples(), 9.80665);
}

TEST(CosmosRecord, StepOfTheRecorderStandsInWhereThatOfTheSeriesIsNull) {
  const std::string text = with(cosmos_channel(made_up_samples()), "    10.000000", "  -999.000000");
  EXPECT_DOUBLE_EQ(read_text(text).interval, 0.005);
  EXPECT_EQ(error_of_text(with(text, "     0.005000", "  -999.000000")),
            "file:22: the real header gives no time step, neither value 62 nor value 34");
}

TEST(CosmosRecord, ReadsColumnsWithoutBlanksBetween) {
  const std::string wide = in_columns(made_up_samples(), "%10.5f", 8);
  const std::string text =
      with(with(cosmos_channel(made_up_samples()), wide, in_columns(made_up_samples(), "%+7.4f", 8)),
           "8F10.5", "8F7.4");
  expect_samples(read_text(text), made_up_samples(), gal);
}

TEST(CosmosRecord, ChannelsComeInOrderAndOtherQuantitiesAreLeftOut) {
  const auto first = made_up_samples(5);
  const auto second = made_up_samples(9);
  const auto series =
      records::read_series("file", cosmos_channel(first) + cosmos_channel(first, "velocity", "cm/sec(05)") +
                                       cosmos_channel(second) + "\n");
  ASSERT_EQ(series.size(), 2U);
  expect_samples(series[0], first, gal);
  expect_samples(series[1], second, gal);
}

TEST(CosmosRecord, BlocksMayEndInWords) {
  const std::string text = with(cosmos_channel(made_up_samples()), "/&  ----------  End of data",
                                "End-of-data for Chan  1 acceleration");
  const auto series = records::read_series("file", text + text);
  ASSERT_EQ(series.size(), 2U);
  expect_samples(series[1], made_up_samples(), gal);
}

TEST(CosmosRecord, MistakesAreRefused) {
  const auto samples = made_up_samples();
  const std::string text = cosmos_channel(samples);
  EXPECT_EQ(error_of_text(cosmos_channel(samples, "velocity")), "file:1: holds no series of acceleration");
  EXPECT_EQ(error_of_text(cosmos_channel(samples, "acceleration", "counts(50)")),
            "file:22: units 'counts' are not known as acceleration: g and cm/sec2 are");
  EXPECT_EQ(error_of_text(cosmos_channel(samples, "acceleration", "g(02)")),
            "file:22: units 'g' contradict the integer header's unit code");
  EXPECT_EQ(error_of_text(with(text, "  19  accel", "  20  accel")),
            "file:25: this line has 3 values, too few");
  EXPECT_EQ(error_of_text(with(text, "  19  accel", "  18  accel")),
            "file:25: surplus '0.82500' at the end of this line");
  EXPECT_EQ(error_of_text(with(text, "(8F10.5)", "(eight)")),
            "file:22: '(eight)' is not a Fortran format of the kind (8F10.5)");
  EXPECT_EQ(error_of_text(with_line(text, 23, "-999.00000")), "file:23: '-999.00000' marks missing data");
  EXPECT_EQ(error_of_text(without_line(text, 26)),
            "file:25: the file ends here, before the end of data, \"/&\"");
  EXPECT_EQ(error_of_text(without_line(text, 5)), "file:5: expected the line of the integer-header");
  EXPECT_EQ(error_of_text(text.substr(0, text.find("| made up"))),
            "file:21: the file ends here, before the data");
}

TEST(Volume2Record, TakesAccelerationAndTheUnroundedStep) {
  const Record record = read_text(volume2_channel(made_up_samples()));
  EXPECT_EQ(record.format, "CSMIP volume 2");
  EXPECT_DOUBLE_EQ(record.interval, 0.0025);
  expect_samples(record, made_up_samples(), gal);
}

TEST(Volume2Record, ChannelsComeInOrder) {
  const auto series =
      records::read_series("file", volume2_channel(made_up_samples(5)) + volume2_channel(made_up_samples(9)));
  ASSERT_EQ(series.size(), 2U);
  expect_samples(series[0], made_up_samples(5), gal);
  expect_samples(series[1], made_up_samples(9), gal);
}

TEST(Volume2Record, OldFilesNameNoFormatAndHaveNoEndMark) {
  const std::string start = volume2_channel(made_up_samples());
  const std::string text = start.substr(0, start.find("   19 points of accel")) +
                           "  19 POINTS OF ACC DATA EQUALLY SPACED AT   .020 SEC.  IN UNITS CM/SEC/SEC\n" +
                           in_columns(made_up_samples(), "%10.3f", 8);
  const Record record = read_text(text);
  EXPECT_DOUBLE_EQ(record.interval, 0.02);
  expect_samples(record, made_up_samples(), gal);
}

// Ninety degrees of a sine of 0.35 g in ten steps: the peak is where the header says.
TEST(Volume2Record, BracketsMayHoldTheUnitInThePlaceOfAFormat) {
  std::vector<double> samples(40);
  for (std::size_t k = 0; k < samples.size(); ++k)
    samples[k] = 343.233 * std::sin(static_cast<double>(k) * std::acos(-1.0) / 20);
  const std::string start = volume2_channel(samples);
  const auto text = [&](const std::string& ending) {
    return with(start.substr(0, start.find("   40 points of accel")), "  0.002500", "  0.000000") +
           "   40 POINTS OF ACCEL DATA EQUALLY SPACED AT  .025 SEC.  " + ending + "\n" +
           in_columns(samples, "%10.3f", 8) +
           "   40 POINTS OF VELOC DATA EQUALLY SPACED AT  .025 SEC.  (UNITS: CM/SEC)\n" +
           in_columns(samples, "%10.3f", 8) + "/&\n";
  };
  for (const char* ending : {"(UNITS: CM/SEC/SEC)", "UNITS: CM/SEC/SEC", "(8F10.3) (UNITS: CM/SEC/SEC)",
                             "(UNITS: CM/SEC/SEC) (8F10.3)"}) {
    const Record record = read_text(text(ending));
    EXPECT_DOUBLE_EQ(record.interval, 0.025) << ending;
    ASSERT_EQ(record.samples.size(), 40U) << ending;
    EXPECT_DOUBLE_EQ(record.samples[10], 343.233 * gal) << ending;
  }
  EXPECT_EQ(error_of_text(text("(UNITS: CM/SEC)")),
            "file:46: this line names no unit of acceleration: cm/sec2 or g");
}

TEST(Volume2Record, MistakesAreRefused) {
  const std::string text = volume2_channel(made_up_samples());
  EXPECT_EQ(error_of_text(with(text, "points of accel", "points of veloc")),
            "file:1: holds no series of acceleration");
  EXPECT_EQ(error_of_text(with(text, "cm/sec2.", "cm/sec. ")),
            "file:46: this line names no unit of acceleration: cm/sec2 or g");
  EXPECT_EQ(
      error_of_text(with_line(text, 46, "  0 points of accel data equally spaced at  .003 sec, in cm/sec2.")),
      "file:46: '0' is not a count: must be an integer from 1 to 1000000000");
  EXPECT_EQ(error_of_text(with(with(text, "  0.002500", "  0.000000"), " .003 sec, in cm/sec2",
                               " .000 sec, in cm/sec2")),
            "file:46: time step is 0 s: must be > 0");
  EXPECT_EQ(error_of_text(with_line(text, 49, "")), "file:49: this line has 0 values, too few");
  EXPECT_EQ(error_of_text(with_line(text, 54, "surplus")),
            "file:54: expected another block of data or its end, \"/&\"");
  EXPECT_EQ(error_of_text(text + "more\n"),
            "file:55: the file ends here, before the line \"… points of accel data equally spaced at …\"");
}

TEST(GeoNetRecord, HasEachComponentInMillimetresWithTheStepOfItsHeader) {
  const auto first = made_up_samples(), second = made_up_samples(31);
  const auto series = records::read_series("file", geonet_component(first) + geonet_component(second));
  ASSERT_EQ(series.size(), 2U);
  EXPECT_EQ(series[0].format, "GeoNet");
  EXPECT_DOUBLE_EQ(series[0].interval, 0.02);
  expect_samples(series[0], first, 1e-3);
  expect_samples(series[1], second, 1e-3);
}

TEST(GeoNetRecord, MistakesAreRefused) {
  const std::string text = geonet_component(made_up_samples());
  EXPECT_EQ(error_of_text(with(text, "of 1.00", "of 0.50")), "file:11: units must be 1.00 mm/s/s");
  EXPECT_EQ(error_of_text(with(text, "      19      19       0", "     1.5      19       0")),
            "file:20: the integers up to here give no count of samples (34th to 36th)");
  EXPECT_EQ(error_of_text(with(text, "      19      19       0", "       0      19       0")),
            "file:26: the header announces no samples of acceleration");
  EXPECT_EQ(error_of_text(with(text, "      19      19       0", "      19      39       0")),
            "file:30: this line has 9 values, too few");
  EXPECT_EQ(error_of_text(with(text, "  0.0200", "  0.0000")), "file:26: time step is 0 s: must be > 0");
}

TEST(GeoNetRecord, AHeaderThatIsCutShortIsNoKnownFormat) {
  const std::string text = geonet_component(made_up_samples());
  EXPECT_NE(error_of_text(text.substr(0, text.find("Displacement"))).find("must be PEER AT2, COSMOS"),
            std::string::npos);
}

}  // namespace
}  // namespace rockstack
