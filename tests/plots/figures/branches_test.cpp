#include <gtest/gtest.h>

#include <fstream>

#include "plots/figures/figure.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

/// The history of a branch that leans to a side.
void write_lean(const fs::path& folder, double angle) {
  fs::create_directories(folder);
  std::ofstream(folder / "history.csv") << "time,theta_1,omega_1,pattern\n"
                                        << "0,0,0,C\n0.1," << angle << ",0,R\n0.2," << angle << ",0,R\n";
}

TEST(BranchesFigure, TellsWhatEachTakesAndHowItEnds) {
  const fs::path folder = testing::fresh_folder();
  std::ofstream(folder / "summary.json") << R"({"title": "A fork"})";
  std::ofstream(folder / "branches.csv")
      << "branch,parent,time,takes,instead_of,like,like_from,mirrored,ends,end_time,verdict\n"
      << "1,,,,,,,,rest,0.15,stands\n"
      << "2,1,0.05,R>,-,,,,topple,0.2,topples\n"
      << "3,1,0.05,L<,-,2,0.1,true,topple,0.2,topples\n";
  write_lean(folder, 0.1);
  write_lean(folder / "branches" / "2", 0.2);
  write_lean(folder / "branches" / "3", -0.2);
  draw_figures(folder);
  const std::string svg = testing::bytes_of(folder / "figures" / "branches.svg");
  for (const char* words : {"A fork", "3 branches, 2 of them unlike", "rest", "R>", "L&lt;", "topple",
                            "topple, mirror image of 2", "</svg>"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
}

}  // namespace
}  // namespace rockstack::plots
