#include "plots/figures/figure.hpp"

#include <fmt/ostream.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "analytic/scene/messages/input_error.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

/// What `rockstack record` writes of a decaying wave.
void write_record(const fs::path& folder) {
  std::ofstream(folder / "record.json")
      << R"({"file": "a/wave.at2", "channel": "1", "gravity": 9.80665, "spectrum_damping": 0.05,)"
      << R"("significant_5_95": {"begin": 0.2, "end": 3.1}, "arias_intensity": 0.4,)"
      << R"("peak_acceleration": {"value": 3, "time": 0.1}, "peak_velocity": {"value": -0.2, "time": 0.3},)"
      << R"("peak_displacement": {"value": 0.05, "time": 0.5}})";
  std::ofstream record(folder / "record.csv");
  record << "time,acceleration,velocity,displacement,husid\n";
  for (int i = 0; i <= 400; ++i) {
    const double t = 0.01 * i;
    const double wave = std::exp(-t) * std::sin(10 * t);
    fmt::print(record, "{},{},{},{},{}\n", t, 3 * wave, -0.2 * wave, 0.05 * wave, 1 - std::exp(-t));
  }
  std::ofstream spectrum(folder / "spectrum.csv");
  spectrum << "period,pseudo_acceleration\n";
  for (const double period : {0.05, 0.1, 0.5, 1.0, 4.0}) fmt::print(spectrum, "{},{}\n", period, 2 / period);
}

TEST(Record, ItsFigureIsDrawnFromTheFilesOfTheCommand) {
  const fs::path folder = testing::fresh_folder();
  write_record(folder);
  draw_figures(folder);
  EXPECT_EQ(testing::bytes_of(folder / "figures" / "record.png").substr(0, 8), "\x89PNG\r\n\x1a\n");
  const std::string svg = testing::bytes_of(folder / "figures" / "record.svg");
  for (const char* words :
       {"wave.at2", "3 m/s² at 0.1 s", "-0.2 m/s at 0.3 s", "Arias intensity 0.4 m/s", "</svg>"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
}

TEST(Record, AFileThatIsMissingOrHoldsNoSamplesIsNamed) {
  const fs::path folder = testing::fresh_folder();
  const auto error = [&] {
    try {
      draw_figures(folder);
    } catch (const InputError& problem) {
      return std::string(problem.what());
    }
    return std::string();
  };
  write_record(folder);
  fs::remove(folder / "record.json");
  EXPECT_NE(error().find("record.json"), std::string::npos);
  write_record(folder);
  std::ofstream(folder / "record.csv") << "time,acceleration,velocity,displacement,husid\n";
  EXPECT_NE(error().find("no samples"), std::string::npos);
  fs::remove(folder / "spectrum.csv");
  EXPECT_NE(error().find("spectrum.csv"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder / "figures"));
}

}  // namespace
}  // namespace rockstack::plots
