#include <gtest/gtest.h>

#include "analytic/scene/ground/records/record_file.hpp"
#include "analytic/scene/ground/records/table.hpp"
#include "tests/analytic/scene/ground/records/layouts.hpp"

namespace rockstack {
namespace {

/// Two samples of 0.5 and 1 in a unit, 0.02 s apart. A time of day is rounded by up to 1.5e-11 s.
void expect_read(const std::string& text, double unit = 1, const std::string& taken = "") {
  const auto series = records::read_series("file", text);
  EXPECT_NEAR(series.front().interval, 0.02, 3e-11) << text;
  ASSERT_EQ(series.front().samples.size(), 2U) << text;
  EXPECT_NEAR(series.front().samples[0], 0.5 * unit, 1e-15) << text;
  EXPECT_NEAR(series.front().samples[1], unit, 1e-14) << text;
  if (!taken.empty()) {
    EXPECT_EQ(series.front().taken, taken) << text;
  }
}

TEST(Units, AreReadInAllSpellingsOrNotAtAll) {
  using records::Quantity, records::read_unit;
  for (const char* text :
       {"m s-2", "m s^-2", "m s\u207b\u00b2", "m\u00b7s\u207b\u00b2", "m / s2", "m * s^-2", "M/S**2",
        "m/s^(2)", "m/sec/sec", "metres per second squared", "N/kg", "mps2", "\u043c/\u04412"})
    EXPECT_EQ(read_unit(text), (records::Unit{1, Quantity::acceleration})) << text;
  for (const char* text :
       {"m/s 2", "m/s*s", "m/s s", "ms-2", "g/10", "s m", "", "2", "m s -2", "kg", "m/s^4"})
    EXPECT_FALSE(read_unit(text) && read_unit(text)->quantity == Quantity::acceleration) << text;
  EXPECT_EQ(read_unit("Hz")->quantity, Quantity::frequency);
  EXPECT_EQ(read_unit("samples/s")->quantity, Quantity::frequency);
  EXPECT_EQ(read_unit("msec"), (records::Unit{1e-3, Quantity::time}));
  for (const char* text : {"%g", "% g", "% of g"})
    EXPECT_DOUBLE_EQ(read_unit(text)->factor, 0.01 * g) << text;
}

TEST(TitledColumns, AfterTheWordAccelerationNothingButAnAccelerationIsRead) {
  const std::string rows = "0,0.5\n0.02,1\n";
  EXPECT_EQ(
      error_of_text("time (s),acceleration (m/s 2)\n" + rows),
      "file:1: column 2, \"acceleration (m/s 2)\": 'm/s 2' is no unit of acceleration: must be e.g. m/s2, "
      "cm/s2, gal or g");
  EXPECT_EQ(
      error_of_text("time (s),acceleration (m/s)\n" + rows),
      "file:1: column 2, \"acceleration (m/s)\" has no unit of acceleration: say e.g. \"units: m/s2\", or "
      "(m/s2) in its title");
  EXPECT_NE(error_of_text("# units: g\ntime (s),acceleration (x10^-2 g)\n" + rows).find("is no unit"),
            std::string::npos);
  EXPECT_NE(error_of_text("time (h),acceleration (g)\n" + rows).find("no unit of time"), std::string::npos);
  EXPECT_NE(error_of_text("# units: g\n0,000,0,5\n0,020,1,0\n").find("commas"), std::string::npos);
  EXPECT_EQ(error_of_text("# acceleration in m\n" + rows),
            "file:1: 'm' is no unit of acceleration: say e.g. \"units: m/s2\" (or cm/s2, gal, g)");
  EXPECT_EQ(
      error_of_text("# acceleration of a table\n# units: mm\n" + rows),
      "file:2: names a unit of displacement, line 1 an acceleration: say e.g. \"units: m/s2\" (or cm/s2, "
      "gal, g)");
}

TEST(TitledColumns, HowTheirNumbersWereUnderstoodIsTold) {
  const auto told = [](const std::string& text) {
    return description(records::read_series("file", text).front());
  };
  const std::string rows = "0,0.5\n20,1\n";
  EXPECT_EQ(
      told("time (ms),acc (cm/s2)\n" + rows),
      "text columns, column 2 of 2, \"acc (cm/s2)\", in 0.01 m/s², steps of 0.02 s by column 1, \"time (ms)\"");
  EXPECT_EQ(told("# rate: 50 Hz\n# units: g\n0.5\n1\n"),
            "text columns, in 9.80665 m/s², steps of 0.02 s by line 1");
  EXPECT_EQ(told("time (ms),velocity (mm/s)\n0,0\n20,1\n"),
            "text columns of velocity, column 2 of 2, \"velocity (mm/s)\", in 0.001 m/s, steps of 0.01 s by "
            "column 1, \"time (ms)\", halved");
  EXPECT_EQ(told("TIMESERIES A, 2 samples, 50 sps, 2020-01-01, SLIST, FLOAT, M/S**2\n0.5 1\n"),
            "ObsPy SLIST, in 1 m/s², steps of 0.02 s by the header");
}

TEST(TitledColumns, AUnitOfAPeakOrANameInBracketsIsNotThatOfTheNumbers) {
  expect_read(
      "# Network: GEOSCOPE (G)\n# PGA (g): 0.35\n# Peak acceleration (g): 1\n# units: cm/s2\n0 0.5\n0.02 1\n",
      gal);
  expect_read("# PGA (g): 0.35\n# acceleration in cm s-2, time in s\n0 0.5\n0.02 1\n", gal);
}

TEST(TitledColumns, EachHasTheUnitOfItsOwnTitleAndTheAccelerationIsTaken) {
  expect_read("Time (s),Velocity (cm/s),Acceleration (cm/s2)\n0,9,0.5\n0.02,8,1\n", gal,
              "column 3 of 3, \"Acceleration (cm/s2)\"");
  expect_read("t, a, v, d\n# units: g\n0,0.5,9,9\n0.02,1,8,8\n", g, "column 2 of 4, \"a\"");
  expect_read("acc (g);time (ms)\n0,5;0\n1;20\n", g, "column 1 of 2, \"acc (g)\"");
  expect_read("Time s Velocity cm/s Acceleration m s-2\n0 9 0.5\n0.02 8 1\n", 1);
  EXPECT_EQ(error_of_text("Period (s), Sa (g)\n0.0, 0.5\n0.02, 1\n"),
            "file:1: column 1, \"Period (s)\": a spectrum is no record: must be a history in time");
  EXPECT_EQ(
      error_of_text("# Acceleration and velocity of a table, units: g\n0 0.5 9\n0.02 1 8\n0.04 2 7\n"),
      "file:1: names an acceleration and a velocity or displacement, and is no line of titles: one above "
      "the numbers, parted as they are, must say which columns have which");
}

TEST(TitledColumns, TimeIsTheColumnThatItsTitleCallsSo) {
  expect_read(",time (s),acceleration (g)\n0,0.00,0.5\n1,0.02,1\n", g, "column 3 of 3, \"acceleration (g)\"");
  expect_read("\"\",\"time\",\"acc\"\n\"1\",\"0,00\",\"0,5\"\n\"2\",\"0,02\",\"1,0\"\nunits: g\n", g);
  expect_read("sample,acceleration (g)\n# dt = 0.02\n1,0.5\n2,1\n", g);
  expect_read("\"time\" \"acc_g_\"\n\"1\" 0.00 0.5\n\"2\" 0.02 1\n", g);
  expect_read("time acc\n# units: g\n1 0.00 0.5\n2 0.02 1\n", g);
  expect_read("Timestamp,acc (g)\n2024-05-01 23:59:59.99,0.5\n2024-05-02 00:00:00.01,1\n", g);
}

TEST(TitledColumns, RowsOfUnitsCountsAndStepsAreReadWhereTheyStand) {
  expect_read("time,acceleration\ns,g\n0,0.5\n0.02,1\n", g);
  expect_read("time;acceleration\n[s];[m/s\xb2]\n0;0,5\n0,02;1\n");
  expect_read("NPTS: 2\nDT: 0.02\nUNITS: g\n0.5\n1.0\n", g);
  expect_read("units: g\nDT= .02 NPTS= 2\n0.5 1.0\n", g);
  expect_read("units: g\n.02 2 DT, NPTS\n0.5 1.0\n", g);
  expect_read("units: g\n2 0.02\n0.00 0.5\n0.02 1.0\n", g);
  expect_read("units: g\nsampling rate: 0.02 s\n0.5\n1.0\n", g);
  expect_read("units: g\nsampling rate (kHz): 0.05\n0.5\n1.0\n", g);
}

TEST(TitledColumns, NumbersRunTogetherAreTakenApart) {
  const Record record = read_text("units: m/s2\nNPTS= 4, DT= .02 SEC\n-.50E+00-.10E+01-.20E-01\n .30E+01\n");
  EXPECT_EQ(record.samples, (std::vector<double>{-0.5, -1, -0.02, 3}));
}

TEST(TitledColumns, TabsMayStandBesideDecimalCommasAndOtherEncodings) {
  expect_read("t(s)\tacceleration [g]\n0,000\t0,5\n0,020\t1,0\n", g);
  std::string wide = "\xFF\xFE";
  for (const char c : std::string("t (s)\tacc (g)\r\n0,00\t0,5\r\n0,02\t1,0\r\n")) wide += {c, '\0'};
  expect_read(wide, g);
}

TEST(TitledColumns, TextBetweenTheNumbersOfASeriesIsRefused) {
  EXPECT_EQ(error_of_text("# units: g\n# dt = 0.02\n0.5\n1\n# channel 2\n3\n4\n"),
            "file:5: text between the numbers: '# channel 2'; a second series must be in a file of its own");
}

TEST(ObspyRecord, HasItsRateAndUnitInItsFirstLine) {
  const std::string head = "TIMESERIES XX_A_00_HNE_D, 2 samples, 50 sps, 2014-08-24T10:20:44.000000, ";
  expect_read(head + "SLIST, FLOAT, M/S**2\n0.5\t1.0\n");
  expect_read(head +
              "TSPAIR, FLOAT, M/S**2\n2014-08-24T10:20:44.000000  0.5\n2014-08-24T10:20:44.020000  1.0\n");
  EXPECT_EQ(error_of_text(head + "SLIST, INTEGER, Counts\n1 2\n"),
            "file:1: 'Counts' at the end of this line is no unit of acceleration: must be e.g. M/S**2");
}

TEST(UsualLimits, AStepAndAPeakBeyondThemAreRefusedWithWhatWasRead) {
  const auto error = [](double interval, double sample) -> std::string {
    try {
      check_usual("motion.csv", "text columns", interval, {0, -sample});
    } catch (const std::invalid_argument& wrong) {
      return wrong.what();
    }
    return "";
  };
  const std::string way =
      "; where that is meant, say limits = \"none\" beside the record in a scene, or --set limits=none";
  const std::string unit =
      ": a unit of time other than s must be in the title or header, as in \"time (ms)\"" + way;
  EXPECT_EQ(error(0.5, 10 * g), "");
  EXPECT_EQ(error(1e-5, 10 * g), "");
  EXPECT_EQ(error(25, 1), "motion.csv: read as text columns: steps by 25 s, more than 0.5 s" + unit);
  EXPECT_EQ(error(1e-6, 1), "motion.csv: read as text columns: steps by 1e-06 s, less than 1e-05 s" + unit);
  EXPECT_EQ(
      error(0.02, 343 * g),
      "motion.csv: read as text columns: peaks at 343 g, more than 10 g: must be in the unit that its title or "
      "header says, without marks of missing data" +
          way);
}

}  // namespace
}  // namespace rockstack
