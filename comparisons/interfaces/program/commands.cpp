#include "comparisons/interfaces/program/commands.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cctype>
#include <cstdio>

#include "comparisons/measures/metrics/sizes.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/tables.hpp"
#include "comparisons/suites/shipped.hpp"
#ifdef ROCKSTACK_WITH_PLOTS
#include "plots/pages/show.hpp"
#endif

namespace rockstack {

bool shows_progress(const Common& common) {
  return !common.quiet && isatty(STDERR_FILENO) != 0;
}

std::string waiting_time(double seconds) {
  if (seconds < 60) return fmt::format("{:.0f} s", seconds);
  if (seconds < 3600) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

std::vector<const WorkerEngine*> engines_named(const std::string& name) {
  std::vector<const WorkerEngine*> list = chosen_engines(name);
  if (name.find_first_of(":/") != std::string::npos) return list;
  return mapped(engines_called(list.front()->name), [](const WorkerEngine& engine) { return &engine; });
}

std::vector<const WorkerEngine*> engines_named(const std::vector<std::string>& names,
                                               EngineList (*otherwise)()) {
  std::vector<const WorkerEngine*> list;
  for (const std::string& name : names)
    for (const WorkerEngine* engine : engines_named(name)) list.push_back(engine);
  if (names.empty())
    for (const WorkerEngine& engine : otherwise()) list.push_back(&engine);
  return list;
}

void require_kind(const std::string& input, const std::filesystem::path& file, const char* wanted,
                  const std::vector<InputKind>& kinds) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return;
  const InputKind kind = kind_of(file);
  if (std::ranges::find(kinds, kind) != kinds.end()) return;
  throw InputError(fmt::format("{}: must be {}, this is {} takes", input, wanted,
                               kind == InputKind::scene      ? "a scene, which `rockstack solve`"
                               : kind == InputKind::ensemble ? "an ensemble, which `rockstack sweep`"
                                                             : "a suite, which `rockstack compare`"));
}

NamedScene read_one_scene(const std::string& input, const Common& common) {
  const auto file = input_file(input, {"scenes"});
  require_kind(input, file, "a scene", {InputKind::scene});
  return read_named_scene(file, common.overrides);
}

std::string subject_of(const std::filesystem::path& input) {
  return folder_name(input.stem().string());
}

void warn_of_sizes(const Scene& scene, const Common& common) {
  if (common.quiet) return;
  for (const std::string& warning : size_warnings(scene)) fmt::print(stderr, "warning: {}\n", warning);
}

void refuse_overrides(const Common& common, const char* reason) {
  if (!common.overrides.empty())
    throw InputError(fmt::format("--set {}: must be left out, {}", common.overrides.front(), reason));
}

bool print_json(const Json& result, const Common& common) {
  if (common.json) fmt::print("{}\n", result.dump(2));
  return common.prints_text();
}

void print_table(const std::vector<TableCells>& lines, TableForm form) {
  fmt::print("{}", table_text(lines, form));
}

void print_table(const Json& rows, TableForm form) {
  std::vector<TableCells> lines(1);
  for (const auto& [name, cell] : rows.front().items()) lines.front().push_back(name);
  for (const Json& row : rows) {
    lines.emplace_back();
    for (const Json& cell : row)
      lines.back().push_back(cell.is_number_float() ? fmt::format("{:.4g}", cell.get<double>())
                                                    : cell_text(cell));
  }
  print_table(lines, form);
  fmt::print("\n");
}

PrintedTable::PrintedTable(std::vector<TableColumn> columns, const Common& common)
    : columns_(std::move(columns)), common_(common) {
  if (!common_.prints_tables()) return;
  fmt::print("{}", table_head(columns_, common_.table));
  std::fflush(stdout);
}

PrintedTable::~PrintedTable() {
  if (common_.prints_tables()) std::fputs(table_foot(common_.table).c_str(), stdout);
}

void PrintedTable::print(const TableCells& cells) const {
  clear_progress(common_);
  if (!common_.prints_tables()) return;
  fmt::print("{}", table_line(columns_, cells, common_.table));
  std::fflush(stdout);
}

std::string shell_word(const std::string& word) {
  const auto plain = [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 || (letter & 0x80) != 0 ||
           std::string_view("-_./=:+,@%").find(letter) != std::string_view::npos;
  };
  if (!word.empty() && std::ranges::all_of(word, plain)) return word;
  std::string quoted = "'";
  for (const char letter : word) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
}

std::function<void(const Progress&)> progress(const Common& common) {
  if (!shows_progress(common)) return [](const Progress&) {};
  return [](const Progress& now) {
    const std::string remaining =
        now.remaining && now.done < now.total ? ", about " + waiting_time(*now.remaining) + " to go" : "";
    const std::string run = now.running.empty() ? now.last : "running " + now.running;
    fmt::print(stderr, "\r\033[K[{}/{}{}] {}{}", now.done, now.total, remaining, run,
               now.done == now.total ? "\n" : "");
    std::fflush(stderr);
  };
}

void clear_progress(const Common& common) {
  if (shows_progress(common)) fmt::print(stderr, "\r\033[K");
}

int exit_code(std::size_t failed, std::size_t runs, const char* file, const std::string& reason) {
  if (failed > 0)
    fmt::print(stderr, "rockstack: {} of {} runs failed, {} says why; the first: {}\n", failed, runs, file,
               reason);
  return failed > 0 ? 1 : 0;
}

void print_report(const std::filesystem::path& folder, const Common& common) {
  if (!common.prints_text()) return;
#ifdef ROCKSTACK_WITH_PLOTS
  fmt::print("report: {}\n", one_line((folder / "report.html").string()));
#else
  fmt::print("left out of this build: figures and the report in {}\n", one_line(folder.string()));
#endif
}

void show_report(const std::filesystem::path& folder, const Common& common) {
#ifdef ROCKSTACK_WITH_PLOTS
  plots::show(folder);
#endif
  print_report(folder, common);
}

}  // namespace rockstack
