#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "analytic/scene/ground/records/header.hpp"
#include "analytic/scene/ground/records/vocabulary.hpp"

namespace rockstack::records {
namespace {

using Tokens = std::vector<std::string_view>;

/// A comma between digits: a decimal point, or of thousands where three digits follow, and nothing.
std::string comma_at(std::string_view text, std::size_t at) {
  const std::size_t end = std::min(text.find_first_not_of("0123456789", at + 1), text.size());
  if (at == 0 || !is_digit(text[at - 1]) || end == at + 1) return ",";
  return end - at - 1 == 3 ? "" : ".";
}

/// A folded line with blanks around each "=" and ":", and decimal points.
std::string with_signs_apart(std::string_view line) {
  const std::string plain = folded(line);
  std::string text;
  for (std::size_t k = 0; k < plain.size(); ++k) {
    const char c = plain[k];
    text += c == '=' || c == ':' ? std::string{' ', c, ' '}
            : c == ','           ? comma_at(plain, k)
                                 : std::string(1, c);
  }
  return text;
}

bool is_sign(std::string_view token) {
  return token == "=" || token == ":";
}

std::size_t after_signs(const Tokens& tokens, std::size_t at) {
  while (at < tokens.size() && is_sign(tokens[at])) ++at;
  return at;
}

/// The number that a token is, whole.
std::optional<double> value_of(const Tokens& tokens, std::size_t at) {
  if (at >= tokens.size()) return std::nullopt;
  const std::string_view token = tokens[at];
  double value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  return error == std::errc() && end == token.data() + token.size() ? std::optional(value) : std::nullopt;
}

/// Where the number of values would stand that words from `at` on announce: "number of data points", "NPTS",
/// "samples:".
std::optional<std::size_t> count_place(const Tokens& tokens, std::size_t at) {
  constexpr std::size_t longest = 4;  // words from the number to what it counts
  if (is_of(tokens[at], Topic::count_key)) return at + 1;
  const std::size_t end = is_of(tokens[at], Topic::number) ? std::min(at + longest, tokens.size()) : 0;
  for (std::size_t k = at + 1; k < end; ++k)
    if (is_of(tokens[k], Topic::counted) && !(k + 1 < tokens.size() && is_of(tokens[k + 1], Topic::counted)))
      return k + 1;
  const bool signed_after = at + 1 < tokens.size() && is_sign(tokens[at + 1]);
  return is_of(tokens[at], Topic::counted) && signed_after ? std::optional(at + 1) : std::nullopt;
}

bool is_of_rate(const Tokens& tokens, std::size_t at) {
  return at < tokens.size() &&
         (tokens[at] == "per" || tokens[at].starts_with('/') || (read_unit(tokens[at]) && tokens[at] != "g"));
}

/// Whether a number counts values that stand after it: "400 points", not "8 values per line" or "every 10
/// points".
bool counts_next(const Tokens& tokens, std::size_t at) {
  std::size_t noun = at + 1;
  if (noun < tokens.size() && tokens[noun] == "data") ++noun;
  if (noun >= tokens.size() || !is_of(tokens[noun], Topic::count_noun)) return false;
  const bool part = at > 0 && is_of(tokens[at - 1], Topic::before_part);
  const bool line = std::ranges::any_of(tokens, [](auto word) { return word == "line" || word == "row"; });
  return !part && !line && (noun + 1 == tokens.size() || is_of(tokens[noun + 1], Topic::after_count));
}

void read_stated_count(const Cursor& cursor, const Tokens& tokens, Header& header) {
  for (std::size_t k = 0; k < tokens.size(); ++k) {
    const auto place = counts_next(tokens, k) ? std::optional(k) : count_place(tokens, k);
    if (!place) continue;
    const std::size_t at = after_signs(tokens, *place);
    const auto value = value_of(tokens, at);
    constexpr double most = 1e9;
    if (!value || !(*value >= 1) || *value > most || *value != std::floor(*value) ||
        is_of_rate(tokens, at + 1))
      continue;
    const auto stated = static_cast<std::size_t>(*value);
    if (header.stated_count != 0 && header.stated_count != stated)
      cursor.fail("announces " + std::to_string(stated) + " values, line " +
                  std::to_string(header.stated_count_line) + " " + std::to_string(header.stated_count));
    header.stated_count = stated;
    header.stated_count_line = cursor.line_number();
  }
}

/// Where a factor would stand that words from `at` on announce: "scale factor", "multiplied by".
std::optional<std::size_t> factor_place(const Tokens& tokens, std::size_t at) {
  if (at + 1 < tokens.size() && is_of(tokens[at], Topic::scaled) && is_of(tokens[at + 1], Topic::by))
    return at + 2;
  return any_of_topic(words_in(tokens[at]), Topic::factor) ? std::optional(at + 1) : std::nullopt;
}

void refuse_factor(const Cursor& cursor, const Tokens& tokens) {
  const bool applied = any_of_topic(tokens, Topic::applied) &&
                       std::ranges::find(tokens, "not") == tokens.end() &&
                       std::ranges::find(tokens, "be") == tokens.end();
  for (std::size_t k = 0; k < tokens.size() && !applied; ++k) {
    const auto place = factor_place(tokens, k);
    if (!place || (k > 0 && is_of(tokens[k - 1], Topic::factor_of_others))) continue;
    const std::size_t at = after_signs(tokens, *place);
    const auto value = value_of(tokens, at);
    const bool ratio = at + 1 < tokens.size() && tokens[at + 1] == ":";  // of lengths, "1:5"
    if (value && *value != 1 && !ratio)
      cursor.fail(
          "names a factor, " + std::string(tokens[at]) +
          ", and not whether the numbers below are multiplied by it: must be applied to them and taken "
          "out of this line");
  }
  if (any_of_topic(tokens, Topic::normalised))
    cursor.fail(
        "says that the numbers are normalised, which have no unit then: must be multiplied by their peak, "
        "and this word taken out");
}

/// "missing data: 999", "null value = -999".
void read_missing(const Tokens& tokens, Header& header) {
  for (std::size_t k = 0; k < tokens.size(); ++k) {
    const bool no_data = tokens[k] == "no" && k + 1 < tokens.size() && tokens[k + 1] == "data";
    const bool counted = k > 1 && tokens[k - 1] == "of";  // "number of missing data: 0"
    if (counted || !(is_of(tokens[k], Topic::missing) || no_data)) continue;
    std::size_t at = k + 1;
    while (at < tokens.size() && (is_sign(tokens[at]) || is_of(tokens[at], Topic::missing_filler))) ++at;
    if (const auto value = value_of(tokens, at)) header.missing = value;
  }
}

/// Whether a line names a step or a rate, with its unit, that is this step.
bool names_step(std::string_view plain, double interval) {
  constexpr double rounding = 1e-6;
  const auto list = words(plain, ",;:=()[]");
  for (std::size_t k = 0; k + 1 < list.size(); ++k) {
    const auto unit = read_unit(list[k + 1]);
    double value = 0;
    if (!unit || std::from_chars(list[k].data(), list[k].data() + list[k].size(), value).ec != std::errc())
      continue;
    const double named = value * unit->factor,
                 step = unit->quantity == Quantity::frequency ? 1 / named : named;
    if (std::abs(step - interval) < rounding * interval) return true;
  }
  return false;
}

/// Notes a line that says samples were left out, averaged or interpolated, unless it names the step as what
/// came of that: "resampled to 100 Hz".
void note_resampling(const Cursor& cursor, std::string_view plain, Header& header) {
  constexpr std::array results{"decimat", "downsampl", "subsampl", "resampl", "interpolated to"};
  constexpr std::array ways{"block average", "averaged by", "output every", "only every"};
  const auto has = [&](auto part) { return plain.find(part) != plain.npos; };
  const bool named = header.interval && names_step(plain, *header.interval);
  if (header.resampled_line == 0 &&
      (std::ranges::any_of(ways, has) || (std::ranges::any_of(results, has) && !named)))
    header.resampled_line = cursor.line_number();
}

}  // namespace

void read_statements(const Cursor& cursor, const Line& line, Header& header) {
  const std::string text = with_signs_apart(line.text);
  const Tokens tokens = words(text, ",;()[]\"'#%!*");
  read_stated_count(cursor, tokens, header);
  refuse_factor(cursor, tokens);
  read_missing(tokens, header);
  note_resampling(cursor, folded(line.text), header);
  if (header.spectrum_line == 0 && any_of_topic(tokens, Topic::spectrum) &&
      !any_of_topic(tokens, Topic::history))
    header.spectrum_line = line.number;
}

}  // namespace rockstack::records
