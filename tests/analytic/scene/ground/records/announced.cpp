#include <gtest/gtest.h>

#include "analytic/scene/ground/records/record_file.hpp"
#include "tests/analytic/scene/ground/records/refusals.hpp"

namespace rockstack {
namespace {

TEST(Counts, StatedAnywhereMustBeWhatIsThere) {
  for (const std::string line :
       {"# NPTS = 4", "Number of points: 4", "NUMBER OF DATA : 4", "# samples: 4",
        "# number of data points 4", "# Anzahl der Werte: 4", "# sample_count: 4", "Number of records: 4",
        "# numero di punti = 4", "# No. of pts: 4", "# 4 data points"}) {
    expect_error(line + "\n# units: g\n# dt = 0.01\n0.1\n0.2\n0.3\n",
                 "the file ends after 3 values; line 1 announces 4");
    EXPECT_EQ(read_text(line + "\n# units: g\n# dt = 0.01\n0.1\n0.2\n0.3\n0.4\n").samples.size(), 4U) << line;
  }
  expect_error("# NPTS = 5\ntime (s),acc (g)\n0,1\n0.1,2\n", "announces 5");
  expect_error("units: g\nNPTS = 3, DT = .01\n0.1\n0.2\n",
               "the file ends after 2 values; line 2 announces 3");
  EXPECT_EQ(error_of_text("# samples: 100 per second\ntime (s),acc (g)\n0,1\n0.1,2\n"), "");
  expect_error("# NPTS = 2\n# samples: 3\ntime (s),acc (g)\n0,1\n0.1,2\n", "announces 3 values, line 1 2");
}

TEST(Steps, TwoThatDifferAreRefused) {
  const auto one_column = [](const std::string& line) {
    return "# " + line + "\n# units: g\n0.1\n0.2\n0.3\n";
  };
  for (const std::string line : {"Sampling rate: 200 Hz (original), 100 Hz (here)", "dt = 0.01 s (200 Hz)",
                                 "dt = 0.01 s, resampled from dt = 0.005 s"})
    expect_error(one_column(line), "names two time steps");
  for (const std::string line :
       {"dt = 0.01 s (100 Hz)", "Sampling rate: 100 Hz, low-pass filter 40 Hz",
        "sampled at 100 Hz, anti-alias 50 Hz", "f = 1.9 Hz, fs = 100 Hz", "sampled at 100 Hz",
        "samples: 3, rate: 100 Hz", "step: 0.01 s", "Sampling time: 10 ms", "Sample rate 100 samples/s",
        "Schrittweite = 0,01 s", "intervalo de muestreo: 0.01 s", "analysis dt = 0.001 s, record dt = 0.01 s",
        "dt = 0.01 s, resampled to 100 Hz", "Sample rate: 100 Sa/s", "Zeitschritt 0,01 Sekunden"})
    EXPECT_NEAR(read_text(one_column(line)).interval, 0.01, 1e-12) << line;
  for (const std::string line :
       {"camera frame rate: 50 fps", "Original sampling rate: 200 Hz, decimated to 100 Hz",
        "ADC sampling rate: 10 kHz, output rate: 100 Hz", "Solver time step 0.0001 s, output every 100 steps",
        "max dt = 0.01 s", "Confidence interval: 0.05", "Trigger interval: 0.02 s"})
    expect_error(one_column(line), "no time step in the header");
  for (const std::string line : {"Sampling rate: 1000 Hz, block average of 5 samples",
                                 "Sampling rate: 1000 Hz, only every fifth value stored"})
    expect_error(one_column(line), "left out, averaged or interpolated");
}

TEST(Steps, AreInUnitsOfTimeOrRatesOnly) {
  for (const std::string line :
       {"Sample rate: 5 kS/s", "Sampling rate: 5 kilohertz", "Sampling rate: 300 per minute",
        "Sampling rate: 18000 1/h", "Sampling interval: 0.1 days", "dt = 0.02 sqrt(h/g)", "dt = 0.02 T",
        "dt = 0.001 ... 0.01 s", "dt = 0.01 s for displacements, 0.005 s for accelerations"})
    expect_error("# " + line + "\n# units: g\n0.1\n0.2\n", "no unit of one: must be s, ms, min or Hz");
  expect_error("# Sampling interval: 20,000 \u00b5s\n# units: g\n0.1\n0.2\n", "part thousands");
}

TEST(Times, MayBeRoundedToTheirDecimals) {
  std::string text = "# sampling rate: 128 Hz\ntime (s),acc (g)\n";
  for (int k = 0; k < 200; ++k) {
    char time[16];
    std::snprintf(time, sizeof time, "%.3f", k / 128.0);
    text += std::string(time) + ",0.1\n";
  }
  EXPECT_EQ(read_text(text).interval, 1 / 128.0) << "the header knows what roundings hide";
  expect_error(text.substr(0, text.find("1.000,")) + text.substr(text.find("1.250,")),
               "must have a constant step");
}

TEST(Units, OfTheHeaderMayNotBeOtherThanThoseOfTitles) {
  EXPECT_EQ(error_of_text("# units: m/s2\ntime (s),acc (g)\n0,1\n0.1,2\n"),
            "file:1: names another unit of acceleration than the title of column 2, \"acc (g)\"");
  EXPECT_EQ(error_of_text("# units: g\ntime (s),acc (g)\n0,1\n0.1,2\n"), "");
}

TEST(MissingData, IsRefusedWhereTheHeaderSaysWhatStandsForIt) {
  for (const std::string line :
       {"missing data: 999", "null value = 999", "No data: 999", "missing value code 999"})
    EXPECT_EQ(error_of_text("# " + line + "\ntime (s),acc (gal)\n0,1\n0.1,999\n"),
              "file:4: '999' marks missing data")
        << line;
  EXPECT_EQ(error_of_text("# number of missing data: 0\ntime (s),acc (gal)\n0,0\n0.1,9\n"), "");
}

TEST(Pairs, OfTimesAndValuesAreReadFromLineToLine) {
  const Record record = read_text("# acceleration in m/s2\n0.00, 1, 0.02, 2\n0.04, 3, 0.06, 4\n0.08, 5\n");
  EXPECT_EQ(record.samples, (std::vector<double>{1, 2, 3, 4, 5}));
  EXPECT_NEAR(record.interval, 0.02, 1e-15);
  expect_error("# units: g\n0.00 1 0.00 2\n0.02 1 0.02 2\n0.04 1 0.04 2\n",
               "has the times of column 1 again");
}

TEST(Cards, AreNumberedAndTheirNumbersAreNoSamples) {
  std::string first = "# units: gal\n# dt = 0.01\n", last = first;
  for (int k = 1; k <= 5; ++k) {
    first += std::to_string(k) + " 0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8\n";
    last += "0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8 " + std::to_string(k) + "\n";
  }
  expect_error(first, "file:3: column 1 counts the lines");
  expect_error(last, "file:3: column 9 counts the lines");
}

TEST(Contradictions, InHeadersOfNetworksAreRefused) {
  EXPECT_EQ(
      error_of_text(with(geonet_component(made_up_samples()), "intervals of 0.020", "intervals of 0.005")),
      "file:11: time step 0.005 s here, and 0.02 s in the reals below");
  expect_error(with(esm_text(made_up_samples()), "PGA_CM/S^2: 0", "PGA_CM/S^2: 12"),
               "PGA is 0.12 m/s\u00b2 here");
  EXPECT_EQ(error_of_text(with(esm_text(made_up_samples()), "PGA_CM/S^2: 0", "PGA_CM/S^2: -0.83")), "");
}

// One column of times, two channels, each with its unit.
TEST(LabView, ChannelsAreNamedByTheHeader) {
  const std::string head =
      "LabVIEW Measurement\t\nSeparator\tTab\nX_Columns\tOne\nTime\t10:22:31.123\n***End_of_Header***\t\n\t\n"
      "Channels\t2\t\t\nSamples\t3\t3\t\nTime\t10:22:31.1\t10:22:31.1\t\nY_Unit_Label\tmm\tg\t\n"
      "X_Dimension\tTime\tTime\t\nDelta_X\t0.010000\t0.010000\t\n***End_of_Header***\t\t\t\n"
      "X_Value\tTable\tBlock\tComment\n";
  const std::string rows = "0.000\t1.0\t0.1\n0.010\t2.0\t0.2\n";
  const auto read = records::read_series("file", head + rows + "0.020\t3.0\t-0.5\n");
  ASSERT_EQ(read.size(), 1U);
  EXPECT_NEAR(read.front().interval, 0.01, 1e-12);
  EXPECT_NEAR(read.front().samples.back(), -0.5 * 9.80665, 1e-12);
  EXPECT_EQ(read.front().taken, "column 3 of 3, \"Block (g)\"");
  expect_error(head + rows, "announces 3");
  std::string none = head;
  none.replace(none.find("One"), 3, "No");
  expect_error(none + rows, "file:3: X_Columns must be One");
}

TEST(Steps, AGapIsToldWhereItIs) {
  expect_error("time (s),acc (g)\n0,1\n0.1,2\n0.2,3\n0.5,4\n0.6,5\n",
               "file:5: time 0.5 after 0.2, where most steps are 0.1");
}

}  // namespace
}  // namespace rockstack
