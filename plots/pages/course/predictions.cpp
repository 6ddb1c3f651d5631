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

std::string number_field(const Json& part, const std::string& name) {
  const auto unit = part.at("unit").get<std::string>();
  return fmt::format(
      "<label>Your answer{}{}: <input type=\"text\" aria-describedby=\"ask-{}\" inputmode=\"decimal\" "
      "autocomplete=\"off\"></label>\n",
      unit.empty() ? "" : ", ", escaped(unit), escaped(name));
}

}  // namespace

std::string prediction_part(const Json& question, std::map<std::string, std::string> numbers) {
  const auto name = question.at("name").get<std::string>(), text = question.at("text").get<std::string>();
  const Json& part = question.at("parts").at(0);
  const auto shown = part.at("shown").get<std::string>();
  numbers["answer"] = shown;
  const bool chosen = part.contains("right");
  return fmt::format(
      "<form class=\"predict\" data-name=\"{0}\" data-right=\"{1}\" data-value=\"{2}\" data-within=\"{3}\">\n"
      "<fieldset aria-labelledby=\"predict-{0} ask-{0}\"><legend id=\"predict-{0}\">Predict</legend>\n"
      "{4}<p class=\"ask\" id=\"ask-{0}\">{5}</p>\n{6}<p class=\"complaint\" role=\"alert\"></p>\n"
      "<button type=\"submit\">Commit</button> "
      "<button type=\"button\" class=\"skip\">Read on without</button></fieldset>\n"
      "<div class=\"revealed\" role=\"status\" tabindex=\"-1\"><p class=\"verdict\"></p>\n"
      "<p><strong>{7}</strong>{8} {9}</p></div>\n</form>",
      escaped(name), chosen ? part.at("right").dump() : "", part.at("value").dump(), part.at("within").dump(),
      text.empty() ? "" : element("p", text, " class=\"given\"") + "\n", part.at("ask").get<std::string>(),
      chosen ? choices_of(part, name) : number_field(part, name), shown, chosen ? "." : "",
      filled_in(part.at("why").get<std::string>(), numbers));
}

}  // namespace rockstack::plots
