// The exact solver in a process of its own, for `rockstack live`: a scene on standard input, the answer on
// descriptor 3. Whoever asked may end it at any time, and its limits are those of any worker.

#include <unistd.h>

#include <cstdio>
#include <exception>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "analytic/scene/input/json_reader.hpp"
#include "analytic/scene/input/scene_file.hpp"
#include "comparisons/interfaces/live/live_state.hpp"
#include "comparisons/suites/suite.hpp"

namespace {

using namespace rockstack;
using Json = nlohmann::ordered_json;

Json answer_to(const Json& asked) {
  MotionLibrary library;
  const Scene scene = make_scene({live::scene_document(asked.at("scene")), {}, "Live scene"}, library);
  const double interval = asked.at("interval");
  const int member = asked.at("member");
  if (member == 0) return live::exact_answer(scene, interval);
  return live::exact_member(perturbed(scene, {member, asked.at("spread")}, member), interval);
}

void write_all(const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = write(3, text.data() + done, text.size() - done);
    if (written <= 0) throw std::runtime_error("the answer cannot be written");
    done += static_cast<std::size_t>(written);
  }
}

}  // namespace

int main() {
  try {
    const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
    write_all(answer_to(parse_json(text, "the question ")).dump());
    return 0;
  } catch (const std::exception& error) {
    std::fputs((one_line(error.what()) + "\n").c_str(), stderr);
    return 1;
  }
}
