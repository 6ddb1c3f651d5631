#include <fmt/format.h>

#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/results/files.hpp"
#include "engines/formats/formats.hpp"
#include "engines/scene_setup.hpp"

namespace rockstack {
namespace {

struct ExportArguments {
  std::string scene, format;
  std::filesystem::path out;  ///< empty: standard output
  double dt = 1e-3;           ///< s
};

/// @throws InputError where it cannot be written.
void write_new(const std::filesystem::path& file, const std::string& text) {
  try {
    write_file(file, text);
  } catch (const std::runtime_error&) {
    throw InputError(fmt::format("--out {}: must be a file that can be written, in a folder that is there",
                                 file.string()));
  }
}

/// @throws InputError for what no engine has.
ModelScene model_of(const NamedScene& scene, double dt, const std::filesystem::path& file) {
  try {
    return model_scene(scene.scene, scene.name, dt, file.string());
  } catch (const std::runtime_error& error) {
    throw InputError(error.what());
  }
}

int run_export(const ExportArguments& arguments, const Common& common) {
  require_above_zero("--dt", arguments.dt);
  const NamedScene scene = read_one_scene(arguments.scene, common);
  check_step(arguments.dt, scene.scene.duration);
  const std::filesystem::path file =
      arguments.out.empty() ? std::filesystem::path(scene.name + "." + arguments.format) : arguments.out;
  const ModelScene model = model_of(scene, arguments.dt, file);
  const ModelFile made = arguments.format == "mjcf"  ? mjcf_of(model)
                         : arguments.format == "sdf" ? sdf_of(model)
                                                     : urdf_of(model);
  if (arguments.out.empty()) {
    fmt::print("{}", made.text);
  } else {
    // The table first: a file that names it is never without it.
    if (!model.table.empty()) write_new(file.parent_path() / model.table, ground_table(model));
    write_new(file, made.text);
  }
  if (!common.quiet && !made.left_out.empty())
    fmt::print(stderr, "rockstack: not in the file: {}{}\n", fmt::join(made.left_out, "; "),
               model.table.empty() ? ""
               : arguments.out.empty()
                   ? "; --out FILE writes its motion into a table beside it"
                   : fmt::format("; {} has it", one_line((file.parent_path() / model.table).string())));
  return 0;
}

void add_export(CLI::App& command, ExportArguments& arguments) {
  command.add_option("scene", arguments.scene, scene_help)->required();
  command
      .add_option("--format", arguments.format,
                  "mjcf: MuJoCo; sdf: Gazebo, Drake; urdf: links on planar joints")
      ->required()
      ->check(one_of({"mjcf", "sdf", "urdf"}));
  command.add_option("--dt", arguments.dt, "time step, s")->capture_default_str();
  command.add_option("--out", arguments.out, "file to write; left out: standard output");
}

}  // namespace

Command export_command() {
  return make_command("export", "write a scene for another simulator", add_export, run_export);
}

}  // namespace rockstack
