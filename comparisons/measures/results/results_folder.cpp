#include "comparisons/measures/results/results_folder.hpp"

#include <fmt/format.h>

#include <fstream>
#include <string>
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
      return {"advice", {"advice.csv"}};
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

const std::filesystem::path& prepared(const std::filesystem::path& folder) {
  prepare_folder(folder);
  return folder;
}

}  // namespace

ResultsFolder::ResultsFolder(const std::filesystem::path& folder, Results results) : lock_(prepared(folder)) {
  const Kind kind = kind_of(results);
  const auto mark = folder / ".results";
  std::string found;
  std::getline(std::ifstream(mark), found);
  if (!found.empty() && found != kind.name) {
    throw InputError(
        fmt::format("--out {}: must be a folder of its own: it holds {}", folder.string(), found));
  }
  write_file(mark, std::string(kind.name) + "\n");
  for (const char* name : kind.derived) std::filesystem::remove_all(folder / name);
}

}  // namespace rockstack
