#include <algorithm>
#include <array>
#include <cmath>

#include "analytic/scene/ground/records/table.hpp"

namespace rockstack::records {
namespace {

using Words = std::vector<std::string_view>;
using Texts = std::vector<std::string>;

constexpr std::array counting{"index", "sample", "samples", "no",   "nr",    "#",     "point", "points",
                              "row",   "id",     "unnamed", "date", "datum", "count", "number"};
constexpr std::array spectral{"period",   "periode", "periods", "freq", "frequency", "frequenz",
                              "sa",       "psa",     "sv",      "psv",  "sd",        "spectral",
                              "spectrum", "pseudo",  "fourier", "fft",  "spectra",   "damping"};
constexpr std::array times{"time", "times", "t", "zeit", "temps", "tiempo", "tempo", "elapsed", "timestamp"};
constexpr std::array accelerations{"acceleration",
                                   "accelerations",
                                   "acc",
                                   "accel",
                                   "accn",
                                   "accelerogram",
                                   "beschleunigung",
                                   "accélération",
                                   "aceleracion",
                                   "aceleración",
                                   "accelerazione",
                                   "a",
                                   "ax",
                                   "ay",
                                   "az",
                                   "ag"};
constexpr std::array velocities{"velocity", "velocities", "vel",      "veloc",   "geschwindigkeit",
                                "vitesse",  "velocidad",  "velocita", "velocità"};
constexpr std::array displacements{"displacement", "displacements", "disp",           "dis",
                                   "displ",        "displac",       "verschiebung",   "weg",
                                   "déplacement",  "deplacement",   "desplazamiento", "spostamento"};

template <std::size_t size>
bool has_word(const Words& name, const std::array<const char*, size>& list) {
  return std::ranges::any_of(name, [&](auto word) { return std::ranges::find(list, word) != list.end(); });
}

/// The last text in brackets, from its opening on.
std::size_t last_bracket(std::string_view text) {
  if (!text.ends_with(')') && !text.ends_with(']')) return text.npos;
  int depth = 0;
  for (std::size_t k = text.size(); k-- > 0;) {
    depth += text[k] == ')' || text[k] == ']' ? 1 : text[k] == '(' || text[k] == '[' ? -1 : 0;
    if (depth == 0) return k;
  }
  return text.npos;
}

bool is_other_unit(std::string_view text) {
  constexpr std::array others{"v", "mv", "volt", "volts", "count", "counts", "raw", "digits", "adc", "lsb"};
  return std::ranges::find(others, lower(text)) != others.end();
}

Words words_of(std::string_view plain) {
  return words(plain, ",.:;_-/()[]'*0123456789");
}

std::optional<Quantity> quantity_in(std::string_view text) {
  const std::string plain = lower(text);
  const Words name = words_of(plain);
  if (has_word(name, accelerations)) return Quantity::acceleration;
  if (has_word(name, velocities)) return Quantity::velocity;
  if (has_word(name, displacements)) return Quantity::displacement;
  return has_word(name, times) ? std::optional(Quantity::time) : std::nullopt;
}

/// Whether a text has signs of a unit in it, as "m/s 2" and "x10^-2 g".
bool has_unit(std::string_view text) {
  return resembles_unit(text) || text.find_first_of("/^*%") != text.npos ||
         read_unit(text.substr(text.find_last_of(' ') + 1));
}

/// Takes the unit off the end of a title: what stands in brackets, or else its last words.
void take_unit(std::string& name, Title& title) {
  if (title.unit = read_unit(name); title.unit) return;
  name.resize(name.find_last_not_of('_') + 1);
  const std::size_t open = last_bracket(name);
  if (open != name.npos) {
    const std::string inside(trimmed(std::string_view(name).substr(open + 1, name.size() - open - 2)));
    title.unit = read_unit(inside);
    const bool time = quantity_in(name.substr(0, open)) == Quantity::time;
    if (!title.unit && (time || is_other_unit(inside) || has_unit(inside))) title.unknown_unit = inside;
    name.resize(open);
    return;
  }
  // Without brackets a single letter may be a part of the name, as in "N S".
  for (std::size_t cut = name.find_first_of(" _,/"); cut != name.npos;
       cut = name.find_first_of(" _,/", cut + 1)) {
    const std::string text = name.substr(cut + 1);
    const auto unit = read_unit(text);
    const bool plain = text.find_first_of("/^*0123456789\xe2\xc2") == text.npos;
    if (!unit || (plain && quantity_in(name.substr(0, cut)) != unit->quantity)) continue;
    title.unit = unit;
    return name.resize(cut);
  }
}

void name_quantity(const Words& name, Title& title) {
  title.spectral = has_word(name, spectral);
  std::vector<Quantity> named;
  if (has_word(name, accelerations)) named.push_back(Quantity::acceleration);
  if (has_word(name, velocities)) named.push_back(Quantity::velocity);
  if (has_word(name, displacements)) named.push_back(Quantity::displacement);
  if (named.size() > 1 && title.unit)
    std::erase_if(named, [&](auto one) { return one != title.unit->quantity; });
  if (named.empty() && has_word(name, times)) named.push_back(Quantity::time);
  if (!named.empty()) title.quantity = named.front();
  title.counts = !title.quantity && !title.unit &&
                 std::ranges::all_of(name, [](auto word) { return has_word({word}, counting); });
  if (!title.quantity && title.unit && title.unknown_unit.empty()) title.quantity = title.unit->quantity;
}

/// A percent sign begins a comment, and the unit %g.
bool is_comment(std::string_view line) {
  line = trimmed(line);
  return line.find_first_of("#%!*/") == 0 &&
         !(starts_with(line, "%g") && words(line, ",;").front().size() == 2);
}

/// A line without the sign of a comment in front.
std::string_view uncommented(std::string_view line) {
  if (!is_comment(line)) return line;
  line = trimmed(line);
  return trimmed(line.substr(std::min(line.find_first_not_of("#%!*/"), line.size())));
}

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

/// Where titles are parted by two blanks or more.
Texts cut_at_gaps(std::string_view line) {
  std::string text(line);
  for (std::size_t at = text.find("  "); at != text.npos; at = text.find("  ", at + 1)) text[at] = '\t';
  Texts texts = cut_at(text, '\t');
  std::erase(texts, "");
  return texts;
}

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

/// The cells of a line of text that are as many as there are columns, by whatever they are parted.
std::optional<Texts> cells_of(std::string_view line, std::size_t columns, const Dialect& dialect) {
  line = uncommented(line);
  std::vector<Texts> ways;
  if (dialect.separator != ' ') ways.push_back(cut_at(line, dialect.separator));
  for (const char separator : {'\t', ';', ','}) ways.push_back(cut_at(line, separator));
  std::string bare(line);
  std::erase(bare, '"');
  ways.push_back(cut_at_gaps(bare));
  ways.push_back(cut_at_blanks(bare, false));
  ways.push_back(cut_at_units(bare));
  ways.push_back(cut_at_blanks(bare, true));
  for (Texts& way : ways) {
    if (way.size() == columns + 1 && way.back().empty()) way.pop_back();
    if (way.size() == columns) return way;
  }
  return std::nullopt;
}

/// Titles hold no values, "units: g" and "dt = 0.01" are none, and are no words of a sentence.
bool may_be_titles(const Texts& cells) {
  constexpr std::array small{"unit", "units", "of", "in", "is", "are", "and", "the", "for", "at", "from"};
  return std::ranges::none_of(cells, [&](const std::string& cell) {
    if (std::ranges::find(small, lower(cell)) != small.end()) return true;
    const bool has_value =
        (cell.find_first_of("=:") != cell.npos && !contains(cell, "unnamed")) ||
        std::ranges::any_of(words(cell), [](auto word) { return is_numeric(word) && contains(word, "."); });
    return has_value || is_numeric(cell);
  });
}

bool is_known(const Title& title) {
  return title.quantity || title.unit || title.spectral || !title.unknown_unit.empty();
}

/// A unit without a name, but of angles: "deg" is one, too.
bool is_unit_alone(const Title& title) {
  return title.unit && title.name == title.text && title.unit->quantity != Quantity::angle;
}

/// A row of units has one in each cell, with or without brackets, or nothing.
std::optional<std::vector<Title>> units_in(const Line& line, std::size_t columns, const Dialect& dialect) {
  const auto cells = cells_of(line.text, columns, dialect);
  if (!cells) return std::nullopt;
  std::vector<Title> units;
  for (const std::string& cell : *cells) {
    const bool bracket = last_bracket(cell) == 0;
    const std::string text(bracket ? trimmed(std::string_view(cell).substr(1, cell.size() - 2)) : cell);
    Title title{text, text, read_unit(text)};
    if (!title.unit && (resembles_unit(text) || is_other_unit(text))) title.unknown_unit = text;
    const bool nothing =
        text.empty() || text == "-" || text == "TS" || text == "RN";  // of loggers: time, row
    if (!title.unit && title.unknown_unit.empty() && !nothing) return std::nullopt;
    units.push_back(std::move(title));
  }
  const bool any = std::ranges::any_of(units, [](const Title& one) { return one.unit.has_value(); });
  return any ? std::optional(units) : std::nullopt;
}

/// Whether the numbers of the first column count the rows.
bool counts_rows(const RecordTable& table) {
  const std::vector<double> first = table.column(0, true);
  for (std::size_t k = 1; k < first.size(); ++k)
    if (first[k] != first[k - 1] + 1) return false;
  return first.front() == std::floor(first.front());
}

/// Whether times rise where titles say they are: a sentence may name quantities in another order.
bool has_rising_times(const RecordTable& table, const std::vector<Title>& titles) {
  const auto time = std::ranges::find(titles, std::optional(Quantity::time), &Title::quantity);
  if (time == titles.end()) return true;
  const std::vector<double> values = table.column(static_cast<std::size_t>(time - titles.begin()), true);
  return std::ranges::is_sorted(values);
}

std::optional<std::vector<Title>> titles_in(const Line& line, bool last, const RecordTable& table) {
  const std::size_t columns = table.columns();
  auto cells = cells_of(line.text, columns, table.dialect);
  // Tables of R have no title above the numbers of their rows.
  if (!cells && columns > 1 && counts_rows(table)) {
    cells = cells_of(line.text, columns - 1, table.dialect);
    if (cells) cells->insert(cells->begin(), "");
  }
  if (!cells || !may_be_titles(*cells)) return std::nullopt;
  std::vector<Title> titles;
  for (const std::string& cell : *cells) titles.push_back(read_title(cell));
  if (std::ranges::any_of(titles, is_unit_alone)) return std::nullopt;
  const bool sentence = contains(line.text, " in ") || !has_rising_times(table, titles);
  if ((is_comment(line.text) || columns == 1) && sentence) return std::nullopt;
  const auto known = static_cast<std::size_t>(std::ranges::count_if(titles, is_known));
  const bool names = last && !is_comment(line.text) && columns > 1;
  return known >= std::min<std::size_t>(2, columns) || names ? std::optional(titles) : std::nullopt;
}

void add_units(const RecordTable& table, std::size_t line, const std::vector<Title>& units,
               std::vector<Title>& titles) {
  for (std::size_t k = 0; k < titles.size(); ++k) {
    Title& title = titles[k];
    if (title.unit && units[k].unit && title.unit != units[k].unit)
      table.cursor.fail_at(line, "column " + std::to_string(k + 1) + " has the unit " + units[k].text +
                                     " here and another in its title \"" + title.text + "\"");
    if (units[k].unit) title.unit = units[k].unit;
    if (!title.unit) title.unknown_unit = units[k].unknown_unit;
    if (title.counts && title.unit && !title.text.empty()) title.counts = false;
    if (!title.quantity && title.unit) title.quantity = title.unit->quantity;
    if (!units[k].text.empty()) title.text += " (" + units[k].text + ")";
  }
}

/// One letter names a quantity where another column is an acceleration by its title: "t, a, v, d".
void name_letters(std::vector<Title>& titles) {
  const auto is_acceleration = [](const Title& title) { return title.quantity == Quantity::acceleration; };
  if (std::ranges::none_of(titles, is_acceleration)) return;
  for (Title& title : titles) {
    if (title.quantity || title.unit) continue;
    const std::string text = lower(title.text);
    if (text == "v") title.quantity = Quantity::velocity;
    if (text == "d" || text == "u" || text == "x" || text == "s") title.quantity = Quantity::displacement;
  }
}

}  // namespace

Title read_title(std::string_view text) {
  Title title{std::string(text)};
  std::string name(text);
  take_unit(name, title);
  const bool unit_alone = title.unit && name == text;
  const std::string plain = lower(name);
  title.name = trimmed(name);
  name_quantity(unit_alone ? Words{} : words_of(plain), title);
  return title;
}

void find_titles(RecordTable& table) {
  std::optional<std::pair<std::size_t, std::vector<Title>>> units;  // line among the header, and they
  const auto above = std::ranges::count_if(
      table.header, [&](const Line& line) { return line.number < table.lines.front(); });
  for (auto k = static_cast<std::size_t>(above); k-- > 0;) {
    const Line line = table.header[k];
    if (!units)
      if (auto row = units_in(line, table.columns(), table.dialect)) {
        units = {k, std::move(*row)};
        continue;
      }
    const bool last = k + 1 == static_cast<std::size_t>(above) || (units && units->first == k + 1);
    auto titles = titles_in(line, last, table);
    if (!titles) continue;
    if (units) add_units(table, table.header[units->first].number, units->second, *titles);
    table.titles = std::move(*titles);
    table.title_line = line.number;
    table.header.erase(table.header.begin() + static_cast<std::ptrdiff_t>(k));
    if (units && units->first > k) --units->first;
    break;
  }
  if (table.titles.empty() && units) {
    table.title_line = table.header[units->first].number;
    for (Title& unit : units->second) {
      unit.quantity = unit.unit ? std::optional(unit.unit->quantity) : std::nullopt;
      unit.name = unit.text;
      table.titles.push_back(unit);
    }
  }
  if (units) table.header.erase(table.header.begin() + static_cast<std::ptrdiff_t>(units->first));
  name_letters(table.titles);
}

}  // namespace rockstack::records
