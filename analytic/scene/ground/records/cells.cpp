#include "analytic/scene/ground/records/cells.hpp"

#include <algorithm>

#include "analytic/scene/ground/records/units.hpp"
#include "analytic/scene/ground/records/vocabulary.hpp"

namespace rockstack::records {
namespace {

using Words = std::vector<std::string_view>;

/// Each title ends with brackets, or is a word.
Texts cut_at_blanks(std::string_view line, bool words_alone) {
  Texts texts{""};
  int depth = 0;
  for (const char c : line) {
    depth += c == '(' || c == '[' ? 1 : c == ')' || c == ']' ? -1 : 0;
    const bool blank = c == ' ' || c == '\t';
    const bool ended = texts.back().ends_with(')') || texts.back().ends_with(']');
    if (blank && depth == 0 && (words_alone || ended))
      texts.emplace_back();
    else
      texts.back() += c;
  }
  std::erase_if(texts, [](const std::string& text) { return trimmed(text).empty(); });
  // A bracket belongs to the word before it.
  for (std::size_t k = 1; k < texts.size(); ++k)
    if (texts[k].front() == '(' || texts[k].front() == '[') {
      texts[k - 1] += " " + texts[k];
      texts.erase(texts.begin() + static_cast<std::ptrdiff_t>(k--));
    }
  return texts;
}

/// Each title is a word, and a unit where one follows: "Time s Acceleration m s-2".
Texts cut_at_units(std::string_view line) {
  const Words list = words(line, "");
  Texts texts;
  for (std::size_t k = 0; k < list.size();) {
    texts.emplace_back(list[k++]);
    constexpr std::size_t longest = 4;
    for (std::size_t count = std::min(longest, list.size() - k); count > 0; --count) {
      const char* const end = list[k + count - 1].data() + list[k + count - 1].size();
      const std::string_view run(list[k].data(), static_cast<std::size_t>(end - list[k].data()));
      if (!read_unit(run)) continue;
      texts.back() += " " + std::string(run);
      k += count;
      break;
    }
  }
  return texts;
}

/// A line without the sign of a comment and the word that may stand before a list: "Columns: t (s), a (g)".
std::string_view without_lead_in(std::string_view line) {
  line = uncommented(line);
  const std::size_t colon = line.find(':');
  if (colon == line.npos || line.find_first_of(",;\t", colon) == line.npos) return line;
  const std::string word = lower(trimmed(line.substr(0, colon)));
  return !is_of(word, Topic::list_heading) ? line : trimmed(line.substr(colon + 1));
}

}  // namespace

Texts cut_at(std::string_view line, char separator) {
  Texts texts;
  bool quoted = false;
  texts.emplace_back();
  for (const char c : line) {
    quoted = c == '"' ? !quoted : quoted;
    if (c == separator && !quoted)
      texts.emplace_back();
    else if (c != '"')
      texts.back() += c;
  }
  for (std::string& text : texts) text = trimmed(text);
  return texts;
}

Texts cut_at_gaps(std::string_view line) {
  std::string text(line);
  for (std::size_t at = text.find("  "); at != text.npos; at = text.find("  ", at + 1)) text[at] = '\t';
  Texts texts = cut_at(text, '\t');
  std::erase(texts, "");
  return texts;
}

bool is_comment(std::string_view line) {
  line = trimmed(line);
  return line.find_first_of("#%!*/") == 0 &&
         !(starts_with(line, "%g") && words(line, ",;").front().size() == 2);
}

std::string_view uncommented(std::string_view line) {
  if (!is_comment(line)) return line;
  line = trimmed(line);
  return trimmed(line.substr(std::min(line.find_first_not_of("#%!*/"), line.size())));
}

std::vector<Texts> parted(std::string_view line, const Dialect& dialect) {
  line = without_lead_in(line);
  std::vector<Texts> ways;
  if (dialect.separator != ' ') ways.push_back(cut_at(line, dialect.separator));
  for (const char separator : {'\t', ';', ','}) ways.push_back(cut_at(line, separator));
  std::string bare(line);
  std::erase(bare, '"');
  ways.push_back(cut_at_gaps(bare));
  ways.push_back(cut_at_blanks(bare, false));
  return ways;
}

std::optional<Texts> cells_of(std::string_view line, std::size_t columns, const Dialect& dialect) {
  std::vector<Texts> ways = parted(line, dialect);
  std::string bare(without_lead_in(line));
  std::erase(bare, '"');
  ways.push_back(cut_at_units(bare));
  ways.push_back(cut_at_blanks(bare, true));
  for (Texts& way : ways) {
    if (way.size() == columns + 1 && way.back().empty()) way.pop_back();
    if (way.size() == columns) return way;
  }
  return std::nullopt;
}

}  // namespace rockstack::records
