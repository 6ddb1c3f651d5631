#include "tests/analytic/unilateral/springs/stiff_sweep.hpp"

#include <cmath>
#include <cstdio>
#include <ostream>

#include "analytic/solve.hpp"
#include "tests/analytic/unilateral/springs/stiff_cases.hpp"

namespace rockstack::testing {

std::vector<StiffRow> stiff_sweep(int least, int most) {
  std::vector<StiffRow> rows;
  const auto each = [&](const auto& add) {
    for (int half_decade = 2 * least; half_decade <= 2 * most; ++half_decade)
      for (const double ratio : damping_ratios) add(std::pow(10, half_decade / 2.0), ratio);
  };
  constexpr double housner = 0.7;
  each([&](double stiffness, double ratio) {
    rows.push_back({"one block: velocity ratio", stiffness, ratio, rocking_ratio(stiffness, ratio), housner,
                    housner, housner});
  });
  for (const StiffCase& one : stiff_cases())
    each([&](double stiffness, double ratio) {
      const std::string quantity = one.name + ": angle of base (rad)";
      try {
        const StiffAnswer answer = answer_of(one, stiffness, ratio);
        rows.push_back(
            {quantity, stiffness, ratio, answer.springs, answer.paper, answer.consistent, answer.unilateral});
      } catch (const std::exception& error) {
        std::fprintf(stderr, "%s, %g N/m, damping ratio %g: %s\n", one.name.c_str(), stiffness, ratio,
                     error.what());
      }
    });
  return rows;
}

void write_rows(const std::vector<StiffRow>& rows, std::ostream& out) {
  out.precision(8);
  out << "quantity,stiffness,damping_ratio,compliant,paper,consistent,unilateral\n";
  for (const StiffRow& row : rows)
    out << row.quantity << ',' << row.stiffness << ',' << row.ratio << ',' << row.springs << ',' << row.paper
        << ',' << row.consistent << ',' << row.unilateral << '\n';
}

}  // namespace rockstack::testing
