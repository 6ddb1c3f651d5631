#include "tests/plots/browser.hpp"

#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "tests/temporary_folder.hpp"

namespace rockstack::testing {
namespace {

/// The browser's time is virtual and runs ahead of its drawing: on a busy machine it can be over before a
/// frame comes. A timer of the same time gives the frames.
constexpr auto before = R"(<script>
requestAnimationFrame = (call) => setTimeout(() => call(performance.now()), 16);
const complaints = [];
addEventListener("error", (event) => complaints.push(String(event.message)));
addEventListener("unhandledrejection", (event) => complaints.push(String(event.reason)));
console.error = (...words) => complaints.push(words.join(" "));
</script>)";

/// The answer stands between marks that no page has.
constexpr auto opening = "[[answer:", closing = ":answer]]";

std::string with_probe(const std::string& page, const std::string& probe) {
  const std::string script = std::string(
                                 "<script>addEventListener('load', async () => {\n"
                                 "const wait = (ms) => new Promise((done) => setTimeout(done, ms));\n"
                                 "const player = document.querySelector('.player')?.player;\nlet result;\n"
                                 "try { result = await (async () => {") +
                             probe + "})(); } catch (error) { complaints.push('probe: ' + error); }\n" +
                             "const answer = JSON.stringify({result: result ?? null, complaints});\n" +
                             "document.body.append('[[answer' + ':' + "
                             "btoa(unescape(encodeURIComponent(answer))) + ':' + 'answer]]');\n" +
                             "});</script>";
  std::string text = page;
  text.insert(text.find("<head>") + 6, before);
  return text.insert(text.rfind("</body>"), script);
}

std::string from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, count = 0;
  for (const char letter : text) {
    const std::size_t digit = digits.find(letter);
    if (digit == std::string::npos) break;
    bits = (bits << 6U | static_cast<unsigned>(digit)) & 0xFFFFU;
    count += 6;
    if (count >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 0xFFU);
  }
  return bytes;
}

std::string output_of(const std::string& command) {
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  std::string text;
  char buffer[4096];
  for (std::size_t count = 0; (count = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;)
    text.append(buffer, count);
  ::pclose(pipe);
  return text;
}

}  // namespace

bool has_browser() {
  return std::system("command -v chromium >/dev/null") == 0;
}

Answer ask_browser(const std::string& page, const std::string& probe) {
  const TemporaryFolder scratch;
  const std::string folder = scratch.path().string();
  const std::string file = scratch.write("page.html", with_probe(page, probe)).string();
  const std::string dom =
      output_of("HOME='" + folder + "' timeout 1200 chromium --headless --no-sandbox --disable-gpu" +
                " --user-data-dir='" + folder + "/profile' --virtual-time-budget=20000" +
                " --window-size=1100,900 --dump-dom 'file://" + file + "' 2>'" + folder + "/errors'");
  const std::size_t from = dom.find(opening), to = dom.find(closing);
  if (from == std::string::npos || to == std::string::npos)
    throw std::runtime_error("the browser gave no answer: " + output_of("cat '" + folder + "/errors'"));
  const std::size_t begin = from + std::string(opening).size();
  const nlohmann::json answer = nlohmann::json::parse(from_base64(dom.substr(begin, to - begin)));
  return {answer.at("result"), answer.at("complaints")};
}

}  // namespace rockstack::testing
