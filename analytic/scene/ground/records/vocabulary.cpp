#include "analytic/scene/ground/records/vocabulary.hpp"

#include <algorithm>

#include "analytic/scene/ground/records/dialect.hpp"
#include "analytic/scene/ground/records/text.hpp"
#include "rockstack_scene_texts.hpp"

namespace rockstack::records {
namespace {

/// Words that are of a topic as they stand, and parts that make every word with them one.
struct TopicWords {
  std::vector<std::string_view> wholes = {}, parts = {};
};

/// The words after "topic:", on its line and on those below that begin with a blank.
std::vector<TopicWords> read_words() {
  std::vector<TopicWords> topics;
  for (Cursor rest("words.txt", words_txt); !rest.at_end();) {
    std::string_view line = rest.next({});
    if (line.empty() || line.starts_with('#')) continue;
    if (!line.starts_with(' ')) {
      topics.emplace_back();
      line.remove_prefix(line.find(':') + 1);
    }
    for (const std::string_view word : split(line, {','}))
      if (!word.empty())
        (word.front() == '*' ? topics.back().parts : topics.back().wholes)
            .push_back(word.substr(word.front() == '*' ? 1 : 0));
  }
  return topics;
}

const TopicWords& of_topic(Topic topic) {
  static const std::vector<TopicWords> topics = read_words();
  return topics[static_cast<std::size_t>(topic)];
}

/// Letters that stand for others: capitals of two bytes, accents, final forms.
constexpr std::pair<std::string_view, std::string_view> letters[] = {
    {"à", "a"},     {"á", "a"},     {"â", "a"},     {"ã", "a"},     {"ä", "a"},     {"å", "a"},
    {"À", "a"},     {"Á", "a"},     {"Â", "a"},     {"Ã", "a"},     {"Ä", "a"},     {"ç", "c"},
    {"Ç", "c"},     {"è", "e"},     {"é", "e"},     {"ê", "e"},     {"ë", "e"},     {"È", "e"},
    {"É", "e"},     {"Ê", "e"},     {"ğ", "g"},     {"Ğ", "g"},     {"ì", "i"},     {"í", "i"},
    {"î", "i"},     {"ï", "i"},     {"ı", "i"},     {"İ", "i"},     {"Í", "i"},     {"Î", "i"},
    {"ñ", "n"},     {"Ñ", "n"},     {"ò", "o"},     {"ó", "o"},     {"ô", "o"},     {"õ", "o"},
    {"ö", "o"},     {"Ó", "o"},     {"Ô", "o"},     {"Ö", "o"},     {"ş", "s"},     {"Ş", "s"},
    {"ß", "ss"},    {"ù", "u"},     {"ú", "u"},     {"û", "u"},     {"ü", "u"},     {"Ù", "u"},
    {"Ú", "u"},     {"Û", "u"},     {"Ü", "u"},     {"ά", "α"},     {"έ", "ε"},     {"ή", "η"},
    {"ί", "ι"},     {"ό", "ο"},     {"ύ", "υ"},     {"ώ", "ω"},     {"ς", "σ"},     {"Ά", "α"},
    {"Έ", "ε"},     {"Ή", "η"},     {"Ί", "ι"},     {"Ό", "ο"},     {"Ύ", "υ"},     {"Ώ", "ω"},
    {"Α", "α"},     {"Β", "β"},     {"Γ", "γ"},     {"Δ", "δ"},     {"Ε", "ε"},     {"Ζ", "ζ"},
    {"Η", "η"},     {"Θ", "θ"},     {"Ι", "ι"},     {"Κ", "κ"},     {"Λ", "λ"},     {"Μ", "μ"},
    {"Ν", "ν"},     {"Ξ", "ξ"},     {"Ο", "ο"},     {"Π", "π"},     {"Ρ", "ρ"},     {"Σ", "σ"},
    {"Τ", "τ"},     {"Υ", "υ"},     {"Φ", "φ"},     {"Χ", "χ"},     {"Ψ", "ψ"},     {"Ω", "ω"},
    {"А", "а"},     {"Б", "б"},     {"В", "в"},     {"Г", "г"},     {"Д", "д"},     {"Е", "е"},
    {"Ж", "ж"},     {"З", "з"},     {"И", "и"},     {"К", "к"},     {"Л", "л"},     {"М", "м"},
    {"Н", "н"},     {"О", "о"},     {"П", "п"},     {"Р", "р"},     {"С", "с"},     {"Т", "т"},
    {"У", "у"},     {"Ф", "ф"},     {"Х", "х"},     {"Ц", "ц"},     {"Ч", "ч"},     {"Щ", "щ"},
    {"\u0300", ""}, {"\u0301", ""}, {"\u0302", ""}, {"\u0303", ""}, {"\u0307", ""}, {"\u0308", ""},
    {"\u0327", ""}};

}  // namespace

std::string folded(std::string_view text) {
  const std::string small = lower(text);
  std::string plain;
  for (std::string_view rest = small; !rest.empty();) {
    const bool one_byte = static_cast<unsigned char>(rest.front()) < 0x80U;  // none of those letters
    const auto starts = [&](const auto& letter) { return rest.starts_with(letter.first); };
    const auto letter = one_byte ? std::end(letters) : std::ranges::find_if(letters, starts);
    const bool known = letter != std::end(letters);
    plain += known ? letter->second : rest.substr(0, 1);
    rest.remove_prefix(known ? letter->first.size() : 1);
  }
  return plain;
}

std::vector<std::string_view> words_in(std::string_view plain) {
  return words(plain, ",.:;_-/()[]{}'\"|=+%<>*0123456789");
}

const std::vector<std::string_view>& words_of(Topic topic) {
  return of_topic(topic).wholes;
}

bool is_of(std::string_view word, Topic topic) {
  const TopicWords& list = of_topic(topic);
  return std::ranges::find(list.wholes, word) != list.wholes.end() ||
         std::ranges::any_of(list.parts, [&](auto part) { return word.find(part) != word.npos; });
}

bool any_of_topic(const std::vector<std::string_view>& name, Topic topic) {
  return std::ranges::any_of(name, [&](auto word) { return is_of(word, topic); });
}

bool speaks_of(std::string_view text, Topic topic) {
  const std::string plain = folded(text);
  return any_of_topic(words_in(plain), topic);
}

}  // namespace rockstack::records
