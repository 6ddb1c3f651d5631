// What stiff springs come to: stiff_limit FOLDER [LEAST MOST] goes through stiffnesses from 10^LEAST to
// 10^MOST N/m (7 … 12 unless given) and damping ratios from 0.01 to 10, and writes stiff-limit.csv and the
// figure stiff-limit.png into FOLDER: what a rocking impact leaves of one block's angular velocity, and the
// angle of a base after its upper block has fallen back; no number where springs are too soft for a stack to
// stand.

#include <charconv>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "tests/analytic/unilateral/springs/stiff_sweep.hpp"

namespace {

constexpr int softest = 6, stiffest = 14;

/// 0 for what is none.
int exponent(const char* text) {
  const char* const end = text + std::strlen(text);
  int value = 0;
  const auto [rest, error] = std::from_chars(text, end, value);
  return error == std::errc() && rest == end && value >= softest && value <= stiffest ? value : 0;
}

}  // namespace

int main(int arguments, char** values) {
  using namespace rockstack::testing;
  const bool ranged = arguments == 4;
  const int least = ranged ? exponent(values[2]) : 7;
  const int most = ranged ? exponent(values[3]) : 12;
  if ((!ranged && arguments != 2) || least == 0 || least >= most) {
    std::fprintf(stderr, "stiff_limit FOLDER [LEAST MOST], %d <= LEAST < MOST <= %d\n", softest, stiffest);
    return 2;
  }
  const std::filesystem::path folder = values[1];
  std::filesystem::create_directories(folder);
  const std::vector<StiffRow> rows = stiff_sweep(least, most);
  std::ofstream table(folder / "stiff-limit.csv");
  write_rows(rows, table);
#ifdef ROCKSTACK_WITH_PLOTS
  draw(rows, folder / "stiff-limit");
#endif
}
