#include <fcntl.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <new>

#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/results/build.hpp"

namespace {

using namespace rockstack;

/// Results are written in it.
void require_utf8(const std::string& word) {
  try {
    nlohmann::json(word).dump();
  } catch (const nlohmann::json::type_error&) {
    throw std::invalid_argument(fmt::format("{}: must be text in UTF-8", one_line(word)));
  }
}

std::string command_line(int count, char** arguments) {
  std::string line = "rockstack";
  for (int i = 1; i < count; ++i) {
    require_utf8(arguments[i]);
    line += " " + shell_word(arguments[i]);
  }
  return line;
}

/// Figures are drawn there after hours of computing: what is wrong with it is told before.
void require_temporary_folder() {
  std::error_code error;
  static_cast<void>(std::filesystem::temp_directory_path(error));
  if (error) throw InputError(fmt::format("TMPDIR = {}: must be a folder", std::getenv("TMPDIR")));
}

/// The command that is given, or none.
const Command* parsed(const std::vector<Command>& commands) {
  for (const Command& command : commands)
    if (command.app->parsed()) return &command;
  return nullptr;
}

/// What a command needs and was not given, all of it.
std::string missing(const Command& command) {
  std::string names;
  for (const CLI::Option* option : command.app->get_options())
    if (option->get_required() && option->count() == 0)
      names += (names.empty() ? "" : ", ") + option->get_name();
  return fmt::format("{}: {}: missing", command.app->get_name(), names);
}

/// The first word that nobody expected, and what it may have been meant for.
void refuse_unexpected(const CLI::App& app, const Command* given) {
  const std::vector<std::string> words = app.remaining(true);
  if (words.empty()) return;
  std::vector<std::string> names;
  if (given == nullptr) {
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  } else {
    for (const CLI::App* owner : std::initializer_list<const CLI::App*>{&app, given->app})
      for (const CLI::Option* option : owner->get_options()) names.push_back(option->get_name());
  }
  throw std::invalid_argument(words.front() + ": not expected" + did_you_mean(words.front(), names));
}

int run(int count, char** arguments) {
  CLI::App app{"Stacked rocking blocks: the exact theory beside physics engines", "rockstack"};
  app.set_version_flag("--version", fmt::format("rockstack {}", build::version));
  app.require_subcommand(0, 1);
  app.fallthrough();
  Common common;
  common.command = command_line(count, arguments);
  const std::vector<const CLI::Option*> common_options{
      app.add_option("--set", common.overrides,
                     "override a scene key: key=value, e.g. blocks.1.height=3; may be repeated")
          ->allow_extra_args(false),
      app.add_flag("--quiet", common.quiet, "print nothing but errors"),
      app.add_flag("--json", common.json, "print the result as JSON"),
      app.add_option("--workers", common.workers,
                     "folders of more engines, with ':' between them; left out: $ROCKSTACK_WORKERS")};
  const std::vector<Command> commands = add_commands(app, common);
  for (const Command& command : commands)
    command.app->footer(CLI::Formatter().make_group("Common options", false, common_options));
  try {
    app.parse(count, arguments);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::RequiredError&) {
    refuse_unexpected(app, parsed(commands));
    throw std::invalid_argument(missing(*parsed(commands)));
  } catch (const CLI::ExtrasError&) {
    refuse_unexpected(app, parsed(commands));
    throw;
  } catch (const CLI::ConversionError& error) {
    const std::string text = error.what();
    throw std::invalid_argument(text.substr(text.find(':') + 2) + ": must be a number");
  } catch (const CLI::ParseError& error) {
    throw std::invalid_argument(error.what());
  }
  require_folders("--workers", common.workers);
  if (!common.workers.empty()) setenv(workers_variable, common.workers.c_str(), 1);
  require_temporary_folder();
  if (const Command* given = parsed(commands)) return given->run();
  std::string names;
  for (const Command& command : commands) names += " " + command.app->get_name();
  throw std::invalid_argument("a command must be given, one of" + names);
}

/// Where a standard stream is closed, the first file that is opened would take its number and get its text. A
/// result that cannot be printed stays an error, a complaint that nobody wants does not.
void open_standard_streams() {
  for (const auto& [stream, mode] : {std::pair{0, O_WRONLY}, {1, O_RDONLY}, {2, O_WRONLY}})
    if (fcntl(stream, F_GETFD) < 0) open("/dev/null", mode);
}

/// One line, whatever the names in it hold.
void complain(const char* reason) {
  std::fputs(("rockstack: " + one_line(reason) + "\n").c_str(), stderr);
}

}  // namespace

int main(int count, char** arguments) {
  open_standard_streams();
  try {
    const int code = run(count, arguments);
    // What a stream could not take before is known to it alone.
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
      throw std::runtime_error("standard output: cannot be written");
    return code;
  } catch (const std::invalid_argument& error) {
    complain(error.what());
    return 2;
  } catch (const std::bad_alloc&) {
    complain("more memory was asked for than there is");
    return 1;
  } catch (const std::exception& error) {
    complain(error.what());
    const auto* file = dynamic_cast<const std::filesystem::filesystem_error*>(&error);
    return file != nullptr && file->code() == std::errc::permission_denied ? 2 : 1;
  }
}
