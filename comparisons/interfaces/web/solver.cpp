// The exact solver for pages, compiled to WebAssembly: answer() takes a question of exact_answers.hpp and
// returns its answer. Of a question with "parameters" and "dt" it returns what an engine's worker would be
// asked. {"error"} has the reason why there is no answer.

#include <exception>

#include "analytic/scene/ground/records/record_file.hpp"
#include "analytic/scene/input/json_reader.hpp"
#include "analytic/scene/input/page_scene.hpp"
#include "analytic/scene/input/scene_file.hpp"
#include "comparisons/interfaces/live/exact_answers.hpp"
#include "engines/scene_setup.hpp"
#include "engines/worker/request.hpp"

namespace rockstack {

// A page reads no files: page_text() gives the samples of records.
std::filesystem::path record_file(const std::filesystem::path& name) {
  throw InputError(name.string() + ": must be given as samples on a page");
}
Record read_record(const std::filesystem::path& name, RecordLimits /*limits*/) {
  record_file(name);
  return {};
}
void check_usual(const std::string& /*file*/, const std::string& /*read_as*/, double /*interval*/,
                 const std::vector<double>& /*samples*/) {}

namespace {

std::string answer_to(const std::string& question) {
  const Json asked = parse_json(question, "the question ");
  if (!asked.contains("parameters")) return live::exact_answer(question);
  MotionLibrary library;
  const Scene scene = make_scene({scene_document(asked.at("scene")), {}, "A page's scene"}, library);
  RunRequest run;
  run.parameters = asked.at("parameters").get<Parameters>();
  run.setup = set_up(scene, asked.at("dt"), run.parameters);
  return to_bytes(Request{run}, Form::json);
}

}  // namespace
}  // namespace rockstack

extern "C" const char* answer(const char* question) {
  static std::string text;
  try {
    text = rockstack::answer_to(question);
  } catch (const std::exception& error) {
    text = rockstack::Json{{"error", error.what()}}.dump();
  }
  return text.c_str();
}
