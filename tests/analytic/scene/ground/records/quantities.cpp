#include <gtest/gtest.h>

#include "analytic/scene/ground/records/record_file.hpp"
#include "tests/analytic/scene/ground/records/refusals.hpp"

namespace rockstack {
namespace {

constexpr const char* rows = "0.00,0.5\n0.02,1\n0.04,0.7\n";

/// Which column of a text was taken, or why none was.
std::string taken_of(const std::string& text) {
  const std::string error = error_of_text(text);
  return error.empty() ? records::read_series("file", text).front().taken : error;
}

TEST(Titles, TimeIsWhatTheyCallSoAndNoOtherFirstColumn) {
  for (const std::string title :
       {"x (km)", "Depth (km)", "Floor (-)", "Load (kN)", "Temperature (K)", "Mass [kg]", "Energy (kJ)",
        "Pressure (kPa)", "f (MHz)", "Distance [km]", "Magnitude", "Run", "x"})
    expect_error(title + ",acc (g)\n" + rows, "none of them times by its title");
  for (const std::string title : {"t", "time (s)", "Zeit", "Tiempo (seg)", "Zaman (sn)",
                                  "\u03a7\u03c1\u03cc\u03bd\u03bf\u03c2 (s)", "x (s)", "seconds"})
    EXPECT_DOUBLE_EQ(read_text(title + ",acc (g)\n" + rows).interval, 0.02) << title;
  EXPECT_NEAR(read_text("millis,ax_mg\n5321,1\n5331,2\n").interval, 0.01, 1e-12);
  EXPECT_NEAR(read_text("micros,ax [mg]\n5321000,1\n5331000,2\n").interval, 0.01, 1e-12);
}

TEST(Titles, PeriodsOfASpectrumAreNoTimesInAnyLanguage) {
  for (const std::string title :
       {"Periodo [s]", "Schwingdauer [s]", "Per\u00edodo [s]", "P\u00e9riode [s]",
        "\u03a0\u03b5\u03c1\u03af\u03bf\u03b4\u03bf\u03c2 [s]", "Periyot [s]", "Eigenperiode (s)",
        "\u041f\u0435\u0440\u0438\u043e\u0434 (s)", "Fr\u00e9quence (Hz)", "Frecuencia"})
    expect_error(title + ",acc [g]\n" + rows, "a spectrum is no record");
}

TEST(Headings, OfASpectrumAreRefusedUnlessTimeIsNamedInFull) {
  for (const std::string heading :
       {"# Response spectrum, 5 % damping", "# Spettro di risposta elastico", "Antwortspektrum",
        "# Espectro de respuesta", "# EC8 elastic spectrum, soil C"}) {
    expect_error(heading + "\nT (s),acc (g)\n" + rows, "speaks of a spectrum");
    EXPECT_EQ(error_of_text(heading + "\nTime (s),acc (g)\n" + rows), "");
  }
  expect_error("PSEUDO SPECTRAL ACCELERATION IN UNITS OF G\nNPTS= 3, DT= .01\n1 2 3\n",
               "speaks of a spectrum");
  EXPECT_EQ(error_of_text("# Spectrum-compatible accelerogram\nt (s),acc (g)\n" + std::string(rows)), "");
}

TEST(Titles, OfAnotherQuantityAreNoAcceleration) {
  for (const std::string title :
       {"Rocking angle", "Force", "Kraft", "Voltage", "Spannung", "Angular acceleration", "angular acc",
        "rotational acceleration", "Winkelbeschleunigung", "Total mass [g]", "Temperature", "Pressure",
        "Strain", "Load", "PGA (g)", "Carga", "Kuvvet"}) {
    expect_error("# units: g\nTime (s)," + title + "\n" + rows, "no column is an acceleration");
    EXPECT_EQ(taken_of("# units: g\nTime (s)," + title + ",Acc\n0,9,0.5\n0.02,9,1\n0.04,9,0\n"),
              "column 3 of 3, \"Acc\"");
  }
  EXPECT_EQ(taken_of("# units: g\nZaman;Deplasman;\u0130vme\n0;9;0.5\n0.02;9;1\n"),
            "column 3 of 3, \"\u0130vme\"");
  EXPECT_EQ(
      taken_of("Time (s),Angular acceleration (rad/s2),Acceleration at mass 1 (m/s2)\n0,9,0.5\n0.02,9,1\n"),
      "column 3 of 3, \"Acceleration at mass 1 (m/s2)\"");
}

TEST(Titles, ThatNameNoQuantityAreThoseOfChannels) {
  for (const std::string title :
       {"NS", "HNE", "CH1", "North", "Channel 2", "Longitudinal", "A1", "Table motion", "x"})
    EXPECT_EQ(error_of_text("# units: g\nTime (s)," + title + "\n" + rows), "") << title;
  for (const std::string title : {"Brightness", "Helligkeit"})
    expect_error("# units: g\nTime (s)," + title + "\n" + rows,
                 "whether this is an acceleration must be said");
}

TEST(Titles, ThatNameMeasuresAreNoneOfAMotion) {
  for (const std::string title :
       {"Flow (m/s)", "Acceleration RMS (m/s2)", "Envelope of acceleration (g)", "Shear wave velocity (m/s)",
        "Cumulative absolute velocity (m/s)", "Crack width (mm)"})
    expect_error("Time (s)," + title + "\n" + rows, "no column is an acceleration, velocity or displacement");
  for (const std::string title : {"Acc/PGA (m/s2)", "a/g (m/s2)", "Acceleration 1e-1 m/s2"})
    expect_error("Time (s)," + title + "\n" + rows, "names a factor");
  expect_error("t (s),a_g\n" + std::string(rows), "no unit of acceleration");
}

TEST(Titles, MayStandBehindTheWordOfTheirList) {
  const std::string numbers = "0.00 0.5 0.1\n0.02 1 0.2\n0.04 0.7 0.3\n";
  for (const std::string line :
       {"Columns: t (s), d (mm), a (m/s2)", "Data: time (s), force (kN), acc (m/s2)", "Units: s, mm, m/s2"}) {
    const Record record = read_text(line + "\n" + numbers);
    EXPECT_EQ(record.samples, (std::vector<double>{0.1, 0.2, 0.3})) << line;
  }
}

TEST(Numbers, ThatMayHaveThousandsOrMarksAreRefused) {
  expect_error("Time (ms);a (mm/s2)\n0;32\n10;1.307\n20;840\n", "may part thousands");
  expect_error("Time (ms),\"Acc (mm/s2)\"\n0,\"32\"\n10,\"-1,307\"\n20,\"840\"\n", "may part thousands");
  expect_error("Time (s),Acc (cm/s2)\n0,32\n0.01,-999\n0.02,-999\n", "marks missing data");
  expect_error("Time (s),Acc (m/s2)\n0,0.1\n0.01,0.2\nOVER,1\nOVER,2\nOVER,3\nOVER,1\n", "below the numbers");
  expect_error("Time (s),Acc (m/s2)\n0,0.1\n0.01,0.2\n#0.02,0.3\n", "below the numbers");
  EXPECT_EQ(error_of_text("Time (s),Acc (m/s2)\n0,0.1\n0.01,0.2\nMax,0.2\n"), "");
}

TEST(Titles, MustBeAsManyAsColumns) {
  EXPECT_EQ(error_of_text("Time (s),Disp (cm),Acc (g)\n" + std::string(rows)),
            "file:1: 3 titles above numbers in 2 columns: must be as many");
  EXPECT_EQ(error_of_text("Time (s)\tDisp (cm)\tAcc (g)\n0.0\t0.5\n0.1\t0.6\n"),
            "file:1: 3 titles above numbers in 2 columns: must be as many");
  EXPECT_EQ(error_of_text("Time (s),Acc (g)\n0,1,2\n0.1,1,2\n0.2,3,4\n"),
            "file:1: 2 titles above numbers in 3 columns: must be as many");
}

TEST(Factors, InHeadersAndTitlesAreRefused) {
  for (const std::string line : {"Scale factor: 9.81", "scale factor 2", "Multiplier: 0.5", "gain: 10",
                                 "-factor 9.81", "Calibration = 0.5", "Faktor: 1,5", "Scale factor: 1,000",
                                 "values multiplied by 1000", "scale_factor: 2"})
    expect_error("# " + line + "\ntime (s),acc (g)\n" + rows, "file:1: names a factor");
  for (const std::string line : {"Scale factor: 1.0", "gain: 1", "scale 1:5", "Damping factor: 0.05",
                                 "Scale factor", "amplification factor 2 applied"})
    EXPECT_EQ(error_of_text("# " + line + "\ntime (s),acc (g)\n" + rows), "") << line;
  for (const std::string title :
       {"acc x 1000 (g)", "acc/10 (g)", "1000*acc (g)", "10 x acc (g)", "-acc (g)", "acc x10 (g)"})
    expect_error("time (s)," + title + "\n" + rows, "names a factor");
  for (const std::string title : {"acc x1 (g)", "acc 2 (g)", "acc_x (g)", "Accel x (g)"})
    EXPECT_EQ(error_of_text("time (s)," + title + "\n" + rows), "") << title;
  expect_error("time (s),normalised acceleration (g)\n" + std::string(rows), "normalised");
  expect_error("# normalized to 1\ntime (s),acceleration (g)\n" + std::string(rows), "normalised");
  expect_error("# units: m/s2 x 100\n0 1\n0.1 2\n", "'m/s2 x 100' is no unit of acceleration");
}

}  // namespace
}  // namespace rockstack
