// What stiff springs come to: stiff_limit [LEAST [MOST]] goes through stiffnesses from 10^LEAST to 10^MOST
// N/m (4 … 12 unless given) and damping ratios from 0.01 to 10, and prints two tables: what a rocking impact
// leaves of one block's angular velocity, and the angle of a base after its upper block has fallen back; no
// number where springs are too soft for a stack to stand.

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "tests/analytic/unilateral/springs/stiff_cases.hpp"

int main(int arguments, char** values) {
  using namespace rockstack::testing;
  const int least = arguments > 1 ? std::atoi(values[1]) : 4;
  const int most = arguments > 2 ? std::atoi(values[2]) : 12;
  const auto each = [&](const auto& print) {
    for (int decade = least; decade <= most; decade += 2)
      for (const double ratio : {0.01, 0.1, 1.0, 10.0}) print(decade, ratio);
  };
  std::printf("k (N/m), damping ratio, velocity ratio\n");
  each([](int decade, double ratio) {
    std::printf("1e%-3d %-5g %.6f\n", decade, ratio, rocking_ratio(std::pow(10, decade), ratio));
    std::fflush(stdout);
  });
  for (const StiffCase& one : stiff_cases()) {
    std::printf("%s: k (N/m), damping ratio, base (rad); by laws paper, consistent, unilateral\n",
                one.name.c_str());
    each([&](int decade, double ratio) {
      const StiffAnswer answer = answer_of(one, std::pow(10, decade), ratio);
      std::printf("1e%-3d %-5g %10.7f; %10.7f %10.7f %10.7f\n", decade, ratio, answer.springs, answer.paper,
                  answer.consistent, answer.unilateral);
      std::fflush(stdout);
    });
  }
}
