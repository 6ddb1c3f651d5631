#include "comparisons/measures/results/results_folder.hpp"

#include <fmt/format.h>

#include <fstream>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "analytic/scene/messages/input_error.hpp"

namespace rockstack {
namespace {

struct Kind {
  const char* name;
  std::vector<const char*> derived;  ///< from runs, or by a command that has none
};

Kind kind_of(Results results) {
  switch (results) {
    case Results::motion:
      return {"one motion",
              {"summary.json", "history.csv", "events.csv", "ground.csv", "figures", "report.html"}};
    case Results::comparison:
      return {"a comparison",
              {"comparison.json", "comparison.csv", "fits.csv", "distributions.csv", "ground", "figures",
               "report.html"}};
    case Results::lesson:
      return {"a lesson",
              {"lesson.html", "slides.html", "slides.pdf", "lesson.json", "comparison.json", "comparison.csv",
               "fits.csv", "distributions.csv", "ground", "figures", "report.html"}};
    case Results::advice:
      return {"advice", {"advice.json", "advice.csv", "figures", "report.html"}};
    case Results::stability:
      return {"a study of stability",
              {"stability.json", "stability.csv", "steps.csv", "comparison.json", "comparison.csv",
               "fits.csv", "distributions.csv", "ground", "figures", "report.html"}};
    case Results::impact_laws:
      return {"a study of impact laws",
              {"impact-laws.json", "impact-laws.csv", "impact-laws-engines.csv", "figures", "report.html"}};
    case Results::sweep:
      return {
          "a sweep",
          {"sweep.json", "runs.csv", "timing.json", "fragility.csv", "fragility-fit.csv", "incremental.csv",
           "incremental-fractiles.csv", "overturning.csv", "modes.csv", "figures", "report.html"}};
    case Results::diff:
      return {"results held together", {"diff.json", "diff.csv"}};
    case Results::canon:
      return {"a canon", {"canon.json", "canon.csv", "report.html"}};
    case Results::course:
      return {"a course", {"index.html", "course.json"}};
    case Results::sheets:
      return {"problem sheets", {}};
    case Results::record:
      break;
  }
  return {"a record", {"record.json", "record.csv", "spectrum.csv", "figures", "report.html"}};
}

namespace fs = std::filesystem;

constexpr const char* mark_name = ".results";

InputError no_folder(const fs::path& folder, const std::string& why) {
  return InputError(fmt::format("--out {}: must be a folder that can be written: {}", folder.string(), why));
}

/// Makes a folder with those that it lies in, and returns those that were not there.
std::vector<fs::path> make_folders(const fs::path& folder) {
  std::vector<fs::path> made;
  std::error_code error;
  for (fs::path above = fs::absolute(folder); !fs::exists(above, error) && above != above.root_path();
       above = above.parent_path())
    made.push_back(above);
  fs::create_directories(folder, error);
  if (!error && !fs::is_directory(folder, error)) error = std::make_error_code(std::errc::not_a_directory);
  if (error) throw no_folder(folder, error.message());
  return made;
}

/// The first file that is no mark of ours; hidden ones belong to the desktop.
std::optional<std::string> foreign_file(const fs::path& folder) {
  std::set<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    names.insert(entry.path().filename().string());
  std::erase_if(names, [](const std::string& name) { return name.starts_with('.'); });
  return names.empty() ? std::nullopt : std::optional(*names.begin());
}

}  // namespace

ResultsFolder::ResultsFolder(const fs::path& folder, Results results)
    : folder_(folder), made_(make_folders(folder)), lock_(folder) {
  const Kind kind = kind_of(results);
  std::string found;
  std::getline(std::ifstream(folder / mark_name), found);
  if (!found.empty() && found != kind.name)
    throw InputError(
        fmt::format("--out {}: must be a folder of its own: it holds {}", folder.string(), found));
  if (const auto foreign = foreign_file(folder); foreign && found.empty())
    throw InputError(fmt::format("--out {}: must be empty or hold results: {} is there, and is not ours",
                                 folder.string(), *foreign));
  try {
    write_file(folder / mark_name, std::string(kind.name) + "\n");
  } catch (const std::runtime_error& failure) {
    throw no_folder(folder, failure.what());
  }
  for (const char* name : kind.derived) fs::remove_all(folder / name);
}

ResultsFolder::~ResultsFolder() {
  std::error_code ignored;
  if (made_.empty() || foreign_file(folder_)) return;
  fs::remove(folder_ / mark_name, ignored);
  for (const fs::path& folder : made_) fs::remove(folder, ignored);
}

}  // namespace rockstack
