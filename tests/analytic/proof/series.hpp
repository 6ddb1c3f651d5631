#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "tests/analytic/proof/ball.hpp"

namespace rockstack::proof {

/// Taylor coefficients of what a motion is made of, each by the rule of the operation that made it.
/// Coefficients of the next order follow from those so far, and those of a state from its rate.
class Tape {
 public:
  enum class Rule { given, sum, difference, scaled, product, quotient, sine, cosine };
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  /// Series of so many coefficients, > 2.
  explicit Tape(slong terms) : terms_(terms) {}
  ~Tape();
  Tape(const Tape&) = delete;
  Tape& operator=(const Tape&) = delete;

  slong terms() const { return terms_; }
  /// Adds a series. Its coefficient of order 0 is known where those of a and b are.
  std::size_t add(Rule rule, std::size_t a = none, std::size_t b = none);
  arb_ptr coefficients(std::size_t series) { return series_[series].coefficients; }
  /// Makes one series the derivative of another.
  void set_rate(std::size_t state, std::size_t rate) { rates_[state] = rate; }
  /// Makes a pair of series the sine and cosine of one angle.
  void pair(std::size_t sine, std::size_t cosine);
  /// Finds all coefficients of this order, and those of states of the next.
  void extend(slong order);

 private:
  struct Recorded {
    Rule rule;
    std::size_t a, b;
    arb_ptr coefficients;
  };
  void evaluate(const Recorded& series, slong order);

  slong terms_;
  std::vector<Recorded> series_;
  std::map<std::size_t, std::size_t> rates_;
};

/// A number that depends on time: a constant, or a series of a tape.
class Series {
 public:
  Series() = default;
  Series(int number) : constant_(number) {}
  Series(const Ball& number) : constant_(number) {}
  Series(Tape& tape, std::size_t index) : tape_(&tape), index_(index) {}

  bool is_constant() const { return tape_ == nullptr; }
  bool is_zero() const { return is_constant() && arb_is_zero(constant_.data()); }
  const Ball& constant() const { return constant_; }
  Tape* tape() const { return tape_; }
  std::size_t index() const { return index_; }
  /// The series on a tape, a constant too.
  std::size_t on(Tape& tape) const;
  Ball start() const;  ///< the coefficient of order 0

 private:
  Tape* tape_ = nullptr;
  std::size_t index_ = 0;
  Ball constant_;
};

Series operator+(const Series& a, const Series& b);
Series operator-(const Series& a, const Series& b);
Series operator*(const Series& a, const Series& b);
Series operator/(const Series& a, const Series& b);
SineCosine<Series> sine_cosine(const Series& angle, const Series& rate);

}  // namespace rockstack::proof
