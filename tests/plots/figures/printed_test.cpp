// Every figure of figures.txt in print, at the widths of a column and of a page: laws that hold for any of
// them.

#include <gtest/gtest.h>

#include <fstream>

#include "comparisons/measures/results/csv.hpp"
#include "plots/figures/figure.hpp"
#include "tests/plots/picture.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

/// Files of made-up results by their names.
using Files = std::map<std::string, std::string>;

constexpr auto sweep =
    R"({"title": "A made-up sweep of a block whose title takes more than a line", "vary": [],
        "summary": {"intensity": "ground.horizontal.peak", "period": "", "friction": "contact.friction"}})";
constexpr auto threshold =
    R"({"title": "A threshold", "happens": "topples", "headline": ["It topples from 2.5 on."],
        "vary": {"key": "ground.horizontal.scale", "low": 0.5, "high": 3.5},
        "over": {"key": "blocks.1.width", "low": 0.5, "high": 1.5}})";

std::string trial(const char* solver, double dt, double off, double seconds, bool passes) {
  return fmt::format(
      R"({{"run": "{0}-{1}", "engine": "own", "solver": "{0}", "settings": "tuned", "status": "done", "dt": {1},
           "largest_angle_difference": {2}, "stepping_time_minimum": {3}, "passes": {4}}})",
      solver, dt, off, seconds, passes);
}

/// Results of studies, by the file without which they have no figure.
std::map<std::string, Files> made_up_studies() {
  std::map<std::string, Files> studies;
  studies["fragility.csv"] = {{"sweep.json", sweep},
                              {"fragility.csv",
                               "intensity,runs,toppled,failed,fraction,lower,upper,fitted\n"
                               "2,20,0,0,0,0,0.16,0.02\n3,20,9,0,0.45,0.25,0.65,0.4\n"},
                              {"fragility-fit.csv", "median,beta,log_likelihood\n3.1,0.3,-20\n"}};
  const std::string bar = ",toppled,ground.horizontal.synthetic,0.3,0.2,0.4,0.5,0.4,0.6,0.4,99,0\n";
  studies["indices.csv"] = {{"sweep.json", sweep},
                            {"indices.csv",
                             "intensity,outcome,key,first,first_lower,first_upper,total,total_lower,total_"
                             "upper,deviation,samples,left_out\n2" +
                                 bar + "3" + bar}};
  std::string curves = "curve,values,intensity,peak_ratio,toppled\n";
  for (int i = 1; i <= 8; ++i) curves += fmt::format("{0},seed={0},2,0.{0},0\n{0},seed={0},4,5,1\n", i);
  studies["incremental.csv"] = {{"sweep.json", sweep}, {"incremental.csv", curves}};
  studies["overturning.csv"] = {
      {"sweep.json", sweep},
      {"overturning.csv",
       "period,frequency,intensity,runs,rest,rocking,toppled_after_impact,toppled_without_impact,failed\n"
       "0.5,2,1,1,1,0,0,0,0\n0.5,2,2,1,0,1,0,0,0\n0.25,4,1,1,1,0,0,0,0\n0.25,4,2,1,0,0,0,1,0\n"}};
  studies["modes.csv"] = {
      {"sweep.json", sweep},
      {"modes.csv",
       "intensity,friction,runs,onset_rest,onset_slide,onset_rock,onset_slide_rock,onset_free_flight,rest,"
       "slide,rock,slide_rock,free_flight,topple,fall,failed\n"
       "2,0.3,1,1,0,0,0,0,1,0,0,0,0,0,0,0\n2,0.6,1,1,0,0,0,0,1,0,0,0,0,0,0,0\n"
       "4,0.3,1,0,1,0,0,0,0,1,0,0,0,0,0,0\n4,0.6,1,0,0,1,0,0,0,0,0,0,0,1,0,0\n"}};
  studies["threshold-ranges.csv"] = {{"threshold.json", threshold},
                                     {"threshold.csv", "value,peak_ratio,toppled\n1,0.2,0\n2,0.7,0\n3,9,1\n"},
                                     {"threshold-ranges.csv", "from,to,happens\n0.5,2.5,0\n2.5,3.5,1\n"}};
  studies["threshold-spectrum.csv"] = {{"threshold.json", threshold},
                                       {"threshold-spectrum.csv", "value,first\n0.5,2\n1,2.5\n1.5,3\n"}};
  std::string stability = "engine,solver,settings,value,dt,verdict\n", steps =
                                                                           "engine,solver,settings,value,"
                                                                           "largest_stable_step\n";
  for (const char* value : {"1e-06", "0.0001", "0.01", "0.1", "1", "10", "100", "1e+04", "1e+06"}) {
    for (const char* dt : {"0.001", "0.01"})
      stability += fmt::format("ode,step,tuned,{},{},sound\n", value, dt);
    steps += fmt::format("ode,step,tuned,{},0.001\n", value);
  }
  studies["stability.csv"] = {
      {"stability.json", R"({"title": "Two blocks", "axis": "mass of the top block"})"},
      {"stability.csv", stability},
      {"steps.csv", steps}};
  std::string cells =
      "blocks,kind,aspect_ratio_from,aspect_ratio_to,mass_ratio_from,mass_ratio_to,impacts,"
      "differ,none\n";
  for (const char* kind : {"4a-blocks", "1a-blocks", "1a-ground"})
    for (const char* cell : {"0.25,1,0.05,1", "1,8,0.05,1", "0.25,1,1,20", "1,8,1,20"})
      cells += fmt::format("2,{},{},100,20,0\n", kind, cell);
  const Files laws{{"impact-laws.csv", cells},
                   {"impact-laws-engines.csv",
                    "case,engine,solver,settings,dt,status,reason,follows,from_paper,from_consistent\n"
                    "a,ode,step,tuned,0.0001,done,,consistent,0.07,0.003\n"
                    "b,ode,step,tuned,0.0001,done,,paper,0.002,0.05\n"
                    "a,bullet,nncg,tuned,0.0001,done,,consistent,0.03,0.001\n"}};
  studies["impact-laws.csv"] = studies["impact-laws-engines.csv"] = laws;
  const std::string picked = trial("one", 1e-3, 2e-3, 1e-2, true);
  studies["advice.json"] = {{"advice.json", R"({"title": "A column", "error": 0.01, "pick": )" + picked +
                                                R"(, "trials": [)" + trial("one", 1e-2, 0.1, 1e-3, false) +
                                                "," + picked + "," + trial("two", 1e-3, 1e-3, 2e-2, true) +
                                                "]}"}};
  const std::string lean = "time,theta_1,omega_1,pattern\n0,0,0,C\n0.1,0.2,0,R\n0.2,0.2,0,R\n";
  studies["branches.csv"] = {
      {"summary.json", R"({"title": "A fork"})"},
      {"branches.csv",
       "branch,parent,time,takes,instead_of,like,like_from,mirrored,ends,end_time,verdict\n"
       "1,,,,,,,,rest,0.15,stands\n2,1,0.05,R>,-,,,,topple,0.2,topples\n"},
      {"history.csv", lean},
      {"branches/2/history.csv", lean}};
  studies["fit.json"] = {
      {"fit.json",
       R"({"title": "A test", "columns": ["angle"], "unit": "rad", "horizon": 0.2, "meaning": [""]})"},
      {"fit.csv", "time,measured_angle,fitted_angle\n0,0.1,0.1\n0.1,,0.05\n0.2,-0.1,-0.1\n"}};
  studies["record.csv"] = {
      {"record.json",
       R"({"file": "a/wave.at2", "channel": "1", "gravity": 9.80665, "spectrum_damping": 0.05,
           "significant_5_95": {"begin": 0.2, "end": 3.1}, "arias_intensity": 0.4,
           "peak_acceleration": {"value": 3, "time": 0.1}, "peak_velocity": {"value": -0.2, "time": 0.3},
           "peak_displacement": {"value": 0.05, "time": 0.5}})"},
      {"record.csv",
       "time,acceleration,velocity,displacement,husid\n0,0,0,0,0\n1,3,0.2,0.05,0.6\n4,-1,0,0,1\n"},
      {"spectrum.csv", "period,pseudo_acceleration\n0.05,20\n0.5,40\n4,1\n"}};
  return studies;
}

