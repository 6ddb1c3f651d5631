#include <fmt/format.h>

#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/interfaces/program/templates.hpp"
#include "comparisons/measures/results/files.hpp"

namespace rockstack {

int new_command(const NewArguments& arguments, const Common& common) {
  refuse_overrides(common, "a template is edited");
  std::error_code ignored;
  if (!arguments.out.empty() && std::filesystem::exists(arguments.out, ignored))
    throw InputError(fmt::format("--out {}: must be a new file, this one is there", arguments.out.string()));
  const auto folder = arguments.out.parent_path();
  const std::string text =
      template_text(arguments.kind, arguments.record, folder.empty() ? std::filesystem::path(".") : folder);
  if (arguments.out.empty()) {
    fmt::print("{}", text);
    return 0;
  }
  try {
    write_file(arguments.out, text);
  } catch (const std::runtime_error&) {
    throw InputError(fmt::format("--out {}: must be a file that can be written, in a folder that is there",
                                 arguments.out.string()));
  }
  if (!common.quiet) fmt::print("{}: {}\n", arguments.kind, arguments.out.string());
  return 0;
}

}  // namespace rockstack
