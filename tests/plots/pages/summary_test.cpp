#include "plots/pages/summary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rockstack::plots {
namespace {

Run slipping(const std::string& solver, double slip_error) {
  Run run;
  run.scene = "a";
  run.engine = "bullet";
  run.solver = solver;
  run.settings = "tuned";
  run.status = "done";
  run.dt = 1e-3;
  run.slip_error = slip_error;
  return run;
}

bool tells(const std::vector<Run>& rows, const std::string& sentence) {
  Comparison comparison;
  comparison.scenes.resize(1);
  comparison.scenes[0].name = "a";
  comparison.runs = rows;
  const std::vector<std::string> sentences = summary(comparison, comparison.scenes[0]);
  return std::any_of(sentences.begin(), sentences.end(),
                     [&](const std::string& one) { return one.find(sentence) != std::string::npos; });
}

TEST(Summary, SlipsAreToldWhereThereAreAny) {
  EXPECT_TRUE(tells({slipping("nncg", 5e-4), slipping("mlcp-lemke", 0.13)},
                    "Slips are within 0.0005 m with bullet nncg (tuned, 1 ms), and within 0.13 m with bullet "
                    "mlcp-lemke (tuned, 1 ms)."));
  EXPECT_FALSE(tells({slipping("nncg", std::nan(""))}, "Slips"));
}

}  // namespace
}  // namespace rockstack::plots
