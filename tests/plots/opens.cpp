#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>

#include "tests/plots/browser.hpp"

namespace rockstack::testing {
namespace {

/// What is wrong with a page in a browser, a line each: complaints, no player, a player that does not move.
std::string faults(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  const Answer answer = ask_browser(page, R"(
    const players = Array.from(document.querySelectorAll(".player"), (root) => root.player), moved = [];
    for (const one of players) {
      one.find("play").click();
      for (let i = 0; i < 500 && one.frames < 3; ++i) await wait(20);
      one.find("play").click();
      moved.push(one.frames >= 3 && one.time > 0);
    }
    return moved;)");
  std::string text;
  for (const nlohmann::json& words : answer.complaints) text += file + ": " + words.get<std::string>() + "\n";
  if (answer.result.empty()) text += file + ": no player\n";
  if (std::count(answer.result.begin(), answer.result.end(), false) > 0)
    text += file + ": a player does not move\n";
  return text;
}

}  // namespace
}  // namespace rockstack::testing

/// opens PAGE: the page loads in a browser without complaint, and its players move. Where there is no
/// browser, nothing is asked.
int main(int count, char** words) {
  try {
    if (count != 2) throw std::invalid_argument("opens PAGE");
    if (!rockstack::testing::has_browser()) return 0;
    const std::string text = rockstack::testing::faults(words[1]);
    std::cerr << text;
    return text.empty() ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
}
