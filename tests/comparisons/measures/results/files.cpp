#include "comparisons/measures/results/files.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "analytic/scene/messages/input_error.hpp"
#include "analytic/scene/messages/one_line.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

std::string content(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Files, AreReplacedWhole) {
  const TemporaryFolder folder;
  write_file(folder.path() / "a", "first, and longer");
  write_file(folder.path() / "a", "second");
  EXPECT_EQ(content(folder.path() / "a"), "second");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.partial"));
}

TEST(Files, NeverWriteThroughALinkAtTheTemporaryName) {
  const TemporaryFolder folder;
  write_file(folder.path() / "kept", "kept");
  std::filesystem::create_symlink("kept", folder.path() / "a.partial");
  write_file(folder.path() / "a", "new");
  EXPECT_EQ(content(folder.path() / "kept"), "kept");
  EXPECT_EQ(content(folder.path() / "a"), "new");
  std::filesystem::create_symlink("kept", folder.path() / "runs.journal");
  EXPECT_THROW((Journal{folder.path(), "a sweep"}), std::runtime_error);
}

TEST(Files, ThatCannotBeWrittenAreNamedAndLeaveNothing) {
  const TemporaryFolder folder;
  try {
    write_file(folder.path() / "missing" / "a", "text");
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("missing/a: cannot be written: No such file"), std::string::npos)
        << error.what();
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Files, NamesOfFoldersAreShortAndStillTellTextsApart) {
  EXPECT_EQ(folder_name("scene.ode-step-tuned-0.001"), "scene.ode-step-tuned-0.001");
  std::string one(200, 'x');
  std::string other = one + "y";
  EXPECT_LE(folder_name(one).size(), 128U);
  EXPECT_NE(folder_name(one), folder_name(other));
  std::string letters;
  for (int k = 0; k < 100; ++k) letters += "ö";
  for (const std::string& text : {letters, "x" + letters}) {
    const std::string name = folder_name(text);
    EXPECT_EQ(name.substr(0, name.rfind('-')).size() % 2, text.size() % 2) << name;
  }
}

TEST(Files, NamesOfFoldersLeadNowhereElseAndAreOneLine) {
  std::set<std::string> names;
  const std::vector<std::string> texts{"..",  ".",   "",     ".hidden",  "../a",
                                       "a/b", "a-b", "a\nb", "a\x1b[2J", "/"};
  for (const std::string& text : texts) {
    const std::string name = folder_name(text);
    EXPECT_EQ(std::filesystem::path(name).filename(), name);
    EXPECT_FALSE(name.empty() || name.starts_with('.')) << name;
    EXPECT_EQ(one_line(name), name);
    names.insert(name);
  }
  EXPECT_EQ(names.size(), texts.size());
  for (const char* plain : {"a-b", "Säule 1", "a.b", "friction=0.5"}) EXPECT_EQ(folder_name(plain), plain);
}

/// Why a folder cannot take results; empty where it can.
std::string refusal(const std::filesystem::path& folder, Results kind, const std::string& subject = "",
                    bool replace = false) {
  try {
    const ResultsFolder results(folder, kind, subject, replace);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Files, AFolderHoldsResultsOfOneKindWithoutThoseOfBefore) {
  const TemporaryFolder folder;
  {
    const ResultsFolder results(folder.path(), Results::comparison);
    folder.write("fits.csv", "stale");
    folder.write("kept.txt", "a user's own, put there later");
    std::filesystem::create_directories(folder.path() / "runs" / "a");
    std::filesystem::create_directories(folder.path() / "figures");
    EXPECT_EQ(
        refusal(folder.path(), Results::comparison),
        "--out " + folder.path().string() + ": must be a folder that no other run writes into just now");
  }
  EXPECT_EQ(refusal(folder.path(), Results::comparison), "");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "fits.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "figures"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "kept.txt"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "runs" / "a"));
  EXPECT_EQ(refusal(folder.path(), Results::sweep),
            "--out " + folder.path().string() + ": must be a folder of its own: it holds a comparison");
}

TEST(Files, AFolderHoldsResultsOfOneSceneUnlessTheyAreToBeReplaced) {
  const TemporaryFolder folder;
  EXPECT_EQ(refusal(folder.path(), Results::comparison), "");  // as before folders said what they are of
  EXPECT_EQ(refusal(folder.path(), Results::comparison, "column"), "");
  folder.write("comparison.csv", "of the column");
  std::filesystem::create_directories(folder.path() / "runs" / "column.exact");
  EXPECT_EQ(refusal(folder.path(), Results::comparison, "shed"),
            "--out " + folder.path().string() +
                ": must be a folder of its own: it holds a comparison of column; "
                "--replace puts shed in its place");
  EXPECT_EQ(content(folder.path() / "comparison.csv"), "of the column");
  EXPECT_EQ(refusal(folder.path(), Results::comparison, "column"), "");
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "runs" / "column.exact"));
  EXPECT_EQ(refusal(folder.path(), Results::comparison, "shed", true), "");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "runs"));
  EXPECT_NE(refusal(folder.path(), Results::comparison, "column"), "");
}

TEST(Files, AFolderWithFilesOfOthersIsLeftAlone) {
  const TemporaryFolder folder;
  folder.write(".hidden", "of the desktop");
  EXPECT_EQ(refusal(folder.path(), Results::motion), "");
  std::filesystem::remove(folder.path() / ".results");
  folder.write("report.html", "a report of a stranger");
  EXPECT_EQ(refusal(folder.path(), Results::motion),
            "--out " + folder.path().string() +
                ": must be empty or hold results: report.html is there, and is not ours");
  EXPECT_EQ(content(folder.path() / "report.html"), "a report of a stranger");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / ".results"));
}

TEST(Files, AFolderThatNothingComesIntoGoesAgain) {
  const TemporaryFolder folder;
  EXPECT_EQ(refusal(folder.path() / "a" / "b", Results::motion), "");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  std::filesystem::create_directories(folder.path() / "a");
  {
    const ResultsFolder results(folder.path() / "a" / "b", Results::motion);
    folder.write("a/b/history.csv", "time\n");
  }
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "a" / "b" / "history.csv"));
}

TEST(Files, AFolderIsKeptForOneRunAtATime) {
  const TemporaryFolder folder;
  {
    const FolderLock lock(folder.path());
    EXPECT_THROW(FolderLock{folder.path()}, InputError);
  }
  EXPECT_NO_THROW(FolderLock{folder.path()});
}

TEST(Files, AFolderThatIsAFileIsBadInput) {
  const TemporaryFolder folder;
  write_file(folder.path() / "a", "");
  EXPECT_NE(refusal(folder.path() / "a", Results::motion), "");
  EXPECT_NE(refusal(folder.path() / "a" / "b", Results::motion), "");
}

}  // namespace
}  // namespace rockstack
