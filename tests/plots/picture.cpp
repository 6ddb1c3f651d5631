#include "tests/plots/picture.hpp"

#include <algorithm>
#include <cmath>
#include <regex>
#include <string_view>

#include "comparisons/measures/results/csv.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::testing {
namespace {

/// The value of an attribute of a tag, in either quotes; empty where it has none.
std::string attribute(const std::string& tag, const std::string& name) {
  const std::size_t at = tag.find(" " + name + "=");
  if (at == std::string::npos) return "";
  const std::size_t open = at + name.size() + 2;
  return tag.substr(open + 1, tag.find(tag[open], open + 1) - open - 1);
}

std::string without_blanks(std::string text) {
  std::erase(text, ' ');
  return text;
}

/// The numbers in a text, whatever stands between them.
std::vector<double> numbers_in(const std::string& text) {
  static const std::regex number(R"(-?\d+(\.\d+)?)");
  std::vector<double> list;
  for (std::sregex_iterator at(text.begin(), text.end(), number), end; at != end; ++at)
    list.push_back(std::stod(at->str()));
  return list;
}

/// The words of a text element, without the tags within and with its signs as they are.
std::string words_in(const std::string& element) {
  std::string words = std::regex_replace(element, std::regex("<[^>]*>"), "");
  for (const auto& [code, sign] : {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}})
    for (std::size_t at = words.find(code); at != std::string::npos; at = words.find(code, at + 1))
      words.replace(at, std::string_view(code).size(), sign);
  return words;
}

struct Box {
  double left, right, low, high;
};

/// How wide a letter is at least, a share of the font's size, in DejaVu Sans.
double letter_width(char letter) {
  if ((static_cast<unsigned char>(letter) & 0xC0U) == 0x80U) return 0;  // goes on a letter of several bytes
  return std::string_view("fijlrtI .,:;'|!()-").find(letter) != std::string_view::npos ? 0.28 : 0.5;
}

Box box_of(const ShownText& text, double wider) {
  double width = 0;
  for (const char letter : text.words) width += wider * letter_width(letter) * text.size;
  const double before = text.anchor == "start" ? 0 : text.anchor == "middle" ? width / 2 : width;
  const double height = 0.6 * text.size;
  return text.turned ? Box{text.x - height, text.x, text.y - width + before, text.y + before}
                     : Box{text.x - before, text.x - before + width, text.y - height, text.y};
}

bool meet(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.low < b.high && b.low < a.high;
}

}  // namespace

bool Picture::says(const std::string& words) const {
  return std::any_of(texts.begin(), texts.end(),
                     [&](const ShownText& text) { return text.words.find(words) != std::string::npos; });
}

std::vector<ShownMark> Picture::marks_of(const std::string& colour) const {
  std::vector<ShownMark> list = marks;
  std::erase_if(list, [&](const ShownMark& mark) { return mark.colour != colour; });
  return list;
}

std::vector<ShownLine> Picture::lines_of(const std::string& colour) const {
  std::vector<ShownLine> list = lines;
  std::erase_if(list, [&](const ShownLine& line) { return line.colour != colour; });
  return list;
}

Picture read_picture(const std::filesystem::path& file) {
  const std::string svg = bytes_of(file);
  Picture picture;
  const std::vector<double> box = numbers_in(attribute(svg.substr(svg.find("<svg"), 200), "viewBox"));
  picture.width = box.at(2), picture.height = box.at(3);
  std::string group;  // the tag that text, marks and lines are in
  for (std::size_t at = svg.find("</defs>"); (at = svg.find('<', at + 1)) != std::string::npos;) {
    const std::string tag = svg.substr(at, svg.find('>', at) - at + 1);
    if (tag.starts_with("<g ")) {
      group = tag;
    } else if (tag.starts_with("<text")) {
      const std::size_t end = svg.find("</text>", at);
      const std::vector<double> place = numbers_in(attribute(group, "transform"));
      ShownText text{
          place.at(0),
          place.at(1),
          std::stod(attribute(group, "font-size")),
          attribute(group, "text-anchor"),
          without_blanks(attribute(group, "fill")),
          words_in(svg.substr(at, end - at)),
          group.find("rotate(-90") != std::string::npos || group.find("rotate(270") != std::string::npos};
      if (text.colour != "none" && !without_blanks(text.words).empty())
        picture.texts.push_back(std::move(text));
    } else if (tag.starts_with("<use ") && tag.find("#gpDot") == std::string::npos) {  // no middle of a range
      const std::vector<double> place = numbers_in(attribute(tag, "transform"));
      picture.marks.push_back({place.at(0), place.at(1), without_blanks(attribute(tag, "color"))});
    } else if (tag.starts_with("<path ")) {
      ShownLine line{without_blanks(attribute(tag, "stroke")), 0, {}};
      if (const std::string width = attribute(group, "stroke-width"); !width.empty())
        line.width = std::stod(width);
      const std::vector<double> places = numbers_in(attribute(tag, "d"));
      for (std::size_t i = 0; i + 1 < places.size(); i += 2)
        line.points.emplace_back(places[i], places[i + 1]);
      picture.lines.push_back(std::move(line));
    }
  }
  return picture;
}

std::string shown_colour(const std::string& hexadecimal) {
  std::string text = "rgb(";
  for (const std::size_t at : {1U, 3U, 5U})
    text += std::to_string(std::stoi(hexadecimal.substr(at, 2), nullptr, 16)) + (at < 5 ? "," : ")");
  return text;
}

std::vector<std::string> collisions(const Picture& picture, double wider) {
  std::vector<std::string> list;
  for (std::size_t i = 0; i < picture.texts.size(); ++i) {
    const Box one = box_of(picture.texts[i], wider);
    if (one.left < 0 || one.right > picture.width || one.low < 0 || one.high > picture.height)
      list.push_back(picture.texts[i].words + " reaches over the edge");
    for (std::size_t j = 0; j < i; ++j)
      if (meet(one, box_of(picture.texts[j], wider)))
        list.push_back(picture.texts[i].words + " lies on " + picture.texts[j].words);
  }
  return list;
}

ShownAxis left_axis(const Picture& picture, double top, double bottom) {
  std::vector<std::pair<double, double>> tics;  // pixel, value
  for (const ShownText& text : picture.texts)
    if (text.anchor == "end" && text.y > top && text.y < bottom)
      if (const auto value = number_in(without_blanks(text.words)))
        tics.emplace_back(text.y - 0.3 * text.size, *value);
  const auto [low, high] = std::minmax_element(tics.begin(), tics.end());
  const double slope = (high->second - low->second) / (high->first - low->first);
  return {low->second - slope * low->first, slope};
}

}  // namespace rockstack::testing
