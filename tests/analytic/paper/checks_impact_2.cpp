#include "tests/analytic/paper/impact_pattern_2.hpp"
#include "tests/analytic/paper/jump.hpp"

namespace rockstack::paper {
namespace {

constexpr Jump base_2a_1b{{1, -1}, {-1, -1}, Coming::both, Freedom::both, base_hits_from_2};
constexpr Jump blocks_2a_1a{{1, -1}, {1, 1}, Coming::both, Freedom::both, blocks_meet};
constexpr Jump blocks_2a_3a{{1, -1}, {1, 1}, Coming::both, Freedom::joined, blocks_meet};
constexpr Velocities base_only{1, 0};
constexpr Velocities top_only{0, 1};

/// Which momentum a coefficient belongs to.
struct Row {
  int number;
  double Es::*entry;
  When when;
  About about;
  Velocities unit;
};

void add_base(std::map<int, Check>& all) {
  const Jump& j = base_2a_1b;
  const auto errors = [](const Draw& d, const Velocities& minus) {
    const Solution x = eqs93_and_94(d.q, eqs99_to_104(d.q, j.angles(d), Reading::corrected));
    return velocity_errors(j, d, minus, apply(x, minus));
  };
  all[87] = [](const Draw& d, Reading) { return conservation_error(j, d, About::system); };
  all[88] = [](const Draw& d, Reading) {
    return momentum_error(j, d, eq88(d.q, j.angles(d)), When::before, About::system);
  };
  all[89] = [](const Draw& d, Reading) {
    return momentum_error(j, d, eq89(d.q, j.angles(d)), When::after, About::system);
  };
  all[90] = [](const Draw& d, Reading) { return conservation_error(j, d, About::top); };
  all[91] = [](const Draw& d, Reading) {
    return momentum_error(j, d, eq91(d.q, j.angles(d)), When::before, About::top);
  };
  all[92] = [](const Draw& d, Reading r) {
    return momentum_error(j, d, eq92(d.q, j.angles(d), r), When::after, About::top);
  };
  all[93] = [=](const Draw& d, Reading) { return errors(d, d.minus).base; };
  all[94] = [=](const Draw& d, Reading) { return errors(d, d.minus).top; };
  all[95] = [=](const Draw& d, Reading) { return errors(d, base_only).base; };
  all[96] = [=](const Draw& d, Reading) { return errors(d, top_only).base; };
  all[97] = [=](const Draw& d, Reading) { return errors(d, base_only).top; };
  all[98] = [=](const Draw& d, Reading) { return errors(d, top_only).top; };
  for (const Row& row : {Row{99, &Es::E1, When::before, About::system, base_only},
                         Row{100, &Es::E2, When::after, About::system, top_only},
                         Row{101, &Es::E3, When::before, About::top, base_only},
                         Row{102, &Es::E4, When::after, About::system, base_only},
                         Row{103, &Es::E5, When::after, About::top, base_only},
                         Row{104, &Es::E6, When::before, About::system, top_only}}) {
    all[row.number] = [row](const Draw& d, Reading r) {
      const Es e = eqs99_to_104(d.q, base_2a_1b.angles(d), r);
      return coefficient_error(base_2a_1b, d, e.*row.entry, row.when, row.about, row.unit);
    };
  }
}

void add_blocks(std::map<int, Check>& all) {
  const Jump& j = blocks_2a_1a;
  // Eqs. (113)–(116) are held with the right E1 … E6, so that only their own misprint counts.
  const auto errors = [](const Draw& d, const Velocities& minus, Reading r) {
    const Angles u = j.angles(d);
    const Es e = eqs117_to_122(d.q, u, Reading::corrected);
    return velocity_errors(j, d, minus, apply(eqs111_and_112(d.q, e, top_after(d.q, u, r)), minus));
  };
  all[105] = [](const Draw& d, Reading) { return conservation_error(j, d, About::system); };
  all[106] = [](const Draw& d, Reading r) {
    return momentum_error(j, d, eq106(d.q, j.angles(d), r), When::before, About::system);
  };
  all[107] = [](const Draw& d, Reading r) {
    return momentum_error(j, d, eq107(d.q, j.angles(d), r), When::after, About::system);
  };
  all[108] = [](const Draw& d, Reading) { return conservation_error(j, d, About::top); };
  all[109] = [](const Draw& d, Reading r) {
    return momentum_error(j, d, eq109(d.q, j.angles(d), r), When::before, About::top);
  };
  all[110] = [](const Draw& d, Reading r) {
    return momentum_error(j, d, eq110(d.q, j.angles(d), r), When::after, About::top);
  };
  all[111] = [=](const Draw& d, Reading) { return errors(d, d.minus, Reading::corrected).base; };
  all[112] = [=](const Draw& d, Reading) { return errors(d, d.minus, Reading::corrected).top; };
  all[113] = [=](const Draw& d, Reading r) { return errors(d, base_only, r).base; };
  all[114] = [=](const Draw& d, Reading r) { return errors(d, top_only, r).base; };
  all[115] = [=](const Draw& d, Reading r) { return errors(d, base_only, r).top; };
  all[116] = [=](const Draw& d, Reading r) { return errors(d, top_only, r).top; };
  for (const Row& row : {Row{117, &Es::E1, When::before, About::system, base_only},
                         Row{118, &Es::E2, When::before, About::top, base_only},
                         Row{119, &Es::E3, When::after, About::system, base_only},
                         Row{120, &Es::E4, When::after, About::top, base_only},
                         Row{121, &Es::E5, When::before, About::system, top_only},
                         Row{122, &Es::E6, When::before, About::top, top_only}}) {
    all[row.number] = [row](const Draw& d, Reading r) {
      const Es e = eqs117_to_122(d.q, blocks_2a_1a.angles(d), r);
      return coefficient_error(blocks_2a_1a, d, e.*row.entry, row.when, row.about, row.unit);
    };
  }
}

void add_joined(std::map<int, Check>& all) {
  const Jump& j = blocks_2a_3a;
  all[123] = [](const Draw& d, Reading) { return conservation_error(j, d, About::system); };
  all[124] = [](const Draw& d, Reading r) {
    return momentum_error(j, d, eq124(d.q, j.angles(d), r), When::before, About::system);
  };
  all[125] = [](const Draw& d, Reading) {
    return momentum_error(j, d, eq125(d.q), When::after, About::system);
  };
}

}  // namespace

void add_impact_pattern_2(std::map<int, Check>& all) {
  add_base(all);
  add_blocks(all);
  add_joined(all);
}

}  // namespace rockstack::paper
