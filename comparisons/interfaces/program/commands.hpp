#pragma once

#include <CLI/CLI.hpp>

#include "comparisons/measures/results/table_form.hpp"
#include "comparisons/runs/compare.hpp"
#include "comparisons/suites/compare_choice.hpp"

namespace rockstack {

/// What every command takes.
struct Common {
  std::vector<std::string> overrides;  ///< key=value, of scenes
  bool quiet = false;                  ///< print nothing but errors
  bool json = false;                   ///< print the result as JSON
  TableForm table = TableForm::text;   ///< of tables on standard output
  bool replace = false;                ///< results of another scene in the folder for results
  std::string workers;                 ///< folders of more engines
  std::string command;                 ///< the whole command line, for the results
  char** words = nullptr;              ///< of the command line, as execv() takes them

  /// Whether tables are printed; in a form for documents they are all that is.
  bool prints_tables() const { return !quiet && !json; }
  /// Whether sentences are printed, and tables as text.
  bool prints_text() const { return prints_tables() && table == TableForm::text; }
  /// Whether what has no table as text prints one.
  bool prints_documents() const { return prints_tables() && table != TableForm::text; }
};

/// A subcommand: its name, what it does, and how it gets its options. `add` returns what runs once they are
/// read, whose result is the program's exit code: 0, or 1 where a run failed. Bad input is thrown as
/// InputError. Scenes, suites and ensembles are files, or names that `list` shows.
struct Command {
  const char *name, *words;
  std::function<std::function<int()>(CLI::App& app, const Common& common)> add;
  bool has_tables = false;  ///< whether it prints some, which --table gives a form
};

/// A command with arguments of its own, which `add_options` has filled from the command line before `run`.
template <class Arguments>
Command make_command(const char* name, const char* words, void (*add_options)(CLI::App&, Arguments&),
                     int (*run)(const Arguments&, const Common&)) {
  return {name, words, [=](CLI::App& app, const Common& common) {
            const auto arguments = std::make_shared<Arguments>();
            add_options(app, *arguments);
            return [=, &common] { return run(*arguments, common); };
          }};
}

/// A command that prints tables too.
inline Command with_tables(Command command) {
  command.has_tables = true;
  return command;
}

// What several commands share.

/// All solvers of an engine: of a worker program named by its path, or of a name that `list engines` shows;
/// or one, named with its solver. @throws InputError as find_engine().
std::vector<const WorkerEngine*> engines_named(const std::string& name);

/// Engines of several names; where there is none, those of `otherwise`.
std::vector<const WorkerEngine*> engines_named(const std::vector<std::string>& names,
                                               EngineList (*otherwise)());

/// @throws InputError, with the command that takes it, where a file is none of those kinds; `wanted`: what it
/// must be.
void require_kind(const std::string& input, const std::filesystem::path& file, const char* wanted,
                  const std::vector<InputKind>& kinds);

/// @throws InputError also where the input names a suite or an ensemble.
NamedScene read_one_scene(const std::string& input, const Common& common);

/// What results of an input say they are of: its name, without folder and ending.
std::string subject_of(const std::filesystem::path& input);

/// Says on standard error of which blocks the sizes seem to be in mm.
void warn_of_sizes(const Scene& scene, const Common& common);

/// @throws InputError with the reason where there are overrides.
void refuse_overrides(const Common& common, const char* reason);

/// The ranks that mpirun has started, or that many threads.
std::unique_ptr<Executor> make_executor(std::size_t threads);

// What the program says on standard output; progress goes to standard error, and only to a terminal.

/// Prints a result where it is wanted as JSON. Returns whether it is wanted in words.
bool print_json(const Json& result, const Common& common);

/// Prints lines of as many cells each, the first the heading.
void print_table(const std::vector<TableCells>& lines, TableForm form);

/// Prints flat rows with the same keys as a table, numbers to four digits, and an empty line.
void print_table(const Json& rows, TableForm form);

/// A table whose lines are printed as they come, where any is printed; its end with it.
class PrintedTable {
 public:
  PrintedTable(std::vector<TableColumn> columns, const Common& common);
  ~PrintedTable();
  PrintedTable(const PrintedTable&) = delete;
  PrintedTable& operator=(const PrintedTable&) = delete;

  void print(const TableCells& cells) const;

 private:
  std::vector<TableColumn> columns_;
  const Common& common_;
};

/// A word as a shell reads it back.
std::string shell_word(const std::string& word);

/// Whether there is a terminal to show it on, and somebody who wants it.
bool shows_progress(const Common& common);

/// A time to be waited for, in the largest unit that fits.
std::string waiting_time(double seconds);

/// A line that counts runs, names the one that is made and says how long the rest may take.
std::function<void(const Progress&)> progress(const Common& common);

/// Takes that line away, so that something else can be printed there.
void clear_progress(const Common& common);

/// Says on standard error how many runs failed, which file says why, and why the first did. Returns the exit
/// code.
int exit_code(std::size_t failed, std::size_t runs, const char* file, const std::string& reason);

/// Where figures and report are.
void print_report(const std::filesystem::path& folder, const Common& common);

/// Draws the figures and the report of a folder, as far as this build can, and says where they are.
void show_report(const std::filesystem::path& folder, const Common& common);

// The table of a comparison on standard output; nothing where it is not wanted.

/// What the columns mean, and how many runs there will be.
void print_legend(const std::vector<Suite>& suites, const Common& common);

/// Has rows printed as they are told. `common` must outlive the options.
void print_rows(const std::vector<Suite>& suites, const Common& common, CompareOptions& options);

/// Prints all rows as one table of a document, with the nearest sets marked.
void print_rows(const std::vector<RunMetrics>& rows, TableForm form);

// Options of several commands.

inline constexpr const char* scene_help = "scene file, or a name from `rockstack list scenes`";

/// One of some words; of what is none of them the nearest is named.
CLI::Validator one_of(const std::vector<std::string>& words);

/// The folder for results where none is given.
std::filesystem::path default_results(const std::string& command, const std::filesystem::path& input);

/// The folder for results; where none is given, its name is of the command and its input. `more`: what else
/// there is to say of it.
void add_results(CLI::App& command, std::filesystem::path& out, std::function<std::string()> input,
                 const char* more = "");

void add_plots(CLI::App& command, bool& plots);

/// Parameter sets of engines.
void add_settings(CLI::App& command, std::vector<std::string>& settings);

}  // namespace rockstack
