#include "tests/analytic/paper/initiation.hpp"

namespace rockstack::paper {

double eq1(const Geometry& q, const Motion& s) {
  return -q.h * s.xg - q.b1 * s.yg - q.b1 * s.g;
}

double eq2(const Geometry& q) {
  return (q.m1 * q.h1 + q.m2 * (2 * q.h1 + q.h2)) / (q.m1 + q.m2);
}

double eq3(const Geometry& q, const Motion& s) {
  return q.h * s.xg - q.b1 * s.yg - q.b1 * s.g;
}

double eq4(const Geometry& q, const Motion& s) {
  return -q.h2 * s.xg - q.b2 * s.yg - q.b2 * s.g;
}

double eq5(const Geometry& q, const Motion& s) {
  return q.h2 * s.xg - q.b2 * s.yg - q.b2 * s.g;
}

}  // namespace rockstack::paper
