#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "analytic/scene/ground/ground_motion.hpp"
#include "analytic/scene/ground/records/record_file.hpp"
#include "tests/analytic/scene/ground/records/layouts.hpp"

namespace rockstack {
namespace {

/// Count, time step and peak as the header of a real record or its publisher's page gives them, and when the
/// peak is where it says that.
struct RealRecord {
  std::string file;
  std::string format;
  std::size_t samples;
  double interval;                  ///< s
  double peak;                      ///< in `unit`
  double digits;                    ///< half of the last decimal of `peak`
  double unit;                      ///< m/s²
  std::optional<double> time = {};  ///< of the peak, s
};

void PrintTo(const RealRecord& record, std::ostream* out) {
  *out << record.file;
}

class RealRecords : public testing::TestWithParam<RealRecord> {};

TEST_P(RealRecords, HaveTheCountStepAndPeakOfTheirHeader) {
  const char* const named = std::getenv("ROCKSTACK_RECORDS");
  const std::filesystem::path folder = named != nullptr ? named : ROCKSTACK_RECORDS;
  const RealRecord& expected = GetParam();
  if (!std::filesystem::exists(record_file(folder / expected.file))) {
    GTEST_SKIP() << "no real records: " << (folder / expected.file).string()
                 << " is not there; set ROCKSTACK_RECORDS to their folder";
  }
  const Record record = read_record(folder / expected.file);
  EXPECT_EQ(record.format, expected.format);
  EXPECT_EQ(record.samples.size(), expected.samples);
  EXPECT_DOUBLE_EQ(record.interval, expected.interval);
  constexpr double digits_lost = 1e-12;
  EXPECT_NEAR(peak({record.interval, record.samples, ""}) / expected.unit, expected.peak,
              expected.digits + digits_lost);
  if (!expected.time) return;
  const auto is_less = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto at = std::max_element(record.samples.begin(), record.samples.end(), is_less);
  EXPECT_NEAR(record.interval * static_cast<double>(at - record.samples.begin()), *expected.time, 1e-9);
}

// PEER files name no peak: those of the first three are their publisher's, the others the largest printed
// value.
INSTANTIATE_TEST_SUITE_P(
    Peer, RealRecords,
    testing::Values(
        RealRecord{"SVSC_SimiValleyKatherine_NS_000.AT2", "PEER AT2", 2499, 0.01, 0.877, 0.0005, g, 5.45},
        RealRecord{"SVSC_SimiValleyKatherine_EW_090.AT2", "PEER AT2", 2499, 0.01, 0.640, 0.0005, g},
        RealRecord{"SVSC_SimiValleyKatherine_UD.AT2", "PEER AT2", 2499, 0.01, 0.402, 0.0005, g},
        RealRecord{"formats/IELC180_OpenSees.AT2", "PEER AT2", 4000, 0.01, 0.3128806, 0, g},
        RealRecord{"formats/RSN126_GAZLI_GAZ000.AT2", "PEER AT2", 2048, 0.0066, 0.7017079, 0, g},
        RealRecord{"formats/RSN960_NORTHR_LOS270.AT2", "PEER AT2", 1999, 0.01, 0.4716259, 0, g},
        RealRecord{"formats/el_centro_OpenSeesDays.AT2", "PEER AT2", 1559, 0.02, 0.31882, 0, g},
        RealRecord{"formats/elCentro1940_Peknold_OpenSees.AT2", "PEER AT2", 1559, 0.02, 0.31882, 0, g}));

INSTANTIATE_TEST_SUITE_P(
    Others, RealRecords,
    testing::Values(
        RealRecord{"formats/CIWLT.V2", "CSMIP volume 2", 15050, 0.02, 82.584, 0.0005, gal, 14.84},
        RealRecord{"formats/CIWLT.V2:2", "CSMIP volume 2", 15029, 0.02, 115.845, 0.0005, gal, 14.52},
        RealRecord{"formats/CIWLT.V2:3", "CSMIP volume 2", 15050, 0.02, 69.662, 0.0005, gal, 12.06},
        RealRecord{"formats/017m30bt.s0a", "CSMIP volume 2", 1887, 0.02, 242.395, 0.0005, gal, 4.58},
        RealRecord{"formats/Cosmos12TimeSeriesTest.v1", "COSMOS", 7000, 0.01, 161.962, 0.0005, gal, 27.85},
        RealRecord{"formats/0111a.smc", "USGS SMC", 6001, 0.005, 104.4, 0.05, gal, 10.17},
        RealRecord{"formats/HI.ARS1..HNE.D.20190728.160908.C.ACC.ASC", "ESM ASCII", 19128, 0.005, 0.300022,
                   5e-7, gal, 20.67},
        RealRecord{"formats/AOM0011801241951.EW", "K-NET/KiK-net ASCII", 10200, 0.01, 4.078, 0.0005, gal},
        RealRecord{"formats/NGNH311106302345.EW2", "K-NET/KiK-net ASCII", 12000, 0.01, 0.708, 0.0005, gal}));

}  // namespace
}  // namespace rockstack
