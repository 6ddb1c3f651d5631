#include "tests/analytic/proof/ball.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace rockstack::proof {
namespace {

/// Text that FLINT allocates.
std::string taken(char* text) {
  std::string result(text);
  flint_free(text);
  return result;
}

Rational power_of_ten(long exponent) {
  Rational result(10);
  fmpq_pow_si(result.data(), result.data(), exponent);
  return result;
}

/// A bound of a ball as `bound` finds it.
template <class Bound>
Ball bound_by(Bound bound) {
  Ball result;
  arf_t number;
  arf_init(number);
  bound(number);
  arb_set_arf(result.data(), number);
  arf_clear(number);
  return result;
}

/// The whole number of 10^-places that `round` makes of a bound, as a decimal text.
std::string decimal_text(const Ball& bound, slong places, void (*round)(arb_t, const arb_t, slong)) {
  const slong bits = working_bits + 4 * places;
  Ball scaled;
  arb_set_fmpq(scaled.data(), power_of_ten(places).data(), bits);
  arb_mul(scaled.data(), scaled.data(), bound.data(), bits);
  round(scaled.data(), scaled.data(), bits);
  fmpz_t whole;
  fmpz_init(whole);
  const bool unique = arb_get_unique_fmpz(whole, scaled.data()) != 0;
  std::string digits = taken(fmpz_get_str(nullptr, 10, whole));
  fmpz_clear(whole);
  if (!unique) throw std::runtime_error("decimal text of a number that is not exact");
  const bool minus = digits[0] == '-';
  if (minus) digits.erase(0, 1);
  const auto wanted = static_cast<std::size_t>(places) + 1;
  if (digits.size() < wanted) digits.insert(0, wanted - digits.size(), '0');
  digits.insert(digits.size() - static_cast<std::size_t>(places), ".");
  return (minus ? "-" : "") + digits;
}

}  // namespace

std::string Rational::text() const {
  return taken(fmpq_get_str(nullptr, 10, value_));
}

Rational decimal(std::string_view text) {
  std::string digits(text);
  long exponent = 0;
  if (const auto e = digits.find_first_of("eE"); e != std::string::npos) {
    exponent = std::stol(digits.substr(e + 1));
    digits.erase(e);
  }
  if (const auto point = digits.find('.'); point != std::string::npos) {
    exponent -= static_cast<long>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  if (digits[0] == '+') digits.erase(0, 1);
  Rational result;
  if (fmpz_set_str(fmpq_numref(result.data()), digits.c_str(), 10) != 0)
    throw std::invalid_argument("no decimal number: " + std::string(text));
  return result * power_of_ten(exponent);
}

Rational decimal(double number) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.begin(), text.end(), number).ptr;
  return decimal(std::string_view(text.data(), static_cast<std::size_t>(end - text.data())));
}

Ball upper(const Ball& a) {
  return bound_by([&](arf_t bound) { arb_get_ubound_arf(bound, a.data(), working_bits); });
}
Ball lower(const Ball& a) {
  return bound_by([&](arf_t bound) { arb_get_lbound_arf(bound, a.data(), working_bits); });
}
Ball middle(const Ball& a) {
  Ball result;
  arb_get_mid_arb(result.data(), a.data());
  return result;
}
Ball magnitude(const Ball& a) {
  return bound_by([&](arf_t bound) { arb_get_abs_ubound_arf(bound, a.data(), 64); });
}
Ball magnitude(const ComplexBall& a) {
  return bound_by([&](arf_t bound) { acb_get_abs_ubound_arf(bound, a.data(), 64); });
}
Ball within(const Ball& bound) {
  Ball result;
  arb_add_error(result.data(), bound.data());
  return result;
}
Ball hull(const Ball& a, const Ball& b) {
  Ball result;
  arb_union(result.data(), a.data(), b.data(), working_bits);
  return result;
}
Ball root(const Ball& a) {
  Ball result;
  arb_sqrt(result.data(), a.data(), working_bits);
  return result;
}
Ball arctangent(const Ball& y, const Ball& x) {
  Ball result;
  arb_atan2(result.data(), y.data(), x.data(), working_bits);
  return result;
}
Ball half_turn() {
  Ball result;
  arb_const_pi(result.data(), working_bits);
  return result;
}
Ball power(const Ball& base, ulong exponent) {
  Ball result;
  arb_pow_ui(result.data(), base.data(), exponent, working_bits);
  return result;
}
ComplexBall disc(const Ball& centre, const Ball& radius) {
  ComplexBall result(centre);
  arb_add_error(acb_realref(result.data()), radius.data());
  arb_add_error(acb_imagref(result.data()), radius.data());
  return result;
}

double approximate(const Ball& a) {
  return arf_get_d(arb_midref(a.data()), ARF_RND_NEAR);
}
double width_exponent(const Ball& a) {
  if (mag_is_zero(arb_radref(a.data()))) return -std::numeric_limits<double>::infinity();
  return mag_get_d_log2_approx(arb_radref(a.data()));
}

SineCosine<Ball> sine_cosine(const Ball& angle, const Ball&) {
  SineCosine<Ball> result;
  arb_sin_cos(result.sine.data(), result.cosine.data(), angle.data(), working_bits);
  return result;
}
SineCosine<ComplexBall> sine_cosine(const ComplexBall& angle, const ComplexBall&) {
  SineCosine<ComplexBall> result;
  acb_sin_cos(result.sine.data(), result.cosine.data(), angle.data(), working_bits);
  return result;
}

DecimalBounds decimal_bounds(const Ball& a, slong places) {
  return {decimal_text(lower(a), places, arb_floor), decimal_text(upper(a), places, arb_ceil)};
}

std::string exact_text(const Ball& a) {
  fmpz_t mantissa, exponent;
  fmpz_init(mantissa);
  fmpz_init(exponent);
  arf_get_fmpz_2exp(mantissa, exponent, arb_midref(a.data()));
  std::string text =
      taken(fmpz_get_str(nullptr, 10, mantissa)) + "*2^" + taken(fmpz_get_str(nullptr, 10, exponent));
  fmpz_clear(mantissa);
  fmpz_clear(exponent);
  return text;
}

}  // namespace rockstack::proof
