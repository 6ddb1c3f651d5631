#include <fmt/format.h>
#include <malloc.h>
#include <spawn.h>
#include <unistd.h>

#include <cstdlib>
#include <tuple>

#include "analytic/scene/input/toml_reader.hpp"
#include "comparisons/interfaces/live/requests.hpp"
#include "comparisons/interfaces/program/live.hpp"
#include "comparisons/interfaces/program/record_limits.hpp"
#include "comparisons/studies/lessons/lesson.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
namespace {

/// The scene of a lesson's suite.
std::filesystem::path lesson_scene(const std::string& name) {
  const std::filesystem::path suite = find_file(name, "studies/lessons");
  const Node root = read_toml(suite);
  return find_file(nearest(root, "scenes.1").text, "scenes", suite.parent_path());
}

live::PageStart start_of(const LiveArguments& arguments, Common common) {
  live::PageStart start;
  if (!arguments.records.empty()) start.limits = take_record_limits(common);
  start.overrides = common.overrides;
  if (const EngineList usual = usual_engines(); !usual.empty()) start.engine = usual.front().get().name;
  start.records = arguments.records;
  for (const Lesson& lesson : lessons()) start.lessons[lesson.name] = lesson_scene(lesson.name);
  const std::filesystem::path folder = arguments.input;
  if (std::filesystem::exists(folder / "course.json") || std::filesystem::exists(folder / "lesson.json")) {
    start.course = folder;
    start.scene = find_file(LiveArguments().input, "scenes");
  } else if (const auto lesson = start.lessons.find(arguments.input); lesson != start.lessons.end()) {
    std::tie(start.lesson, start.scene) = *lesson;
  } else {
    read_one_scene(arguments.input, common);
    start.scene = find_file(arguments.input, "scenes");
  }
  return start;
}

/// Memory of answers goes back at once, in the place of being kept for each of the server's threads.
void keep_little_memory() {
#ifdef __GLIBC__
  constexpr int arenas = 2, returned_at_once = 128 * 1024;  // bytes
  mallopt(M_ARENA_MAX, arenas);
  mallopt(M_MMAP_THRESHOLD, returned_at_once);
#endif
}

/// Where there is a screen and somebody in front of it.
void open_browser(const std::string& address) {
  const bool screen = std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
  if (!screen || isatty(STDOUT_FILENO) == 0) return;
  std::string program = "xdg-open", argument = address;
  char* const words[] = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  posix_spawnp(&child, program.c_str(), nullptr, nullptr, words, environ);  // else the address is printed
}

void print_address(const std::string& address, const Common& common) {
  if (common.json) {
    fmt::print("{}\n", Json{{"address", address}}.dump());
  } else {
    fmt::print("live: {}\n", address);
    if (!common.quiet)
      fmt::print("The page is for this machine alone, and ends with this program: Ctrl-C.\n");
  }
  std::fflush(stdout);
}

}  // namespace

int serve_live(const LiveArguments& arguments, const Common& common) {
  keep_little_memory();
  LiveArguments asked = arguments;
  std::string fragment;
  // A link that was copied from a page has all of its state after the sign.
  if (const auto sign = asked.input.find('#'); sign != std::string::npos) {
    fragment = asked.input.substr(sign);
    asked.input = LiveArguments().input;
  }
  live::serve(live::make_live_page(start_of(asked, common)), asked.port, [&](const std::string& here) {
    const std::string address = here + fragment;
    print_address(address, common);
    if (asked.browser) open_browser(address);
  });
  return 0;
}

}  // namespace rockstack
