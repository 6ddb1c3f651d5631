#include "plots/figures/figure.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "plots/drawing/gnuplot.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

/// Pictures in a GIF: each is announced by a graphic control extension.
std::size_t pictures_in(const std::string& gif) {
  const std::string mark("\x21\xF9\x04", 3);
  std::size_t count = 0;
  for (std::size_t at = gif.find(mark); at != std::string::npos; at = gif.find(mark, at + 1)) ++count;
  return count;
}

TEST(Animation, HasAPictureAFrameAndAFilmWhereFfmpegIs) {
  const fs::path stem = testing::fresh_folder() / "film";
  const Animation animation{.width = 200,
                            .height = 100,
                            .settings = "unset key\nset xrange [0:3]\nset yrange [0:3]\n",
                            .frames = {"plot 1\n", "plot 2\n", "plot x\n"}};
  draw(animation, stem);
  const std::string gif = testing::bytes_of(fs::path(stem).concat(".gif"));
  EXPECT_EQ(gif.substr(0, 6), "GIF89a");
  EXPECT_EQ(pictures_in(gif), 3u);
  const fs::path film = fs::path(stem).concat(".mp4");
  EXPECT_EQ(fs::exists(film), has_program("ffmpeg"));
  if (has_program("ffmpeg")) {
    EXPECT_EQ(testing::bytes_of(film).substr(4, 4), "ftyp");
  }
}

TEST(Animation, GnuplotsOwnWordsStandInTheError) {
  const fs::path stem = testing::fresh_folder() / "film";
  try {
    draw(Animation{.settings = "", .frames = {"plot no_such_thing\n"}}, stem);
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("no_such_thing"), std::string::npos) << error.what();
  }
  EXPECT_FALSE(fs::exists(fs::path(stem).concat(".gif")));
}

TEST(Animation, OfASceneRunsAtItsStatedSpeed) {
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, {.blocks = 1, .engines = {}});
  std::ofstream(folder / "runs" / "sample.exact" / "history.csv")
      << "time,theta_1,omega_1,pattern\n0,0.1,0,R\n0.05,0.09,-0.2,R\n0.1,0.08,-0.2,R\n";
  fs::create_directories(folder / "figures");
  const std::vector<fs::path> files = draw_animations(folder);
  ASSERT_EQ(files.size(), has_program("ffmpeg") ? 2u : 1u);
  // 0.1 s at a tenth of the speed and 25 frames a second, and the last one.
  EXPECT_EQ(pictures_in(testing::bytes_of(folder / "figures" / "sample.motion.gif")), 26u);
}

}  // namespace
}  // namespace rockstack::plots
