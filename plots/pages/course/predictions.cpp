#include "plots/pages/course/predictions.hpp"

#include <fmt/format.h>

#include "plots/pages/html.hpp"

namespace rockstack::plots {
namespace {

std::string choices_of(const Json& part, const std::string& name) {
  std::string labels;
  int place = 0;
  for (const Json& choice : part.at("choices"))
    labels += fmt::format(
        "<label class=\"choice\"><input type=\"radio\" name=\"predict-{}\" value=\"{}\"> {}</label>\n",
        escaped(name), place++, choice.get<std::string>());
  return labels;
}

std::string number_field(const Json& part) {
  const auto unit = part.at("unit").get<std::string>();
  return fmt::format(
      "<label>Your answer{}{}: <input type=\"text\" inputmode=\"decimal\" autocomplete=\"off\"></label>\n",
      unit.empty() ? "" : ", ", escaped(unit));
}

}  // namespace

std::string prediction_part(const Json& question, std::map<std::string, std::string> numbers) {
  const auto name = question.at("name").get<std::string>(), text = question.at("text").get<std::string>();
  const Json& part = question.at("parts").at(0);
  const auto shown = part.at("shown").get<std::string>();
  numbers["answer"] = shown;
  const bool chosen = part.contains("right");
  return fmt::format(
      "<form class=\"predict\" data-name=\"{}\" data-right=\"{}\" data-value=\"{}\" data-within=\"{}\">\n"
      "<fieldset><legend>Predict: <span class=\"ask\">{}</span></legend>\n{}{}<p class=\"complaint\" "
      "role=\"alert\"></p>\n"
      "<button type=\"submit\">Commit</button> "
      "<button type=\"button\" class=\"skip\">Read on without</button></fieldset>\n"
      "<div class=\"revealed\" role=\"status\" tabindex=\"-1\"><p class=\"verdict\"></p>\n"
      "<p><strong>{}</strong>{} {}</p></div>\n</form>",
      escaped(name), chosen ? part.at("right").dump() : "", part.at("value").dump(), part.at("within").dump(),
      part.at("ask").get<std::string>(), text.empty() ? "" : element("p", text, " class=\"given\"") + "\n",
      chosen ? choices_of(part, name) : number_field(part), shown, chosen ? "." : "",
      filled_in(part.at("why").get<std::string>(), numbers));
}

}  // namespace rockstack::plots
