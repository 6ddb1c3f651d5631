// What figures.txt says of figures.

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

TEST(Questions, EachFigureAsksOneOfItsOwnAndSaysHowToReadIt) {
  std::set<std::string> names;
  for (const Figure& figure : figures()) {
    EXPECT_TRUE(names.insert(figure.name).second) << figure.name;
    EXPECT_TRUE(figure.question.ends_with('?')) << figure.name;
    EXPECT_FALSE(figure.title.empty()) << figure.name;
    EXPECT_TRUE(figure.explanation.ends_with('.')) << figure.name;
  }
  EXPECT_EQ(figures().front().name, "agreement");
}

TEST(Questions, AFileIsOfTheFigureInItsName) {
  for (const auto& [stem, name] : {std::pair{"spanos.error-time", "error-time"},
                                   {"energy", "energy"},
                                   {"solvers.energy", "solvers.energy"},
                                   {"stability.ode-step-tuned", "stability"},
                                   {"impact-laws.engines", "impact-laws.engines"},
                                   {"impact-laws.3-blocks", "impact-laws"}})
    EXPECT_EQ(figure_in(stem)->name, name) << stem;
  EXPECT_EQ(figure_in("spanos.motions"), nullptr);
}

}  // namespace
}  // namespace rockstack::plots
