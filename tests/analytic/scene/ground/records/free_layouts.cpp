#include <gtest/gtest.h>

#include <algorithm>
#include <iomanip>
#include <limits>
#include <sstream>

#include "analytic/scene/ground/ground_motion.hpp"
#include "analytic/scene/ground/records/record_file.hpp"
#include "tests/analytic/scene/ground/records/layouts.hpp"

namespace rockstack {
namespace {

constexpr double round_off = 4 * std::numeric_limits<double>::epsilon();  // one product or quotient each side

void expect_record(const Record& record, const std::string& format, double interval, double unit,
                   const std::vector<double>& samples) {
  EXPECT_EQ(record.format, format);
  EXPECT_DOUBLE_EQ(record.interval, interval);
  ASSERT_EQ(record.samples.size(), samples.size());
  for (std::size_t k = 0; k < samples.size(); ++k) {
    EXPECT_NEAR(record.samples[k], samples[k] * unit, round_off * unit) << "sample " << k;
  }
  EXPECT_NEAR(peak({record.interval, record.samples, ""}), peak({interval, samples, ""}) * unit,
              round_off * unit);
}

TEST(PeerRecord, IsInStandardGravity) {
  expect_record(read_text(peer_text(made_up_samples())), "PEER AT2", 0.005, g, made_up_samples());
}

TEST(PeerRecord, TimeStepNeedNotBeRound) {
  EXPECT_DOUBLE_EQ(read_text(peer_text(made_up_samples(), "19", ".0066")).interval, 0.0066);
}

TEST(PeerRecord, TimeStepIsInItsUnit) {
  const std::string text = peer_text(made_up_samples());
  EXPECT_DOUBLE_EQ(read_text(with(text, "0.005 SEC", "5 MSEC")).interval, 0.005);
}

TEST(PeerRecord, ReadsTheOlderOrderOfCountAndStep) {
  const std::string text = with_line(peer_text(made_up_samples()), 4, "   19    0.0050    NPTS, DT");
  expect_record(read_text(text), "PEER AT2", 0.005, g, made_up_samples());
}

TEST(PeerRecord, HeaderMayHaveMoreOrFewerLines) {
  const std::string text = peer_text(made_up_samples());
  expect_record(read_text("one more\n*** Begin data ***\n" + text), "PEER AT2", 0.005, g, made_up_samples());
  expect_record(read_text(without_line(without_line(text, 1), 1)), "PEER AT2", 0.005, g, made_up_samples());
}

TEST(PeerRecord, EndMarkerAndBlankLinesAreNoValues) {
  const std::string text = peer_text(made_up_samples()) + "*** End Data ***\n\n  \n";
  expect_record(read_text(text), "PEER AT2", 0.005, g, made_up_samples());
}

TEST(PeerRecord, UnitIsTheOneTheHeaderStates) {
  const std::string text = peer_text(made_up_samples());
  expect_record(read_text(with_line(text, 3, "The units are (g)")), "PEER AT2", 0.005, g, made_up_samples());
  expect_record(read_text(with_line(text, 3, "Acceleration in units of cm/s^2")), "PEER AT2", 0.005, gal,
                made_up_samples());
  expect_record(read_text(with_line(text, 1, "velocity differences, g=981 cm/s2")), "PEER AT2", 0.005, g,
                made_up_samples());
}

TEST(PeerRecord, OneSurplusValueIsDropped) {
  auto samples = made_up_samples();
  const std::string text = peer_text(samples, "18");
  samples.pop_back();
  expect_record(read_text(text), "PEER AT2", 0.005, g, samples);
}

TEST(PeerRecord, OneMissingValueShortensTheRecord) {
  expect_record(read_text(peer_text(made_up_samples(), "20")), "PEER AT2", 0.005, g, made_up_samples());
}

TEST(PeerRecord, LargerDifferencesAreRefused) {
  EXPECT_EQ(error_of_text(peer_text(made_up_samples(), "21")),
            "file:8: the file ends after 19 values; line 4 announces 21");
  EXPECT_EQ(error_of_text(peer_text(made_up_samples(), "17")),
            "file:8: the file ends after 19 values; line 4 announces 17");
  EXPECT_EQ(error_of_text(peer_text({}, "1")), "file:4: the file ends after 0 values; line 4 announces 1");
}

TEST(PeerRecord, HeaderMistakesAreRefused) {
  const auto samples = made_up_samples();
  const std::string text = peer_text(samples);
  EXPECT_EQ(error_of_text(with_line(text, 3, "VELOCITY TIME SERIES IN UNITS OF CM/S")),
            "file:4: the header up to here names no unit of acceleration: say e.g. \"units: m/s2\" (or "
            "cm/s2, gal, g)");
  EXPECT_EQ(error_of_text(with_line(text, 2, "UNITS: CM/S2")),
            "file:3: names another unit of acceleration than line 2");
  EXPECT_EQ(error_of_text(peer_text(samples, "19", "0")), "file:4: time step is 0 s: must be > 0");
  EXPECT_EQ(error_of_text(peer_text(samples, "19", "-.01")), "file:4: time step is -0.01 s: must be > 0");
  EXPECT_EQ(error_of_text(peer_text(samples, "19", "fast")), "file:4: 'fast' is not a number");
  EXPECT_EQ(error_of_text(with_line(text, 4, "NPTS= 19")),
            "file:4: NPTS without DT: the time step is missing");
  EXPECT_EQ(error_of_text(peer_text(samples, "1.5")),
            "file:4: '1.5' is not a count: must be an integer from 1 to 1000000000");
  EXPECT_EQ(error_of_text(peer_text(samples, "18446744073709551615")),
            "file:4: '18446744073709551615' is not a count: must be an integer from 1 to 1000000000");
}

TEST(PeerRecord, ValuesMustBeFiniteNumbers) {
  const std::string text = peer_text(made_up_samples());
  EXPECT_EQ(error_of_text(with_line(text, 6, "0.1 nan")), "file:6: 'nan' is not a finite number below 1e100");
  EXPECT_EQ(error_of_text(with_line(text, 6, "0.1 1e999")),
            "file:6: '1e999' is not a finite number below 1e100");
  EXPECT_EQ(error_of_text(with_line(text, 6, "**********")), "file:6: '**********' is not a number");
  EXPECT_EQ(error_of_text(with_line(text, 6, "0.1x")), "file:6: '0.1x' is not a number");
}

TEST(EsmRecord, IsInTheUnitItNames) {
  expect_record(read_text(esm_text(made_up_samples())), "ESM ASCII", 0.005, gal, made_up_samples());
  expect_record(read_text(esm_text(made_up_samples(), "g")), "ESM ASCII", 0.005, g, made_up_samples());
}

TEST(EsmRecord, MistakesAreRefused) {
  const std::string text = esm_text(made_up_samples());
  EXPECT_EQ(error_of_text(with(text, "ACCELERATION", "VELOCITY")),
            "file:7: DATA_TYPE is 'VELOCITY': must be ACCELERATION");
  EXPECT_EQ(error_of_text(esm_text(made_up_samples(), "cm/s")),
            "file:5: UNITS 'cm/s' are not known as acceleration: cm/s^2, m/s^2, g are");
  EXPECT_EQ(error_of_text(without_line(text, 5)), "file:7: the header ends here without UNITS");
  EXPECT_EQ(error_of_text(without_line(text, 3)), "file:7: the header ends here without SAMPLING_INTERVAL_S");
  EXPECT_EQ(error_of_text(without_line(text, 4)), "file:7: the header ends here without NDATA");
  EXPECT_EQ(error_of_text(text + "0.1\n"), "file:28: the file ends after 20 values; line 4 announces 19");
}

TEST(KnetRecord, LosesItsOffsetAndIsScaled) {
  auto samples = made_up_samples(20);
  double mean = 0;
  for (const double sample : samples) mean += sample / static_cast<double>(samples.size());
  for (double& sample : samples) sample -= mean;
  const Record record = read_text(knet_text(made_up_samples(20)));
  ASSERT_EQ(record.samples.size(), samples.size());
  EXPECT_EQ(record.format, "K-NET/KiK-net ASCII");
  EXPECT_DOUBLE_EQ(record.interval, 0.1);
  double sum = 0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    EXPECT_NEAR(record.samples[k], samples[k] * gal,
                20 * round_off * gal);  // a sum of 20 values comes before
    sum += record.samples[k];
  }
  EXPECT_NEAR(sum, 0, 400 * round_off * gal);  // 20 such values
}

TEST(KnetRecord, MistakesAreRefused) {
  const std::string text = knet_text(made_up_samples(20));
  EXPECT_EQ(error_of_text(text + "1\n"),
            "file:11: the file ends after 21 values; frequency and duration announce 20");
  EXPECT_EQ(error_of_text(with(text, "2(gal)/2000", "2/2000")),
            "file:6: scale factor '2/2000': must be like 3920(gal)/6182761");
  EXPECT_EQ(error_of_text(with(text, "2(gal)/2000", "2(gal)/0")), "file:6: '0': must be > 0");
  EXPECT_EQ(error_of_text(without_line(text, 6)), "file:6: the header ends here without \"Scale Factor\"");
  EXPECT_EQ(error_of_text(without_line(text, 3)),
            "file:6: the header ends here without \"Sampling Freq(Hz)\"");
  EXPECT_EQ(error_of_text(without_line(text, 4)),
            "file:6: the header ends here without \"Duration Time(s)\"");
  EXPECT_EQ(error_of_text(with(text, "10Hz", "-5Hz")), "file:3: '-5': must be > 0");
}

TEST(TextColumns, OneColumnTakesUnitAndStepFromItsHeader) {
  expect_record(read_text(one_column_text(made_up_samples())), "text columns", 0.02, 1, made_up_samples());
}

TEST(TextColumns, TwoColumnsTakeTheStepFromTheTimes) {
  const Record record = read_text(two_column_text(made_up_samples(), 0.005));
  expect_record(record, "text columns", record.interval, gal, made_up_samples());
  EXPECT_NEAR(record.interval, 0.005, 0.005 * round_off);
}

TEST(TextColumns, RoundedTimesGiveTheirMeanStep) {
  // Four decimals of k/30 are off by up to 5e-5 each; over 18 steps the mean is off by at most 1e-4/18.
  EXPECT_NEAR(read_text(two_column_text(made_up_samples(), 1.0 / 30)).interval, 1.0 / 30, 1e-4 / 18);
}

TEST(TextColumns, UnitMayStandInBrackets) {
  const std::string text = one_column_text(made_up_samples());
  for (const std::string line : {"# a [m/s^2]", "acc (m/s/s)", "# a (m/s\u00b2)", "% units = m/sec**2"}) {
    expect_record(read_text(with_line(text, 2, line)), "text columns", 0.02, 1, made_up_samples());
  }
}

TEST(TextColumns, WhatTheHeaderDoesNotSayIsRefused) {
  const std::string one = one_column_text(made_up_samples());
  const std::string two = two_column_text(made_up_samples(), 0.005);
  const std::string no_unit = "names no unit of acceleration: say e.g. \"units: m/s2\" (or cm/s2, gal, g)";
  EXPECT_EQ(error_of_text(without_line(one, 2)), "file:2: the header up to here " + no_unit);
  EXPECT_EQ(error_of_text(with_line(one, 2, "# units: g/10")),
            "file:2: 'g/10' is no unit of acceleration: say e.g. \"units: m/s2\" (or cm/s2, gal, g)");
  EXPECT_EQ(error_of_text(without_line(one, 3)),
            "file:3: one column, and no time step in the header: say e.g. \"# dt = 0.01\" (s)");
  EXPECT_EQ(error_of_text(with(one, "0.02", "0")), "file:3: time step is 0 s: must be > 0");
  EXPECT_DOUBLE_EQ(read_text(with(one, "0.02 s", "20 ms")).interval, 0.02);
  EXPECT_DOUBLE_EQ(read_text(with(two, "(s)", "(min)")).interval, 0.3);
  EXPECT_EQ(error_of_text("# units: g\n" + one), "file:3: names another unit of acceleration than line 1");
  EXPECT_EQ(error_of_text("# dt = 0.01\n" + one), "file:4: names another time step than a line before");
  EXPECT_EQ(error_of_text("# dt = 0.01\n" + two), "file:1: dt = 0.01 s here, and times step by 0.005 s");
}

TEST(TextColumns, UnequalRowsAreRefused) {
  const std::string one = one_column_text(made_up_samples());
  const std::string two = two_column_text(made_up_samples(), 0.005);
  EXPECT_EQ(error_of_text(with_line(one, 6, "1 2 3")), "file:6: 3 columns where lines before have 1");
  EXPECT_EQ(error_of_text(with_line(one, 6, "1 2")), "file:6: 2 columns where lines before have 1");
  EXPECT_EQ(error_of_text(with_line(two, 3, "0.006,0.1")),
            "file:3: time 0.006 where a constant step gives 0.005");
  EXPECT_EQ(error_of_text(with_line(one, 4, "nan")), "file:4: 'nan' is not a finite number below 1e100");
  EXPECT_EQ(error_of_text("units: g\n0.1, 0.2\n"), "file:2: one time alone gives no time step");
}

/// Three components, the second and third of opposite sign and half as large, in rows of that form.
std::string components_text(const std::string& head, bool times, char separator) {
  std::ostringstream text;
  text << head << std::fixed << std::setprecision(4);
  const std::vector<double> samples = made_up_samples();
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (times) text << 0.02 * static_cast<double>(k) << separator;
    text << samples[k] << separator << -samples[k] << separator << samples[k] / 2 << '\n';
  }
  return text.str();
}

