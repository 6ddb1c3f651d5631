// The exact solver in a process of its own, for `rockstack live`: a scene on standard input, the answer on
// descriptor 3. Whoever asked may end it at any time, and its limits are those of any worker.

#include <unistd.h>

#include <cstdio>
#include <exception>
#include <iostream>
#include <iterator>

#include "analytic/scene/messages/one_line.hpp"
#include "comparisons/interfaces/live/exact_answers.hpp"

int main() {
  try {
    const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
    const std::string answer = rockstack::live::exact_answer(text);
    for (std::size_t done = 0; done < answer.size();) {
      const ssize_t written = write(3, answer.data() + done, answer.size() - done);
      if (written <= 0) throw std::runtime_error("the answer cannot be written");
      done += static_cast<std::size_t>(written);
    }
    return 0;
  } catch (const std::exception& error) {
    std::fputs((rockstack::one_line(error.what()) + "\n").c_str(), stderr);
    return 1;
  }
}
