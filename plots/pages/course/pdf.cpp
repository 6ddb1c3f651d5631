#include "plots/pages/show.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <stdexcept>
#include <string>
#include <vector>

#include "analytic/scene/messages/input_error.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

/// A folder that goes with everything in it.
class Scratch {
 public:
  explicit Scratch(const fs::path& beside) : path_((beside / ".printing-XXXXXX").string()) {
    if (mkdtemp(path_.data()) == nullptr)
      throw std::runtime_error(fmt::format("{}: no folder can be made", beside.string()));
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  fs::path path() const { return path_; }

 private:
  std::string path_;
};

/// Runs a program that is looked for on the path, without its output. Returns its exit code.
/// @throws InputError where it is not there.
int run(std::vector<std::string> words) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t silent;
  posix_spawn_file_actions_init(&silent);
  for (const int output : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&silent, output, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int failure = posix_spawnp(&child, arguments[0], &silent, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&silent);
  if (failure == ENOENT)
    throw InputError("--pdf: must be asked where the program chromium is; slides.html is written");
  int status = -1;
  if (failure != 0 || waitpid(child, &status, 0) != child)
    throw std::runtime_error("chromium: cannot be run");
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

void print_pdf(const fs::path& page, const fs::path& pdf) {
  const Scratch scratch(pdf.parent_path().empty() ? fs::path(".") : pdf.parent_path());
  const fs::path made = fs::absolute(scratch.path() / "slides.pdf");
  std::vector<std::string> words{
      "chromium",
      "--headless",
      "--disable-gpu",
      "--no-first-run",
      "--disable-quic",
      "--disable-background-networking",
      "--disable-component-update",
      "--disable-sync",
      "--no-pdf-header-footer",
      "--window-size=1280,768",
      "--virtual-time-budget=20000",
      fmt::format("--user-data-dir={}", fs::absolute(scratch.path() / "profile").string()),
      fmt::format("--print-to-pdf={}", made.string())};
  if (geteuid() == 0) words.emplace_back("--no-sandbox");  // which it does not have for root
  words.push_back(fs::absolute(page).string());
  const int code = run(words);
  if (code != 0 || !fs::exists(made))
    throw std::runtime_error(fmt::format("chromium: printing {} ended with {}", page.string(), code));
  fs::rename(made, pdf);
}

}  // namespace rockstack::plots
