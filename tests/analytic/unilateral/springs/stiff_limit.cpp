// What stiff springs come to: stiff_limit FOLDER [LEAST [MOST]] goes through stiffnesses from 10^LEAST to
// 10^MOST N/m (7 … 12 unless given) and damping ratios from 0.01 to 10, and writes stiff-limit.csv and the
// figure stiff-limit.png into FOLDER: what a rocking impact leaves of one block's angular velocity, and the
// angle of a base after its upper block has fallen back; no number where springs are too soft for a stack to
// stand.

#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "tests/analytic/unilateral/springs/stiff_sweep.hpp"

int main(int arguments, char** values) {
  using namespace rockstack::testing;
  if (arguments < 2) {
    std::fputs("stiff_limit FOLDER [LEAST [MOST]]\n", stderr);
    return 2;
  }
  const std::filesystem::path folder = values[1];
  const int least = arguments > 2 ? std::atoi(values[2]) : 7;
  const int most = arguments > 3 ? std::atoi(values[3]) : 12;
  std::filesystem::create_directories(folder);
  const std::vector<StiffRow> rows = stiff_sweep(least, most);
  std::ofstream table(folder / "stiff-limit.csv");
  write_rows(rows, table);
#ifdef ROCKSTACK_WITH_PLOTS
  draw(rows, folder / "stiff-limit");
#endif
}
