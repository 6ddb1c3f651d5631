#include <algorithm>

#include "analytic/scene/ground/records/table.hpp"
#include "analytic/scene/ground/records/vocabulary.hpp"

namespace rockstack::records {
namespace {

using Words = std::vector<std::string_view>;

bool is_rotary(const Words& name) {
  return any_of_topic(name, Topic::angle) || any_of_topic(name, Topic::rotation);
}

/// What words name: displacements and their derivatives, more than one in "displacement of accelerometer".
std::vector<Quantity> quantities_in(const Words& name) {
  constexpr std::pair<Topic, Quantity> motions[] = {{Topic::acceleration, Quantity::acceleration},
                                                    {Topic::velocity, Quantity::velocity},
                                                    {Topic::displacement, Quantity::displacement}};
  std::vector<Quantity> named;
  const bool other = any_of_topic(name, Topic::other);
  if (is_rotary(name)) return {Quantity::angle};
  for (const auto& [topic, quantity] : motions)
    if (any_of_topic(name, topic)) named.push_back(quantity);
  if (!other && any_of_topic(name, Topic::acceleration_letter))
    named.insert(named.begin(), Quantity::acceleration);
  const bool time = any_of_topic(name, Topic::time) || (!other && any_of_topic(name, Topic::time_letter));
  if (named.empty() && time) named.push_back(Quantity::time);
  return named;
}

std::optional<Quantity> quantity_in(std::string_view text) {
  const std::string plain = folded(text);
  const auto named = quantities_in(words_in(plain));
  return named.empty() ? std::nullopt : std::optional(named.front());
}

bool has_digit_at(std::string_view text, std::size_t place) {
  return place < text.size() && is_digit(text[place]);
}

/// Whether a name has a factor, as "acc x 1000", "acc/10", "1e3*acc" and "-acc"; "acc x1" is an axis.
bool has_factor(std::string_view name) {
  std::string plain = folded(name);
  if (plain.size() > 2 && plain[0] == '-' && plain[1] >= 'a' && plain[1] <= 'z' && quantity_in(plain))
    return true;
  plain = trimmed(plain);
  if (plain.ends_with("/g") || plain.ends_with("/pga") || plain.find("+/-") != plain.npos) return true;
  // A number before the unit: "acceleration, 1e-1 m/s2".
  const std::string_view last = std::string_view(plain).substr(plain.find_last_of(" ,") + 1);
  if (is_numeric(last) && last.size() < plain.size() && last.find_first_of(".e") != last.npos) return true;
  for (std::size_t at = plain.find("\u00d7"); at != plain.npos; at = plain.find("\u00d7"))
    plain.replace(at, 2, "*");
  for (std::size_t at = plain.find_first_of("x*/"); at != plain.npos;
       at = plain.find_first_of("x*/", at + 1)) {
    const std::size_t after = plain.find_first_not_of(' ', at + 1);
    const std::size_t before = at == 0 ? plain.npos : plain.find_last_not_of(' ', at - 1);
    const bool in_word = plain[at] == 'x' && before == at - 1 && at > 0 && !has_digit_at(plain, before);
    const bool axis = plain[at] == 'x' && after == at + 1 && !has_digit_at(plain, after + 1);
    const bool date = plain[at] == '/' && before != plain.npos && has_digit_at(plain, before);
    if (has_digit_at(plain, after) && !in_word && !axis && !date) return true;
    if (before != plain.npos && has_digit_at(plain, before) && !date && after != plain.npos) return true;
  }
  return false;
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
    if (!title.unit && time && is_of(folded(inside), Topic::second)) title.unit = read_unit("s");
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
    if (name == "a_g") continue;  // the ground's acceleration, in Eurocode 8
    title.unit = unit;
    return name.resize(cut);
  }
}

void name_quantity(const Words& name, Title& title) {
  const bool sampling = std::ranges::any_of(name, [](auto word) { return word.starts_with("sampl"); });
  title.spectral = !sampling && any_of_topic(name, Topic::spectral_ordinate);
  std::vector<Quantity> named = quantities_in(name);
  if (named.size() > 1 && title.unit)
    std::erase_if(named, [&](auto one) { return one != title.unit->quantity; });
  if (!named.empty()) title.quantity = named.front();
  title.other = (named.empty() && any_of_topic(name, Topic::other)) || any_of_topic(name, Topic::measure);
  title.counts = !title.quantity && !title.unit && !title.other &&
                 std::ranges::all_of(name, [](auto word) { return is_of(word, Topic::counting); });
  if (named.empty() && title.unit && !title.other && title.unknown_unit.empty())
    title.quantity = title.unit->quantity;
}

}  // namespace

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
  return is_of(lower(text), Topic::other_unit);
}

Title read_title(std::string_view text) {
  Title title{std::string(text)};
  std::string name(text);
  take_unit(name, title);
  const std::string plain = folded(name);
  const Words list = words_in(plain);
  const bool unit_alone = title.unit && name == text && !any_of_topic(list, Topic::time);
  title.name = trimmed(name);
  name_quantity(unit_alone ? Words{} : list, title);
  title.scaled = !unit_alone && (has_factor(name) || any_of_topic(list, Topic::normalised));
  return title;
}

}  // namespace rockstack::records