void expect_components(const std::string& text, double factor) {
  const std::vector<Record> series = records::read_series("file", text);
  ASSERT_EQ(series.size(), 3U) << text;
  for (const Record& record : series) EXPECT_NEAR(record.interval, 0.02, 0.02 * round_off);
  const std::vector<double> samples = made_up_samples();
  for (std::size_t k = 0; k < samples.size(); ++k) {
    EXPECT_NEAR(series[0].samples[k], samples[k] * factor, 1e-12);
    EXPECT_NEAR(series[1].samples[k], -samples[k] * factor, 1e-12);
    EXPECT_NEAR(series[2].samples[k], samples[k] / 2 * factor, 1e-12);
  }
}

TEST(TextColumns, EachColumnAfterTheTimesIsAComponent) {
  expect_components(components_text("t [s],ax [m/s2],ay [m/s2],az [m/s2]\n", true, ','), 1);
  expect_components(components_text("#SampleRate(Hz): 50\n#AmplitudeUnit:  gal. (corr)\n", true, ' '), gal);
}

TEST(TextColumns, NamedColumnsAreComponentsWithTheStepOfTheHeader) {
  const std::string head = "SAMPLING INTERVAL (sec) : 0.02\nRAW PGA VALUES (gal) : (N-S) 8\n";
  expect_components(components_text(head + "   N-S   E-W   U-D\n", false, ' '), gal);
  EXPECT_EQ(
      error_of_text(components_text(head, false, ' ')),
      "file:3: 3 columns, none of them times: where each is a component, a line of names must stand above them");
}

