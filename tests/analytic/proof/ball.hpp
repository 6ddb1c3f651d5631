#pragma once

#include <string>
#include <string_view>

// FLINT 3 holds what the library arb was.
#if __has_include(<flint/arb.h>)
#include <flint/acb.h>
#include <flint/arb.h>
#else
#include <acb.h>
#include <arb.h>
#endif
#include <flint/fmpq.h>

namespace rockstack::proof {

/// Bits to which operations on balls round outwards.
inline slong working_bits = 256;

/// Sets the working bits for as long as it lives.
class Precision {
 public:
  explicit Precision(slong bits) : before_(working_bits) { working_bits = bits; }
  ~Precision() { working_bits = before_; }
  Precision(const Precision&) = delete;
  Precision& operator=(const Precision&) = delete;

 private:
  slong before_;
};

/// A fraction of integers, exactly: what a scene file says.
class Rational {
 public:
  Rational() { fmpq_init(value_); }
  Rational(slong number) : Rational() { fmpq_set_si(value_, number, 1); }
  Rational(const Rational& other) : Rational() { fmpq_set(value_, other.value_); }
  Rational(Rational&& other) noexcept : Rational() { fmpq_swap(value_, other.value_); }
  Rational& operator=(Rational other) noexcept { return fmpq_swap(value_, other.value_), *this; }
  ~Rational() { fmpq_clear(value_); }

  fmpq* data() { return value_; }
  const fmpq* data() const { return value_; }
  int sign() const { return fmpq_sgn(value_); }
  std::string text() const;  ///< "numerator/denominator"

 private:
  fmpq_t value_;
};

/// The number of a decimal text. @throws std::invalid_argument where it is none.
Rational decimal(std::string_view text);
/// The number of the shortest decimal text that a double is read from.
Rational decimal(double number);

inline Rational operator+(const Rational& a, const Rational& b) {
  Rational sum;
  fmpq_add(sum.data(), a.data(), b.data());
  return sum;
}
inline Rational operator-(const Rational& a, const Rational& b) {
  Rational difference;
  fmpq_sub(difference.data(), a.data(), b.data());
  return difference;
}
inline Rational operator*(const Rational& a, const Rational& b) {
  Rational product;
  fmpq_mul(product.data(), a.data(), b.data());
  return product;
}
/// Precondition: b is not zero.
inline Rational operator/(const Rational& a, const Rational& b) {
  Rational quotient;
  fmpq_div(quotient.data(), a.data(), b.data());
  return quotient;
}
inline bool operator<(const Rational& a, const Rational& b) {
  return fmpq_cmp(a.data(), b.data()) < 0;
}
inline bool operator==(const Rational& a, const Rational& b) {
  return fmpq_equal(a.data(), b.data()) != 0;
}

/// A real interval, a middle and a radius. Operations enclose every result that members may have.
class Ball {
 public:
  Ball() { arb_init(value_); }
  Ball(int number) : Ball() { arb_set_si(value_, number); }
  explicit Ball(double number) : Ball() { arb_set_d(value_, number); }
  Ball(const Rational& number) : Ball() { arb_set_fmpq(value_, number.data(), working_bits); }
  Ball(const Ball& other) : Ball() { arb_set(value_, other.value_); }
  Ball(Ball&& other) noexcept : Ball() { arb_swap(value_, other.value_); }
  Ball& operator=(const Ball& other) { return arb_set(value_, other.value_), *this; }
  Ball& operator=(Ball&& other) noexcept { return arb_swap(value_, other.value_), *this; }
  ~Ball() { arb_clear(value_); }

  arb_ptr data() { return value_; }
  arb_srcptr data() const { return value_; }

 private:
  arb_t value_;
};

/// A rectangle of complex numbers, likewise.
class ComplexBall {
 public:
  ComplexBall() { acb_init(value_); }
  ComplexBall(int number) : ComplexBall() { acb_set_si(value_, number); }
  ComplexBall(const Ball& number) : ComplexBall() { acb_set_arb(value_, number.data()); }
  ComplexBall(const ComplexBall& other) : ComplexBall() { acb_set(value_, other.value_); }
  ComplexBall(ComplexBall&& other) noexcept : ComplexBall() { acb_swap(value_, other.value_); }
  ComplexBall& operator=(const ComplexBall& other) { return acb_set(value_, other.value_), *this; }
  ComplexBall& operator=(ComplexBall&& other) noexcept { return acb_swap(value_, other.value_), *this; }
  ~ComplexBall() { acb_clear(value_); }