void write_files(const fs::path& folder, const Files& files) {
  for (const auto& [name, text] : files) {
    fs::create_directories((folder / name).parent_path());
    std::ofstream(folder / name) << text;
  }
}

constexpr auto one_fit = R"([
  {"scene": "sample", "engine": "bullet", "solver": "sequential-impulse", "settings": "tuned",
   "quantity": "rms_angle_difference", "steps": 5, "gap": 1e-4, "gap_low": 5e-5, "gap_high": 2e-4, "order": 1,
   "order_low": 0.9, "order_high": 1.1, "coefficient": 2, "scatter": 0.1, "holds": true, "reason": ""}])";
constexpr auto one_distance =
    R"([{"scene": "sample", "run": "sample.ode.step.default.0.01", "quantity": "impacts", "exact_runs": 19,
         "runs": 19, "exact_mean": 21.5, "mean": 21.5, "distance": 0.4, "critical": 0.3, "p_value": 0.01}])";

/// Comparisons that have between them all that a figure of a scene shows: of few engines, and of many.
std::vector<testing::Sample> made_up_comparisons() {
  const testing::SampleEngine open{"ode", "step", "default", 3e-3};
  testing::Sample few{.title = "A made-up scene of two blocks that slide on a floor and on each other",
                      .engines = {{"bullet", "sequential-impulse", "tuned", 2e-3},
                                  open,
                                  {"linear", "taylor", "", 1e-3},
                                  {"friction=0.3", "taylor", "", 2e-2}},
                      .steps = {1e-2, 1e-3},
                      .tested = true,
                      .slides = true,
                      .results = {"angles", "impacts", "patterns", "bodies", "histories", "forces"},
                      .distributions = one_distance,
                      .fits = one_fit};
  testing::Sample many = few;
  many.engines = {open};
  for (const char* solver : {"sequential-impulse", "nncg", "mlcp-pgs", "mlcp-dantzig"})
    for (const char* settings : {"default", "tuned"})
      many.engines.push_back({"bullet", solver, settings, 2e-3});
  many.shaken = true;
  many.predictable_time = 3;
  return {few, many};
}

