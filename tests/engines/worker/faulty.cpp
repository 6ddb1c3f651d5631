// Engines that fail on purpose, each in the way of its solver's name; "fine" does not. The block of "fine"
// turns at 1 rad/s.

#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <utility>

#include "engines/worker/serve.hpp"

namespace rockstack {
namespace {

using Fault = std::function<void(double& angle)>;

class FaultySimulation : public Simulation {
 public:
  FaultySimulation(Fault fault, double dt) : fault_(std::move(fault)), dt_(dt) {}
  void step() override {
    angle_ += dt_;
    fault_(angle_);
  }
  BodyState body(std::size_t) const override { return {}; }
  void read(std::span<double> angles, std::span<double> velocities) const override {
    angles[0] = angle_;
    velocities[0] = 1;
  }

 private:
  Fault fault_;
  double dt_;
  double angle_ = 0;
};

class Faulty : public Engine {
 public:
  Faulty(std::string solver, Fault fault) : solver_(std::move(solver)), fault_(std::move(fault)) {}
  std::string name() const override { return "faulty"; }
  std::string solver() const override { return solver_; }
  std::string version() const override { return "1"; }
  std::vector<Setting> settings() const override { return {{"strength", 1, 2, 0, 3}}; }
  std::string licence() const override { return "none"; }

 private:
  std::unique_ptr<Simulation> build(const Setup& setup, const Parameters&) const override {
    return std::make_unique<FaultySimulation>(fault_, setup.dt);
  }

  std::string solver_;
  Fault fault_;
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

void talk(double&) {
  for (int line = 0; line < 20000; ++line) {
    std::fputs("words nobody reads\n", stderr);
    std::puts("nor these");
  }
}

/// Once, for longer than the time limit of the test.
void be_stopped(double&) {
  static bool done = false;
  if (std::exchange(done, true)) return;
  if (fork() != 0) {
    std::raise(SIGSTOP);
    return;
  }
  usleep(1'500'000);
  kill(getppid(), SIGCONT);
  _exit(0);
}

std::vector<std::unique_ptr<Engine>> make_faulty() {
  const std::vector<std::pair<const char*, Fault>> faults{
      {"fine", [](double&) {}},
      {"throw", [](double&) { throw std::runtime_error("broken on purpose"); }},
      {"not-finite", [](double& angle) { angle = std::nan(""); }},
      {"abort", abort_with_words},
      {"segment", [](double&) { std::raise(SIGSEGV); }},
      {"killed", [](double&) { std::raise(SIGKILL); }},
      {"exit", [](double&) { std::_Exit(7); }},
      {"loop", loop},
      {"memory", eat_memory},
      {"talk", talk},
      {"deaf",
       [](double&) {
         close(STDERR_FILENO);
         for (;;) pause();
       }},
      {"stopped", be_stopped},
      {"half", [](double&) {
         [[maybe_unused]] const auto written = write(reply_descriptor, "half", 4);
         std::_Exit(0);
       }}};
  std::vector<std::unique_ptr<Engine>> engines;
  engines.reserve(faults.size());
  for (const auto& [name, fault] : faults) engines.push_back(std::make_unique<Faulty>(name, fault));
  return engines;
}

}  // namespace
}  // namespace rockstack

int main() {
  // A sanitizer's own handler would turn the signal into an exit code.
  std::signal(SIGSEGV, SIG_DFL);
  return rockstack::serve(rockstack::make_faulty());
}
