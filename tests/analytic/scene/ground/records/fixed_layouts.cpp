#include <gtest/gtest.h>

#include "tests/analytic/scene/ground/records/layouts.hpp"

namespace rockstack {
namespace {

TEST(SmcRecord, ReadsColumnsWithoutBlanksBetween) {
  const Record record = read_text(smc_text(made_up_samples()));
  EXPECT_EQ(record.format, "USGS SMC");
  EXPECT_DOUBLE_EQ(record.interval, 0.005);
  ASSERT_EQ(record.samples.size(), 19U);
  for (std::size_t k = 0; k < 19; ++k) EXPECT_DOUBLE_EQ(record.samples[k], made_up_samples()[k] * gal);
}

TEST(SmcRecord, UncorrectedAccelerationIsTakenToo) {
  EXPECT_EQ(read_text(smc_text(made_up_samples(), "1 UNCORRECTED ACCELEROGRAM")).samples.size(), 19U);
}

TEST(SmcRecord, OtherQuantitiesAreRefused) {
  EXPECT_EQ(error_of_text(smc_text(made_up_samples(), "3 VELOCITY")),
            "file:1: holds '3 VELOCITY': only an accelerogram can be used");
  EXPECT_EQ(error_of_text(smc_text(made_up_samples(), "4 DISPLACEMENT")),
            "file:1: holds '4 DISPLACEMENT': only an accelerogram can be used");
}

TEST(SmcRecord, MistakesAreRefused) {
  const std::string text = smc_text(made_up_samples());
  EXPECT_EQ(error_of_text(with(text, "  2.0000000E+02", "  1.7000000E+38")),
            "file:27: the header gives no sampling rate (second of the 50 reals)");
  EXPECT_EQ(error_of_text(with(text, "  2.0000000E+02", " -2.0000000E+02")),
            "file:27: time step is -0.005 s: must be > 0");
  EXPECT_EQ(error_of_text(with_line(text, 29, "1.7000E+38")), "file:29: '1.7000E+38' marks missing data");
  EXPECT_EQ(error_of_text(with(text, "| made up", "made up")), "file:28: expected a comment line, \"|…\"");
  EXPECT_EQ(error_of_text(without_line(text, 31)),
            "file:30: the file ends after 16 values; line 28 announces 19");
  EXPECT_EQ(error_of_text(text + "0\n"), "file:32: surplus line after 19 samples");
  EXPECT_EQ(error_of_text(with(text, "        19", "         0")),
            "file:14: '0' is not a count: must be an integer from 1 to 1000000000");
}

}  // namespace
}  // namespace rockstack
