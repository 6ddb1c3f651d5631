#include "tests/analytic/proof/series.hpp"

namespace rockstack::proof {
namespace {

Series recorded(Tape::Rule rule, const Series& a, const Series& b) {
  Tape& tape = a.is_constant() ? *b.tape() : *a.tape();
  const std::size_t first = a.on(tape);
  const std::size_t second = b.on(tape);
  return {tape, tape.add(rule, first, second)};
}

}  // namespace

Tape::~Tape() {
  for (const Recorded& series : series_) _arb_vec_clear(series.coefficients, terms_);
}

std::size_t Tape::add(Rule rule, std::size_t a, std::size_t b) {
  series_.push_back({rule, a, b, _arb_vec_init(terms_)});
  if (rule != Rule::sine && rule != Rule::cosine) evaluate(series_.back(), 0);
  return series_.size() - 1;
}

void Tape::pair(std::size_t sine, std::size_t cosine) {
  series_[sine].a = cosine;
  series_[cosine].a = sine;
}

void Tape::extend(slong order) {
  if (order > 0)
    for (const Recorded& series : series_) evaluate(series, order);
  if (order + 1 < terms_)
    for (const auto& [state, rate] : rates_)
      arb_div_si(coefficients(state) + order + 1, coefficients(rate) + order, order + 1, working_bits);
}

void Tape::evaluate(const Recorded& series, slong order) {
  const arb_ptr own = series.coefficients;
  const arb_ptr result = own + order;
  const arb_srcptr a = series.a == none ? nullptr : series_[series.a].coefficients;
  const arb_srcptr b = series.b == none ? nullptr : series_[series.b].coefficients;
  switch (series.rule) {
    case Rule::given:
      break;
    case Rule::sum:
      arb_add(result, a + order, b + order, working_bits);
      break;
    case Rule::difference:
      arb_sub(result, a + order, b + order, working_bits);
      break;
    case Rule::scaled:
      arb_mul(result, a, b + order, working_bits);
      break;
    case Rule::product:
      arb_dot(result, nullptr, 0, a, 1, b + order, -1, order + 1, working_bits);
      break;
    case Rule::quotient:  // q b = a
      arb_dot(result, a + order, 1, own, 1, b + order, -1, order, working_bits);
      arb_div(result, result, b, working_bits);
      break;
    case Rule::sine:    // s' = b c
    case Rule::cosine:  // c' = −b s
      arb_dot(result, nullptr, 0, b, 1, a + order - 1, -1, order, working_bits);
      arb_div_si(result, result, series.rule == Rule::sine ? order : -order, working_bits);
      break;
  }
}

std::size_t Series::on(Tape& tape) const {
  if (!is_constant()) return index_;
  const std::size_t index = tape.add(Tape::Rule::given);
  arb_set(tape.coefficients(index), constant_.data());
  return index;
}

Ball Series::start() const {
  if (is_constant()) return constant_;
  Ball result;
  arb_set(result.data(), tape_->coefficients(index_));
  return result;
}

Series operator+(const Series& a, const Series& b) {
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  if (a.is_constant() && b.is_constant()) return a.constant() + b.constant();
  return recorded(Tape::Rule::sum, a, b);
}

Series operator-(const Series& a, const Series& b) {
  if (b.is_zero()) return a;
  if (a.is_constant() && b.is_constant()) return a.constant() - b.constant();
  return recorded(Tape::Rule::difference, a, b);
}

Series operator*(const Series& a, const Series& b) {
  if (a.is_zero() || b.is_zero()) return 0;
  if (a.is_constant() && b.is_constant()) return a.constant() * b.constant();
  if (a.is_constant()) return recorded(Tape::Rule::scaled, a, b);
  if (b.is_constant()) return recorded(Tape::Rule::scaled, b, a);
  return recorded(Tape::Rule::product, a, b);
}

Series operator/(const Series& a, const Series& b) {
  if (a.is_zero()) return a;
  if (b.is_constant()) return Series(Ball(1) / b.constant()) * a;
  return recorded(Tape::Rule::quotient, a, b);
}

SineCosine<Series> sine_cosine(const Series& angle, const Series& rate) {
  const SineCosine<Ball> start = sine_cosine(angle.start(), Ball());
  if (angle.is_constant()) return {start.sine, start.cosine};
  Tape& tape = *angle.tape();
  const std::size_t turning = rate.on(tape);
  const std::size_t sine = tape.add(Tape::Rule::sine, Tape::none, turning);
  const std::size_t cosine = tape.add(Tape::Rule::cosine, Tape::none, turning);
  tape.pair(sine, cosine);
  arb_set(tape.coefficients(sine), start.sine.data());
  arb_set(tape.coefficients(cosine), start.cosine.data());
  return {{tape, sine}, {tape, cosine}};
}

}  // namespace rockstack::proof