  acb_ptr data() { return value_; }
  acb_srcptr data() const { return value_; }

 private:
  acb_t value_;
};

inline Ball operator+(const Ball& a, const Ball& b) {
  Ball sum;
  arb_add(sum.data(), a.data(), b.data(), working_bits);
  return sum;
}
inline Ball operator-(const Ball& a, const Ball& b) {
  Ball difference;
  arb_sub(difference.data(), a.data(), b.data(), working_bits);
  return difference;
}
inline Ball operator*(const Ball& a, const Ball& b) {
  Ball product;
  arb_mul(product.data(), a.data(), b.data(), working_bits);
  return product;
}
inline Ball operator/(const Ball& a, const Ball& b) {
  Ball quotient;
  arb_div(quotient.data(), a.data(), b.data(), working_bits);
  return quotient;
}
inline Ball operator-(const Ball& a) {
  Ball negative;
  arb_neg(negative.data(), a.data());
  return negative;
}
inline ComplexBall operator+(const ComplexBall& a, const ComplexBall& b) {
  ComplexBall sum;
  acb_add(sum.data(), a.data(), b.data(), working_bits);
  return sum;
}
inline ComplexBall operator-(const ComplexBall& a, const ComplexBall& b) {
  ComplexBall difference;
  acb_sub(difference.data(), a.data(), b.data(), working_bits);
  return difference;
}
inline ComplexBall operator*(const ComplexBall& a, const ComplexBall& b) {
  ComplexBall product;
  acb_mul(product.data(), a.data(), b.data(), working_bits);
  return product;
}
inline ComplexBall operator/(const ComplexBall& a, const ComplexBall& b) {
  ComplexBall quotient;
  acb_div(quotient.data(), a.data(), b.data(), working_bits);
  return quotient;
}

/// Whether all members are > 0, or all are < 0. Where neither holds, the sign is not known.
inline bool positive(const Ball& a) {
  return arb_is_positive(a.data()) != 0;
}
inline bool negative(const Ball& a) {
  return arb_is_negative(a.data()) != 0;
}
inline bool finite(const ComplexBall& a) {
  return acb_is_finite(a.data()) != 0;
}

Ball upper(const Ball& a);                      ///< the largest member
Ball lower(const Ball& a);                      ///< the least
Ball middle(const Ball& a);                     ///< a member, exactly
Ball magnitude(const Ball& a);                  ///< no member is larger, either way
Ball magnitude(const ComplexBall& a);           ///< likewise
Ball within(const Ball& bound);                 ///< all between ±bound
Ball hull(const Ball& a, const Ball& b);        ///< all between members of a and of b
Ball root(const Ball& a);                       ///< √a
Ball arctangent(const Ball& y, const Ball& x);  ///< atan2(y, x)
Ball half_turn();                               ///< π
Ball power(const Ball& base, ulong exponent);
ComplexBall disc(const Ball& centre, const Ball& radius);  ///< encloses all complex |z − centre| ≤ radius

double approximate(const Ball& a);     ///< the middle, rounded
double width_exponent(const Ball& a);  ///< log₂ of the radius, −∞ of an exact number

/// Sine and cosine; the rate of the angle is what a series needs (series.hpp).
template <class Number>
struct SineCosine {
  Number sine, cosine;
};
SineCosine<Ball> sine_cosine(const Ball& angle, const Ball& rate);
SineCosine<ComplexBall> sine_cosine(const ComplexBall& angle, const ComplexBall& rate);

/// Decimal texts with so many places: no member is below the first, none above the second.
struct DecimalBounds {
  std::string lower, upper;
};
DecimalBounds decimal_bounds(const Ball& a, slong places);

/// "mantissa*2^exponent", exactly. Precondition: the number is exact.
std::string exact_text(const Ball& a);

}  // namespace rockstack::proof
