#include <fcntl.h>
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <new>

#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/results/build.hpp"

namespace rockstack {

using MakeCommand = Command();
#include "comparisons/interfaces/program/command_functions.inc"

}  // namespace rockstack

namespace {

using namespace rockstack;

/// In the order of `rockstack --help`.
constexpr MakeCommand* commands[]{
#include "comparisons/interfaces/program/command_list.inc"
};

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

/// What a command needs and was not given, all of it.
std::string missing(const CLI::App& command) {
  std::string names;
  for (const CLI::Option* option : command.get_options())
    if (option->get_required() && option->count() == 0)
      names += (names.empty() ? "" : ", ") + option->get_name();
  return fmt::format("{}: {}: missing", command.get_name(), names);
}

std::vector<std::string> command_names(const CLI::App& app) {
  return mapped(app.get_subcommands({}), &CLI::App::get_name);
}

/// The first word that nobody expected, and what it may have been meant for.
void refuse_unexpected(const CLI::App& app) {
  const std::vector<std::string> words = app.remaining(true);
  if (words.empty()) return;
  std::vector<std::string> names;
  for (const CLI::App* given : app.get_subcommands())
    for (const CLI::App* owner : {&app, given})
      for (const CLI::Option* option : owner->get_options()) names.push_back(option->get_name());
  if (names.empty()) names = command_names(app);
  throw std::invalid_argument(words.front() + ": not expected" + did_you_mean(words.front(), names));
}

/// What was asked for of tables must be there to be given.
void check_table_form(const Common& common, const Command& command) {
  if (common.table == TableForm::text) return;
  const std::string given =
      fmt::format("--table {}", table_form_names[static_cast<std::size_t>(common.table)]);
  if (!command.has_tables)
    throw InputError(fmt::format("{}: must be left out of {}, which prints no table", given, command.name));
  for (const auto& [option, is_given] : {std::pair{"--json", common.json}, {"--quiet", common.quiet}})
    if (is_given) throw InputError(fmt::format("{}: must be left out beside {}", given, option));
}

int run(int count, char** arguments) {
  CLI::App app{"Stacked rocking blocks: the exact theory beside physics engines", "rockstack"};
  app.set_version_flag("--version", fmt::format("rockstack {}", build::version));
  app.require_subcommand(0, 1);
  app.fallthrough();
  Common common;
  common.command = command_line(count, arguments);
  common.words = arguments;
  const std::vector<const CLI::Option*> common_options{
      app.add_option("--set", common.overrides,
                     "override a scene key: key=value, e.g. blocks.1.height=3; may be repeated")
          ->allow_extra_args(false),
      app.add_flag("--quiet", common.quiet, "print nothing but errors"),
      app.add_flag("--json", common.json, "print the result as JSON"),
      app.add_option_function<std::string>(
             "--table", [&](const std::string& form) { common.table = named_table_form(form); },
             "form of tables on standard output: text; or md, Markdown, or tex, LaTeX, without all else")
          ->check(one_of({table_form_names.begin(), table_form_names.end()})),
      app.add_flag("--replace", common.replace,
                   "put the results in the place of those of another scene in the folder for results"),
      app.add_option("--workers", common.workers,
                     "folders of more engines, with ':' between them; left out: $ROCKSTACK_WORKERS")};
  std::map<const CLI::App*, std::pair<Command, std::function<int()>>> runs;
  for (const MakeCommand* make : commands) {
    const Command command = make();
    CLI::App* added = app.add_subcommand(command.name, command.words);
    runs[added] = {command, command.add(*added, common)};
  }
  for (CLI::App* command : app.get_subcommands({}))
    command->footer([&] { return CLI::Formatter().make_group("Common options", false, common_options); });
  try {
    app.parse(count, arguments);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::RequiredError&) {
    refuse_unexpected(app);
    throw std::invalid_argument(missing(*app.get_subcommands().front()));
  } catch (const CLI::ExtrasError&) {
    refuse_unexpected(app);
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
  if (const auto given = app.get_subcommands(); !given.empty()) {
    const auto& [command, start] = runs.at(given.front());
    check_table_form(common, command);
    return start();
  }
  throw std::invalid_argument(
      fmt::format("a command must be given, one of {}", fmt::join(command_names(app), " ")));
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
