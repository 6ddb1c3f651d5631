#include "comparisons/interfaces/live/live_state.hpp"

#include <fmt/format.h>

#include "analytic/scene/input/page_scene.hpp"
#include "analytic/scene/input/scene_file.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "engines/scene_setup.hpp"

namespace rockstack::live {
namespace {

const KeyTable state_keys{
    "",
    "what a page shows",
    {{"scene", "", "", "a scene", required_key, "with the keys of a scene file"},
     {"engine", "\"ode\"", "", "ENGINE or ENGINE:SOLVER", no_default, "beside the exact solver"},
     {"settings", "\"tuned\"", "", "\"default\" or \"tuned\"", "\"tuned\"", "its parameter set"},
     {"dt", "1e-3", "s", "> 0", "1e-3", "its time step"},
     {"parameters", "", "", "a table", no_default, "changes of its parameter set"},
     {"spread", "1e-3", "", "0 to 0.1", "0", "of the scenes of a cloud"}}};

/// No file is read that was not named at the start.
void require_named_records(const Node& scene, const std::set<std::string>& records) {
  for (const char* key : {"ground.horizontal.record", "ground.vertical.record"}) {
    const Node& record = nearest(scene, key);
    if (record.key == key && !records.contains(record.text))
      throw wrong_value(record, "a record that `rockstack live` was given, by --record or in a scene");
  }
}

Scene read_live_scene(const Node& scene, const std::set<std::string>& records, MotionLibrary& library) {
  // Refused before anything is made of it.
  if (const Node* blocks = find(scene, "blocks"); blocks != nullptr && blocks->children.size() > most_blocks)
    throw wrong_value(*blocks, fmt::format("at most {} blocks on a live page", most_blocks));
  require_named_records(scene, records);
  Scene made = make_scene({scene, {}, "Live scene"}, library);
  if (made.duration > longest_duration)
    throw wrong_value(required(scene, "duration", ""),
                      fmt::format("at most {} s on a live page", longest_duration));
  return made;
}

double read_step(const Node& root, double duration) {
  const Node* node = find(root, "dt");
  const double dt = node == nullptr ? 1e-3 : number_above_zero(*node);
  if (node != nullptr && duration / dt > most_steps)
    throw wrong_value(
        *node, fmt::format("at least {}: {} steps at most", number_text(duration / most_steps), most_steps));
  check_step(dt, duration);
  return dt;
}

EngineSeries read_series(const Node& root, double dt) {
  const Node* engine = find(root, "engine");
  if (engine == nullptr || text(*engine).empty()) return {};
  if (text(*engine).find('/') != std::string::npos)
    throw wrong_value(*engine, "a name from `rockstack list engines`");
  const Node* node = find(root, "settings");
  const std::string settings =
      node == nullptr ? "tuned" : choice<std::string>(*node, {{"default", "default"}, {"tuned", "tuned"}});
  Parameters changes;
  if (const Node* table = find(root, "parameters"))
    for (const Node& change : table->children) changes[change.name] = number(change);
  return make_series(find_engine(engine->text), settings, {dt}, changes);
}

}  // namespace

LiveState read_state(const Json& json, const std::set<std::string>& records, MotionLibrary& library) {
  const Node root = scene_document(json);
  require_table(root, state_keys);
  const Json scene = json.value("scene", Json());
  LiveState state;
  state.scene = read_live_scene(scene_document(scene), records, library);
  state.dt = read_step(root, state.scene.duration);
  state.series = read_series(root, state.dt);
  state.spread = number_or(root, "spread", 0);
  if (!(state.spread >= 0) || state.spread > widest_spread)
    throw wrong_value(*find(root, "spread"), fmt::format("0 to {}", widest_spread));
  return state;
}

std::size_t kept_stride(const LiveState& state) {
  const auto steps = static_cast<std::size_t>(std::ceil(state.scene.duration / state.dt));
  return std::max<std::size_t>(1, (steps + most_samples - 1) / most_samples);
}

std::string state_scene_text(const Json& json) {
  return "# Saved by `rockstack live`. SI units; `rockstack keys scene` explains every key.\n" +
         scene_text(json.at("scene"));
}

std::string state_suite_text(const Json& json, const LiveState& state, const std::string& name, int runs) {
  const auto is_plain = [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '-';
  };
  constexpr std::size_t longest = 60;
  if (name.empty() || name.size() > longest || !std::ranges::all_of(name, is_plain))
    throw InputError(fmt::format("the page: name = {}: must be 1 to {} letters, digits and dashes",
                                 rockstack::quoted(name), longest));
  std::string text = fmt::format(
      "# Saved by `rockstack live`, for `rockstack compare`. Its scene lies beside it.\n"
      "title = {}\nscenes = [\"{}.toml\"]\nrepeats = 1\n",
      toml_text(state.scene.title), name);
  if (state.series.engine != nullptr) {
    const WorkerEngine& engine = *state.series.engine;
    text += fmt::format("\n[[engines]]\nname = \"{}:{}\"\nsettings = [\"{}\"]\ndt = [{}]\n", engine.name,
                        engine.solver, json.value("settings", "tuned"), number_text(state.dt));
    const Json parameters = json.value("parameters", Json::object());
    std::string changes;
    for (const auto& [key, value] : parameters.items())
      changes += fmt::format("{}{} = {}", changes.empty() ? "" : ", ", toml_text(key), toml_value(value));
    if (!changes.empty()) text += fmt::format("parameters = {{ {} }}\n", changes);
  }
  if (runs > 1 && state.spread > 0)
    text += fmt::format("\n[perturbations]\nruns = {}\nsize = {}\n", runs, number_text(state.spread));
  return text;
}

}  // namespace rockstack::live
