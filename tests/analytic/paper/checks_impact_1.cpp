#include <cmath>

#include "tests/analytic/paper/impact_pattern_1.hpp"
#include "tests/analytic/paper/jump.hpp"

namespace rockstack::paper {
namespace {

constexpr Jump base_1a_2b{{1, 1}, {-1, 1}, Coming::both, Freedom::both, base_hits_from_1};
constexpr Jump blocks_1a_2a{{1, 1}, {1, -1}, Coming::both, Freedom::both, blocks_meet};
constexpr Jump blocks_1a_3a{{1, 1}, {1, 1}, Coming::both, Freedom::joined, blocks_meet};
constexpr Velocities base_only{1, 0};
constexpr Velocities top_only{0, 1};

/// h about any point as Eq. (44) has it, the distance from the centre's path.
double by_eq44(const Body& body, Vec about) {
  const double speed = std::hypot(body.velocity.x, body.velocity.y);
  const Vec along = (1 / speed) * body.velocity;
  return eq44(body.inertia, body.rate, body.mass * speed, moment(body.centre - about, along));
}

double relative_momentum(const Draw& d, double difference) {
  return std::abs(difference) / inertia_size(d.q);
}

Assembly hitting(const Draw& d) {
  return assemble(d.q, base_1a_2b.before, {base_1a_2b.angles(d), d.minus});
}

void add_base(std::map<int, Check>& all) {
  const Jump& j = base_1a_2b;
  const auto c = [](const Draw& d, Reading r) { return eqs56_to_60(d.q, j.angles(d), r); };
  const auto errors = [](const Draw& d, const Velocities& minus) {
    const Solution x = eqs52_and_53(d.q, eqs56_to_60(d.q, j.angles(d), Reading::corrected));
    return velocity_errors(j, d, minus, apply(x, minus));
  };
  all[46] = [](const Draw& d, Reading) { return conservation_error(j, d, About::system); };
  all[47] = [](const Draw& d, Reading) {
    return momentum_error(j, d, eq47(d.q, j.angles(d)), When::before, About::system);
  };
  all[48] = [](const Draw& d, Reading) {
    return momentum_error(j, d, eq48(d.q, j.angles(d)), When::after, About::system);
  };
  all[49] = [](const Draw& d, Reading) { return conservation_error(j, d, About::top); };
  all[50] = [](const Draw& d, Reading) {
    return momentum_error(j, d, eq50(d.q, j.angles(d)), When::before, About::top);
  };
  all[51] = [](const Draw& d, Reading) {
    return momentum_error(j, d, eq51(d.q, j.angles(d)), When::after, About::top);
  };
  all[52] = [=](const Draw& d, Reading) { return errors(d, d.minus).base; };
  all[53] = [=](const Draw& d, Reading) { return errors(d, d.minus).top; };
  all[54] = [=](const Draw& d, Reading) { return errors(d, base_only).base; };
  all[55] = [=](const Draw& d, Reading) { return errors(d, base_only).top; };
  all[56] = [=](const Draw& d, Reading r) {
    return coefficient_error(j, d, c(d, r).C1, When::before, About::system, base_only);
  };
  all[57] = [=](const Draw& d, Reading r) {
    return coefficient_error(j, d, c(d, r).C2, When::after, About::system, top_only);
  };
  all[58] = [=](const Draw& d, Reading r) {
    return coefficient_error(j, d, c(d, r).C3, When::before, About::top, base_only);
  };
  all[59] = [=](const Draw& d, Reading r) {
    return coefficient_error(j, d, c(d, r).C4, When::after, About::system, base_only);
  };
  all[60] = [=](const Draw& d, Reading r) {
    return coefficient_error(j, d, c(d, r).C5, When::after, About::top, base_only);
  };
}

void add_blocks(std::map<int, Check>& all) {
  const Jump& j = blocks_1a_2a;
  const auto errors = [](const Draw& d, const Velocities& minus) {
    const Solution x = eqs67_and_68(d.q, eqs73_to_79(d.q, j.angles(d)));
    return velocity_errors(j, d, minus, apply(x, minus));
  };
  all[61] = [](const Draw& d, Reading) { return conservation_error(j, d, About::system); };
  all[62] = [](const Draw& d, Reading) {
    return momentum_error(j, d, eq62(d.q, j.angles(d)), When::before, About::system);
  };
  all[63] = [](const Draw& d, Reading r) {
    return momentum_error(j, d, eq63(d.q, j.angles(d), r), When::after, About::system);
  };
  all[64] = [](const Draw& d, Reading) { return conservation_error(j, d, About::top); };
  all[65] = [](const Draw& d, Reading) {
    return momentum_error(j, d, eq65(d.q, j.angles(d)), When::before, About::top);
  };
  all[66] = [](const Draw& d, Reading r) {
    return momentum_error(j, d, eq66(d.q, j.angles(d), r), When::after, About::top);
  };
  all[67] = [=](const Draw& d, Reading) { return errors(d, d.minus).base; };
  all[68] = [=](const Draw& d, Reading) { return errors(d, d.minus).top; };
  all[69] = [=](const Draw& d, Reading) { return errors(d, base_only).base; };
  all[70] = [=](const Draw& d, Reading) { return errors(d, top_only).base; };
  all[71] = [=](const Draw& d, Reading) { return errors(d, base_only).top; };
  all[72] = [=](const Draw& d, Reading) { return errors(d, top_only).top; };
}

/// Eqs. (73)–(79): which momentum each coefficient belongs to.
void add_blocks_coefficients(std::map<int, Check>& all) {
  struct Row {
    int number;
    double Es::*entry;
    When when;
    About about;
    Velocities unit;
  };
  for (const Row& row : {Row{73, &Es::E1, When::before, About::system, base_only},
                         Row{74, &Es::E2, When::after, About::system, top_only},
                         Row{75, &Es::E3, When::before, About::top, base_only},
                         Row{76, &Es::E4, When::after, About::system, base_only},
                         Row{77, &Es::E5, When::after, About::top, base_only},
                         Row{78, &Es::E6, When::before, About::system, top_only},
                         Row{79, &Es::E7, When::before, About::top, top_only}}) {
    all[row.number] = [row](const Draw& d, Reading) {
      const Es e = eqs73_to_79(d.q, blocks_1a_2a.angles(d));
      return coefficient_error(blocks_1a_2a, d, e.*row.entry, row.when, row.about, row.unit);
    };
  }
}

void add_joined(std::map<int, Check>& all) {
  const Jump& j = blocks_1a_3a;
  all[80] = [](const Draw& d, Reading) { return conservation_error(j, d, About::system); };
  all[81] = [](const Draw& d, Reading) {
    return momentum_error(j, d, eq81(d.q, j.angles(d)), When::before, About::system);
  };
  all[82] = [](const Draw& d, Reading) {
    return momentum_error(j, d, eq82(d.q), When::after, About::system);
  };
  all[83] = [](const Draw& d, Reading) {
    return coefficient_error(j, d, eq83(d.q), When::after, About::system, {1, 1});
  };
  all[84] = [](const Draw& d, Reading) {
    const double rate = eq84(d.q, eq85(d.q), eq86(d.q, j.angles(d)), d.minus);
    return velocity_errors(j, d, d.minus, {rate, rate}).top;
  };
  all[85] = [](const Draw& d, Reading) {
    return coefficient_error(j, d, eq85(d.q), When::before, About::system, base_only);
  };
  all[86] = [](const Draw& d, Reading) {
    return coefficient_error(j, d, eq86(d.q, j.angles(d)), When::before, About::system, top_only);
  };
}

}  // namespace

void add_momentum(std::map<int, Check>& all) {
  all[41] = [](const Draw& d, Reading) {
    const Assembly blocks = hitting(d);
    const Vec corner = ground_corner(d.q, -1);
    return relative_momentum(
        d, by_eq44(blocks.base, corner) + by_eq44(blocks.top, corner) - angular_momentum(blocks, corner));
  };
  all[42] = [](const Draw& d, Reading) {
    const Body top = hitting(d).top;
    const Vec corner = ground_corner(d.q, -1);
    const double about_centre = angular_momentum(top, top.centre);
    const double of_centre = moment(top.centre - corner, top.mass * top.velocity);
    return relative_momentum(d, about_centre + of_centre - angular_momentum(top, corner));
  };
  all[43] = [](const Draw& d, Reading) {
    const Body top = hitting(d).top;
    return relative_momentum(d, top.inertia * top.rate - angular_momentum(top, top.centre));
  };
  all[44] = [](const Draw& d, Reading) {
    const Body top = hitting(d).top;
    const Vec corner = ground_corner(d.q, -1);
    return relative_momentum(d, by_eq44(top, corner) - angular_momentum(top, corner));
  };
  all[45] = [](const Draw& d, Reading) {
    const Body base = hitting(d).base;
    const Vec corner = ground_corner(d.q, -1);
    return relative_momentum(d, by_eq44(base, corner) - angular_momentum(base, corner));
  };
}

void add_impact_pattern_1(std::map<int, Check>& all) {
  add_base(all);
  add_blocks(all);
  add_blocks_coefficients(all);
  add_joined(all);
}

}  // namespace rockstack::paper
