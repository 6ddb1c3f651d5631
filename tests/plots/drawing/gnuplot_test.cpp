#include "plots/drawing/gnuplot.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "plots/drawing/layout.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

bool holds_nothing(const fs::path& folder) {
  return !fs::exists(folder) || fs::is_empty(folder);
}

/// Sets PATH for as long as it lives.
struct SearchPath {
  std::string before = std::getenv("PATH");
  explicit SearchPath(const std::string& path) { ::setenv("PATH", path.c_str(), 1); }
  ~SearchPath() { ::setenv("PATH", before.c_str(), 1); }
  SearchPath(const SearchPath&) = delete;
  SearchPath& operator=(const SearchPath&) = delete;
};

/// A program named gnuplot that does what `body` says.
fs::path false_gnuplot(const fs::path& folder, const std::string& body) {
  fs::create_directories(folder);
  std::ofstream(folder / "gnuplot") << "#!/bin/sh\n" << body << "\n";
  fs::permissions(folder / "gnuplot", fs::perms::owner_all);
  return folder;
}

std::string failure_with(const std::string& path, const fs::path& stem) {
  const SearchPath search(path);
  try {
    draw(Drawing{.data = std::string(200'000, '#') + "\n", .commands = "plot x"}, stem);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Gnuplot, ItsOwnWordsStandInTheError) {
  const fs::path stem = testing::fresh_folder() / "broken";
  try {
    draw(Drawing{.data = "", .commands = "plot no_such_thing"}, stem);
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("undefined variable: no_such_thing"), std::string::npos)
        << error.what();
  }
  EXPECT_TRUE(holds_nothing(stem.parent_path()));
}

TEST(Gnuplot, ThatIsNotThereIsNamed) {
  const fs::path folder = testing::fresh_folder();
  EXPECT_NE(failure_with((folder / "empty").string(), folder / "picture").find("gnuplot is not installed"),
            std::string::npos);
  EXPECT_TRUE(holds_nothing(folder));
}

TEST(Gnuplot, ThatDiesHalfwayLeavesNothing) {
  const fs::path folder = testing::fresh_folder();
  const fs::path programs = false_gnuplot(folder / "programs", "echo half > picture.png; kill -9 $$");
  EXPECT_NE(failure_with(programs.string(), folder / "out" / "picture").find("status 137"),
            std::string::npos);
  EXPECT_TRUE(holds_nothing(folder / "out"));
}

TEST(Gnuplot, ThatSaysItIsDoneButIsNotLeavesNothing) {
  const fs::path folder = testing::fresh_folder();
  const fs::path programs = false_gnuplot(folder / "programs", "echo half > picture.png; exit 0");
  EXPECT_NE(failure_with(programs.string(), folder / "out" / "picture").find("unfinished"),
            std::string::npos);
  EXPECT_TRUE(holds_nothing(folder / "out"));
}

TEST(Gnuplot, ThatHangsIsEnded) {
  const fs::path folder = testing::fresh_folder();
  const SearchPath path(false_gnuplot(folder / "programs", "exec /bin/sleep 1000").string());
  try {
    draw(Drawing{.data = "", .commands = std::string(200'000, '\n'), .time_limit = 0.1}, folder / "picture");
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("gnuplot has not drawn"), std::string::npos) << error.what();
  }
}

TEST(Gnuplot, TheUsersTerminalDoesNotCount) {
  const fs::path folder = testing::fresh_folder();
  ::setenv("GNUTERM", "no-such-terminal", 1);
  EXPECT_NO_THROW(draw(Drawing{.data = "", .commands = "plot x"}, folder / "picture"));
  ::unsetenv("GNUTERM");
}

TEST(Gnuplot, TextIsDrawnAsItStandsWhateverSignsItHas) {
  const fs::path folder = testing::fresh_folder();
  for (const std::string text : {"'quoted'", "''", "\"double\"", "back\\slash \\n", "`touch ran`",
                                 "@macro $x %g", "Blöcke θ₁ {_^} & <b>"}) {
    draw(Drawing{.data = "", .commands = "set title " + in_quotes(text) + " noenhanced\nplot x"},
         folder / "picture");
    std::string shown = text;
    for (const auto& [sign, word] : {std::pair{"&", "&amp;"}, {"<", "&lt;"}})
      if (const auto at = shown.find(sign); at != std::string::npos) shown.replace(at, 1, word);
    EXPECT_NE(testing::bytes_of(folder / "picture.svg").find(shown), std::string::npos) << text;
  }
  EXPECT_FALSE(fs::exists("ran"));
}

}  // namespace
}  // namespace rockstack::plots