TEST(TextColumns, WhereSemicolonsPartThemCommasAreDecimalPoints) {
  std::string text = components_text("t [s];a [m/s2];b [m/s2];c [m/s2]\n", true, ';');
  expect_components(text, 1);
  std::replace(text.begin(), text.end(), '.', ',');
  expect_components(text, 1);
}

TEST(TextColumns, ASeriesMayGoOnFromLineToLine) {
  const std::string rows = in_columns(made_up_samples(), "%9.3f", 8);
  expect_record(read_text("# units: m/s2\n# dt: 0.02\n" + rows), "text columns", 0.02, 1, made_up_samples());
  expect_record(read_text("# units: m/s2\n19 0.02\n" + rows), "text columns", 0.02, 1, made_up_samples());
  expect_record(read_text("# a (mm/s/s)\n19 0.02\n" + in_columns(made_up_samples(), "%.3f", 1)),
                "text columns", 0.02, 1e-3, made_up_samples());
  EXPECT_NE(error_of_text("# units: m/s2, dt = 0.01\n19 0.02\n" + rows).find("another time step"),
            std::string::npos);
  EXPECT_EQ(error_of_text("# units: m/s2\n20 0.02\n" + rows),
            "file:5: the file ends after 19 values; line 2 announces 20");
  EXPECT_EQ(error_of_text("# units: m/s2\n# dt: 0.02\n1 2 3 4 5\n1 2 3\n1 2 3 4 5\n"),
            "file:4: 3 columns where lines before have 5");
}

TEST(TextColumns, WordsAmongNumbersAreNoKnownLayout) {
  EXPECT_EQ(error_of_text("Instrument None\n0 km from nowhere\n"),
            "file:2: not a known format: must be PEER AT2, COSMOS, CSMIP volume 2, USGS SMC, ESM, "
            "K-NET/KiK-net, GeoNet, ObsPy, columns of numbers");
}

}  // namespace
}  // namespace rockstack