/// Laws of a drawing on paper.
void expect_printed(const Drawing& drawing, const fs::path& stem, const PrintStyle& style) {
  const std::string name = fmt::format("{} at {} mm", stem.filename().string(), style.width);
  draw(drawing, stem);
  const fs::path svg = fs::path(stem).concat(".svg");
  const testing::Picture picture = testing::read_picture(svg);
  constexpr double millimetres = 25.4, points = 72, rounding = 0.02;
  constexpr double mean = 1.1;  // of the letters of DejaVu Sans, to what is taken for each
  EXPECT_EQ(testing::collisions(picture, mean), std::vector<std::string>()) << name;
  for (const testing::ShownText& text : picture.texts)
    EXPECT_GE(text.size / picture.width * style.width / millimetres * points,
              std::min(6.0, style.font_size * 15 / 16) - rounding)
        << name << ": " << text.words;
  const std::string bytes = testing::bytes_of(svg);
  const std::size_t at = bytes.find(" width=\"");
  EXPECT_NEAR(std::stod(bytes.substr(at + 8)), style.width, 0.2) << name;
  const Table table = read_table(fs::path(stem).concat(".csv"));
  EXPECT_FALSE(table.rows.empty()) << name;
  for (const auto& row : table.rows)
    EXPECT_TRUE(!row.at(2).empty() && row.at(2).find("10^{") == row.at(2).npos) << name << ": " << row.at(2);
}

/// Each figure of a scene, by its name: whether a sample had something for it to show.
void print_scenes(const testing::Sample& sample, const PrintStyle& style,
                  std::map<std::string, bool>& shown) {
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, sample);
  Comparison comparison = read_comparison(folder);
  for (Run& run : comparison.runs)
    if (!run.exact())
      run.model_difference = run.softness_difference = run.step_difference = run.magnitude_error =
          run.phase_error = 1e-3;
  ComparedScene& scene = comparison.scenes.front();
  scene.split = true;
  for (const Figure* figure : figures_of(scene, true)) {
    const Drawing drawing = std::get<SceneFigure>(figure->of).draw({{*figure, &style}, comparison, scene});
    if (!drawing.nothing.empty()) continue;
    shown[figure->name] = true;
    expect_printed(drawing, folder / "paper" / figure->name, style);
  }
  for (const Figure& figure : figures())
    if (const auto* of = std::get_if<ComparisonFigure>(&figure.of); of != nullptr)
      for (const auto& [part, drawing] : of->draw({{figure, &style}, comparison}))
        expect_printed(drawing, folder / "paper" / (figure.name + part), style);
}

class Printed : public ::testing::TestWithParam<double> {
 protected:
  PrintStyle style() const { return {.width = GetParam()}; }
};

TEST_P(Printed, EachFigureOfASceneIsLegibleHasItsWidthAndItsNumbers) {
  std::map<std::string, bool> shown;
  for (const Figure& figure : figures())
    if (std::holds_alternative<SceneFigure>(figure.of)) shown[figure.name] = false;
  for (const testing::Sample& sample : made_up_comparisons()) print_scenes(sample, style(), shown);
  for (const auto& [name, was] : shown) EXPECT_TRUE(was) << name << " was never drawn";
}

TEST_P(Printed, EachFigureOfAStudyIsLegibleHasItsWidthAndItsNumbers) {
  const std::map<std::string, Files> studies = made_up_studies();
  const PrintStyle style = this->style();
  for (const Figure& figure : figures()) {
    const auto* of = std::get_if<FolderFigure>(&figure.of);
    if (of == nullptr) continue;
    ASSERT_TRUE(studies.contains(of->needs)) << figure.name << " needs made-up results";
    const fs::path folder = testing::fresh_folder();
    write_files(folder, studies.at(of->needs));
    for (const auto& [part, drawing] : of->draw({{figure, &style}, folder, print_width(style)}))
      expect_printed(drawing, folder / "paper" / (figure.name + part), style);
  }
}

INSTANTIATE_TEST_SUITE_P(Widths, Printed, ::testing::Values(88.0, 180.0));

}  // namespace
}  // namespace rockstack::plots
