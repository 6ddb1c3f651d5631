// Engines that fail on purpose, each in the way of its solver's name; "fine" does not. The block of "fine"
// starts as it is placed, and turns at 1 rad/s from then on.

#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <stdexcept>
#include <utility>

#include "engines/worker/serve.hpp"

namespace rockstack {
namespace {

using Fault = std::function<void(double& angle)>;

class FaultySimulation : public Simulation {
 public:
  FaultySimulation(Fault fault, const Setup& setup)
      : fault_(std::move(fault)),
        start_(setup.blocks.front()),
        dt_(setup.dt),
        angle_(start_.angle),
        velocity_(start_.angular_velocity) {}
  void step() override {
    angle_ += dt_;
    velocity_ = 1;
    fault_(angle_);
  }
  BodyState body(std::size_t) const override {
    return {start_.x, start_.y, start_.velocity_x, start_.velocity_y, angle_, velocity_};
  }

 private:
  Fault fault_;
  Placement start_;
  double dt_, angle_, velocity_;
};

[[noreturn]] void loop(double&) {
  for (volatile unsigned turn = 0;;) turn = turn + 1;
}

void abort_with_words(double&) {
  std::fputs("first words\nassertion `depth > 0' failed\n", stderr);
  std::abort();
}

void eat_memory(double&) {
  // Kept, and in a container, so that the compiler cannot leave the memory out.
  static std::vector<std::vector<char>> blocks;
  for (;;) blocks.emplace_back(std::size_t{16} << 20, '\1');
}

void reserve_memory(double&) {
  const std::size_t size = std::size_t{16} << 30;
  void* room = mmap(nullptr, size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room == MAP_FAILED) throw std::runtime_error("no room for a heap");
  munmap(room, size);
}

void talk(double&) {
  for (int line = 0; line < 20000; ++line) {
    std::fputs("words nobody reads\n", stderr);
    std::puts("nor these");
  }
}

/// What stays in the session of this worker, out of its group: its number is in standard error.
void leave_a_child(double&) {
  static bool done = false;
  if (std::exchange(done, true)) return;
  const pid_t child = fork();
  if (child != 0) {
    std::fprintf(stderr, "%d\n", child);
    std::abort();
  }
  setpgid(0, 0);
  for (;;) pause();
}

/// A question at the terminal, for which whoever has one would wait.
void ask_the_terminal(double&) {
  std::FILE* terminal = std::fopen("/dev/tty", "r");
  if (terminal == nullptr) throw std::runtime_error("no terminal");
  std::fgetc(terminal);
}

std::vector<Engine> make_faulty() {
  const std::vector<std::pair<const char*, Fault>> faults{
      {"fine", [](double&) {}},
      {"throw", [](double&) { throw std::runtime_error("broken on purpose"); }},
      {"not-finite", [](double& angle) { angle = std::nan(""); }},
      {"abort", abort_with_words},
      {"segment", [](double&) { std::raise(SIGSEGV); }},
      {"killed", [](double&) { std::raise(SIGKILL); }},
      {"exit", [](double&) { std::_Exit(7); }},
      {"loop", loop},
      {"half-a-second",
       [](double&) {
         while (std::clock() < CLOCKS_PER_SEC / 2) continue;
       }},
      {"memory", eat_memory},
      {"reserves", reserve_memory},
      {"talk", talk},
      {"deaf",
       [](double&) {
         close(STDERR_FILENO);
         for (;;) pause();
       }},
      {"stopped", [](double&) { std::raise(SIGSTOP); }},
      {"asleep", [](double&) { std::raise(SIGTSTP); }},
      {"leaves-a-child", leave_a_child},
      {"asks", ask_the_terminal},
      {"half", [](double&) {
         [[maybe_unused]] const auto written = write(reply_descriptor, "half", 4);
         std::_Exit(0);
       }}};
  std::vector<Engine> engines;
  for (const auto& [name, fault] : faults) {
    engines.push_back({{.name = "faulty",
                        .solver = name,
                        .version = "1",
                        .licence = "none",
                        .settings = {{.name = "strength", .default_value = 1, .tuned = 2, .most = 3}}},
                       [fault = fault](const Setup& setup, const Parameters&) {
                         return std::make_unique<FaultySimulation>(fault, setup);
                       }});
  }
  return engines;
}

}  // namespace
}  // namespace rockstack

int main() {
  // A sanitizer's own handler would turn the signal into an exit code.
  std::signal(SIGSEGV, SIG_DFL);
  return rockstack::serve(rockstack::make_faulty());
}
