#include "tests/analytic/paper/impact_patterns_3_4.hpp"
#include "tests/analytic/paper/jump.hpp"

namespace rockstack::paper {
namespace {

constexpr Jump ground_3a_1b{{1, 1}, {-1, -1}, Coming::joined, Freedom::both, flat};
constexpr Jump ground_3a_3b{{1, 1}, {-1, -1}, Coming::joined, Freedom::joined, flat};
constexpr Jump blocks_4a_1b{{-1, 1}, {-1, -1}, Coming::top_only, Freedom::both, flat};
constexpr Jump blocks_4a_4b{{-1, 1}, {-1, -1}, Coming::top_only, Freedom::top_only, flat};
constexpr Velocities base_only{1, 0};
constexpr Velocities top_only{0, 1};
constexpr Velocities joined{1, 1};

/// Which momentum a coefficient belongs to.
struct Row {
  int number;
  double Cs::*entry;
  When when;
  About about;
  Velocities unit;
};

void add_ground_opening(std::map<int, Check>& all) {
  const Jump& j = ground_3a_1b;
  const auto errors = [](const Draw& d, const Velocities& minus) {
    const Solution x = eqs132_and_133(d.q, eqs136_to_140(d.q, Reading::corrected));
    return velocity_errors(j, d, minus, apply(x, minus));
  };
  all[126] = [](const Draw& d, Reading) { return conservation_error(j, d, About::system); };
  all[127] = [](const Draw& d, Reading) {
    return momentum_error(j, d, eq127(d.q), When::before, About::system);
  };
  all[128] = [](const Draw& d, Reading r) {
    return momentum_error(j, d, eq128(d.q, r), When::after, About::system);
  };
  all[129] = [](const Draw& d, Reading) { return conservation_error(j, d, About::top); };
  all[130] = [](const Draw& d, Reading r) {
    return momentum_error(j, d, eq130(d.q, r), When::before, About::top);
  };
  all[131] = [](const Draw& d, Reading) { return momentum_error(j, d, eq131(d.q), When::after, About::top); };
  all[132] = [=](const Draw& d, Reading) { return errors(d, coming(j, d)).base; };
  all[133] = [=](const Draw& d, Reading) { return errors(d, coming(j, d)).top; };
  all[134] = [=](const Draw& d, Reading) { return errors(d, joined).base; };
  all[135] = [=](const Draw& d, Reading) { return errors(d, joined).top; };
  for (const Row& row : {Row{136, &Cs::C1, When::before, About::system, joined},
                         Row{137, &Cs::C2, When::after, About::system, top_only},
                         Row{138, &Cs::C3, When::before, About::top, joined},
                         Row{139, &Cs::C4, When::after, About::system, base_only},
                         Row{140, &Cs::C5, When::after, About::top, base_only}}) {
    all[row.number] = [row](const Draw& d, Reading r) {
      return coefficient_error(ground_3a_1b, d, eqs136_to_140(d.q, r).*row.entry, row.when, row.about,
                               row.unit);
    };
  }
}

void add_ground_joined(std::map<int, Check>& all) {
  const Jump& j = ground_3a_3b;
  all[141] = [](const Draw& d, Reading) { return conservation_error(j, d, About::system); };
  all[142] = [](const Draw& d, Reading) {
    return momentum_error(j, d, eq142(d.q), When::before, About::system);
  };
  all[143] = [](const Draw& d, Reading) {
    return momentum_error(j, d, eq143(d.q), When::after, About::system);
  };
  all[144] = [](const Draw& d, Reading) {
    const Velocities minus = coming(j, d);
    const double rate = eq144(d.q, minus.base);
    return velocity_errors(j, d, minus, {rate, rate}).base;
  };
}

void add_blocks_opening(std::map<int, Check>& all) {
  const Jump& j = blocks_4a_1b;
  const auto errors = [](const Draw& d, const Velocities& minus) {
    const Solution x = eqs151_and_152(d.q, eqs155_to_159(d.q, Reading::corrected));
    return velocity_errors(j, d, minus, apply(x, minus));
  };
  all[145] = [](const Draw& d, Reading) { return conservation_error(j, d, About::system); };
  all[146] = [](const Draw& d, Reading) {
    return momentum_error(j, d, eq146(d.q), When::before, About::system);
  };
  all[147] = [](const Draw& d, Reading) {
    return momentum_error(j, d, eq147(d.q), When::after, About::system);
  };
  all[148] = [](const Draw& d, Reading) { return conservation_error(j, d, About::top); };
  all[149] = [](const Draw& d, Reading) {
    return momentum_error(j, d, eq149(d.q), When::before, About::top);
  };
  all[150] = [](const Draw& d, Reading r) {
    return momentum_error(j, d, eq150(d.q, r), When::after, About::top);
  };
  all[151] = [=](const Draw& d, Reading) { return errors(d, coming(j, d)).base; };
  all[152] = [=](const Draw& d, Reading) { return errors(d, coming(j, d)).top; };
  all[153] = [=](const Draw& d, Reading) { return errors(d, top_only).base; };
  all[154] = [=](const Draw& d, Reading) { return errors(d, top_only).top; };
  for (const Row& row : {Row{155, &Cs::C1, When::before, About::system, top_only},
                         Row{156, &Cs::C2, When::after, About::system, top_only},
                         Row{157, &Cs::C3, When::before, About::top, top_only},
                         Row{158, &Cs::C4, When::after, About::system, base_only},
                         Row{159, &Cs::C5, When::after, About::top, base_only}}) {
    all[row.number] = [row](const Draw& d, Reading r) {
      return coefficient_error(blocks_4a_1b, d, eqs155_to_159(d.q, r).*row.entry, row.when, row.about,
                               row.unit);
    };
  }
}

void add_blocks_resting(std::map<int, Check>& all) {
  const Jump& j = blocks_4a_4b;
  all[160] = [](const Draw& d, Reading) { return conservation_error(j, d, About::top); };
  all[161] = [](const Draw& d, Reading) {
    return momentum_error(j, d, eq161(d.q), When::before, About::top);
  };
  all[162] = [](const Draw& d, Reading) { return momentum_error(j, d, eq162(d.q), When::after, About::top); };
  all[163] = [](const Draw& d, Reading) {
    const Velocities minus = coming(j, d);
    return velocity_errors(j, d, minus, {0, eq163(d.q, minus.top)}).top;
  };
}

}  // namespace

void add_impact_pattern_3(std::map<int, Check>& all) {
  add_ground_opening(all);
  add_ground_joined(all);
}

void add_impact_pattern_4(std::map<int, Check>& all) {
  add_blocks_opening(all);
  add_blocks_resting(all);
}

}  // namespace rockstack::paper
