#include "analytic/scene/ground/records/units.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numbers>

#include "analytic/scene/ground/records/text.hpp"
#include "analytic/scene/messages/number_text.hpp"

namespace rockstack::records {
namespace {

/// A unit on the way: factor times m^length s^time rad^angle.
struct Power {
  double factor = 1;
  int length = 0, time = 0, angle = 0;
};

struct Symbol {
  std::string_view name;
  Power power;
};

constexpr Power length(double metres) {
  return {metres, 1, 0, 0};
}

constexpr Power duration(double seconds) {
  return {seconds, 0, 1, 0};
}

constexpr Power gravity(double share) {
  return {share, 1, -2, 0};
}

constexpr Power rate(double hertz) {
  return {hertz, 0, -1, 0};
}

constexpr Power angle(double radians) {
  return {radians, 0, 0, 1};
}

constexpr Symbol symbols[] = {{"m", length(1)},
                              {"meter", length(1)},
                              {"metre", length(1)},
                              {"cm", length(0.01)},
                              {"centimeter", length(0.01)},
                              {"centimetre", length(0.01)},
                              {"dm", length(0.1)},
                              {"km", length(1e3)},
                              {"mm", length(1e-3)},
                              {"millimeter", length(1e-3)},
                              {"millimetre", length(1e-3)},
                              {"um", length(1e-6)},
                              {"nm", length(1e-9)},
                              {"in", length(0.0254)},
                              {"inch", length(0.0254)},
                              {"inche", length(0.0254)},
                              {"ft", length(0.3048)},
                              {"foot", length(0.3048)},
                              {"feet", length(0.3048)},
                              {"s", duration(1)},
                              {"sec", duration(1)},
                              {"sek", duration(1)},
                              {"second", duration(1)},
                              {"sekunde", duration(1)},
                              {"seconde", duration(1)},
                              {"ms", duration(1e-3)},
                              {"msec", duration(1e-3)},
                              {"millisecond", duration(1e-3)},
                              {"millis", duration(1e-3)},
                              {"seg", duration(1)},
                              {"us", duration(1e-6)},
                              {"usec", duration(1e-6)},
                              {"microsecond", duration(1e-6)},
                              {"micros", duration(1e-6)},
                              {"min", duration(60)},
                              {"minute", duration(60)},
                              {"g", gravity(standard_gravity)},
                              {"%g", gravity(0.01 * standard_gravity)},
                              {"mg", gravity(1e-3 * standard_gravity)},
                              {"milli-g", gravity(1e-3 * standard_gravity)},
                              {"ug", gravity(1e-6 * standard_gravity)},
                              {"gn", gravity(standard_gravity)},
                              {"gal", gravity(centimetre_per_second_squared)},
                              {"mgal", gravity(1e-5)},
                              {"hz", rate(1)},
                              {"hertz", rate(1)},
                              {"khz", rate(1e3)},
                              {"sps", rate(1)},
                              {"sample", {}},
                              {"point", {}},
                              {"rad", angle(1)},
                              {"radian", angle(1)},
                              {"mrad", angle(1e-3)},
                              {"urad", angle(1e-6)},
                              {"milliradian", angle(1e-3)},
                              {"deg", angle(std::numbers::pi / 180)},
                              {"degree", angle(std::numbers::pi / 180)}};

/// One spelling of signs that have several, in lower case.
std::string plain_spelling(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 30> spellings{
      {{"\u00a0", " "},    {"\u2009", " "},  {"\u202f", " "},   {"\u2212", "-"},  {"\u2013", "-"},
       {"\u207b", "-"},    {"\u00b9", "1"},  {"\u00b2", "2"},   {"\u00b7", "*"},  {"\u22c5", "*"},
       {"\u2219", "*"},    {"\u2022", "*"},  {"\u00d7", "*"},   {"\u2215", "/"},  {"\u2044", "/"},
       {"\u00b5", "u"},    {"\u03bc", "u"},  {"\u00b0", "deg"}, {"**", "^"},      {"^{2}", "^2"},
       {"^{-2}", "^-2"},   {"^{-1}", "^-1"}, {"^(2)", "^2"},    {"^(-2)", "^-2"}, {"^(-1)", "^-1"},
       {" squared", "^2"}, {" per ", "/"},   {"g's", "g"},      {"$", ""},        {"sa/s", "sps"}}};
  std::string plain = lower(text);
  for (const auto& [from, to] : spellings)
    for (std::size_t at = plain.find(from); at != std::string::npos; at = plain.find(from, at + to.size()))
      plain.replace(at, from.size(), to);
  return std::string(trimmed(plain));
}

void skip_blanks(std::string_view& rest) {
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
}

/// Takes a sign off the front, with the blanks around it.
bool take(std::string_view& rest, char sign) {
  std::string_view after = rest;
  skip_blanks(after);
  if (!after.starts_with(sign)) return false;
  rest = after.substr(1);
  skip_blanks(rest);
  return true;
}

/// The power that a symbol is raised to, 1 without one; 0 where there is none to be read.
int take_exponent(std::string_view& rest) {
  const bool caret = take(rest, '^');
  const bool negative = rest.starts_with('-');
  const std::size_t at = negative ? 1 : 0;
  const bool digit = rest.size() > at && rest[at] >= '1' && rest[at] <= '3';
  if (!digit) return caret || negative ? 0 : 1;
  const int power = rest[at] - '0';
  rest.remove_prefix(at + 1);
  return negative ? -power : power;
}

std::optional<Power> symbol_of(std::string_view name) {
  const auto found = std::ranges::find(symbols, name, &Symbol::name);
  if (found != std::end(symbols)) return found->power;
  // Plurals: "gals", "seconds", "cms".
  if (name.size() < 2 || name.back() != 's') return std::nullopt;
  const auto one = std::ranges::find(symbols, name.substr(0, name.size() - 1), &Symbol::name);
  return one == std::end(symbols) ? std::nullopt : std::optional(one->power);
}

std::string_view take_name(std::string_view& rest) {
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz";
  const std::size_t start = rest.starts_with('%') ? 1 : 0;
  std::size_t end = std::min(rest.find_first_not_of(letters, start), rest.size());
  if (rest.starts_with("milli-g")) end = std::string_view("milli-g").size();
  const std::string_view name = rest.substr(0, end);
  rest.remove_prefix(end);
  return name;
}

void multiply(Power& product, const Power& by, int times) {
  for (int k = 0; k < std::abs(times); ++k) {
    if (times > 0)
      product.factor *= by.factor;
    else
      product.factor /= by.factor;
  }
  product.length += by.length * times;
  product.time += by.time * times;
  product.angle += by.angle * times;
}

std::optional<Power> take_product(std::string_view& rest);

/// A symbol, or a product in brackets, with its power.
std::optional<Power> take_factor(std::string_view& rest) {
  std::optional<Power> base;
  if (take(rest, '(')) {
    base = take_product(rest);
    if (!base || !take(rest, ')')) return std::nullopt;
  } else {
    base = symbol_of(take_name(rest));
  }
  const int power = take_exponent(rest);
  if (!base || power == 0) return std::nullopt;
  Power raised;
  multiply(raised, *base, power);
  return raised;
}

/// A product after a quotient would be of its dividend to some and of its divisor to others.
std::optional<Power> take_product(std::string_view& rest) {
  Power product;
  bool divided = rest.starts_with("1/");
  if (divided) rest.remove_prefix(2);
  for (bool over = divided;;) {
    const auto factor = take_factor(rest);
    if (!factor) return std::nullopt;
    multiply(product, *factor, over ? -1 : 1);
    const bool blank = rest.starts_with(' ');
    over = take(rest, '/');
    divided = divided || over;
    if (over) continue;
    if (rest.empty() || rest.starts_with(')')) return product;
    if (divided || !(take(rest, '*') || take(rest, '.') || blank)) return std::nullopt;
    skip_blanks(rest);
  }
}

/// Spellings that are no products of symbols.
std::string_view plain_name(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 9> names{{{"% g", "%g"},
                                                                                {"% of g", "%g"},
                                                                                {"micro-g", "ug"},
                                                                                {"n/kg", "m/s^2"},
                                                                                {"mps2", "m/s^2"},
                                                                                {"mps^2", "m/s^2"},
                                                                                {"mpss", "m/s^2"},
                                                                                {"\u043c/\u0441^2", "m/s^2"},
                                                                                {"\u043c/\u04412", "m/s^2"}}};
  const auto found = std::ranges::find(names, text, &std::pair<std::string_view, std::string_view>::first);
  return found == names.end() ? text : found->second;
}

std::optional<Power> read_power(std::string_view text) {
  constexpr std::size_t longest = 40;
  if (text.size() > longest) return std::nullopt;
  std::string plain = plain_spelling(text);
  if (plain.ends_with('.')) plain.pop_back();
  std::string_view rest = plain_name(plain);
  const auto power = take_product(rest);
  return rest.empty() ? power : std::nullopt;
}

}  // namespace

std::optional<Unit> read_unit(std::string_view text) {
  const auto power = read_power(text);
  if (!power) return std::nullopt;
  constexpr std::array<std::pair<std::array<int, 3>, Quantity>, 6> dimensions{
      {{{1, -2, 0}, Quantity::acceleration},
       {{1, -1, 0}, Quantity::velocity},
       {{1, 0, 0}, Quantity::displacement},
       {{0, 1, 0}, Quantity::time},
       {{0, -1, 0}, Quantity::frequency},
       {{0, 0, 1}, Quantity::angle}}};
  for (const auto& [dimension, quantity] : dimensions)
    if (dimension == std::array{power->length, power->time, power->angle})
      return Unit{power->factor, quantity};
  return std::nullopt;
}

bool resembles_unit(std::string_view text) {
  const std::string plain = plain_spelling(text);
  std::string_view rest = plain;
  const auto power = symbol_of(take_name(rest));
  return power && power->length != 0 &&
         (rest.empty() || std::string_view("/^*.-1234567890 ").find(rest.front()) != std::string_view::npos);
}

std::optional<double> unit_factor(std::string_view name) {
  const auto unit = read_unit(name);
  return unit && unit->quantity == Quantity::acceleration ? std::optional(unit->factor) : std::nullopt;
}

std::string_view name(Quantity quantity) {
  constexpr std::array names{"acceleration", "velocity", "displacement", "time", "frequency", "angle"};
  return names[static_cast<std::size_t>(quantity)];
}

std::string text(const Unit& unit) {
  constexpr std::array symbols{"m/s²", "m/s", "m", "s", "Hz", "rad"};
  constexpr int digits = 7;
  return number_text(unit.factor, digits) + " " + symbols[static_cast<std::size_t>(unit.quantity)];
}

}  // namespace rockstack::records
