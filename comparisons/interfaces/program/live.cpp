#include "comparisons/interfaces/program/live.hpp"

namespace rockstack {
namespace {

void add_live(CLI::App& command, LiveArguments& arguments) {
  command
      .add_option("input", arguments.input,
                  "scene file, name of a scene or lesson, folder of `rockstack teach`, or a link of a page")
      ->capture_default_str();
  command.add_option("--record", arguments.records, "record that the page may choose; may be repeated")
      ->allow_extra_args(false);
  command.add_option("--port", arguments.port, "of 127.0.0.1; left out: any that is free")
      ->check(CLI::Range(1, 65535));
  command.add_flag_callback(
      "--no-browser", [&] { arguments.browser = false; }, "print the address alone");
}

}  // namespace

Command live_command() {
  return make_command("live",
                      "serve a page on this machine with sliders, on which solver and engines answer at once",
                      add_live, serve_live);
}

}  // namespace rockstack
