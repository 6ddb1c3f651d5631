#pragma once

#include "analytic/scene/input/fields.hpp"

namespace rockstack {

// Every key of a suite file. A new one is a line here, and is read where the others of its table are.

inline const KeyTable suite_keys{
    "",
    "a suite: scenes, each on the exact solver and on engines",
    {{"title", "\"Three drums\"", "", "a text", required_key, "heads tables and the report"},
     {"scenes", "[\"scene.toml\"]", "",
      "at least one file beside the suite, or name from `rockstack list scenes`", required_key,
      "what is run"},
     {"set", "[\"duration=2.0\"]", "", "key=value texts", "[]", "scene keys that are changed in every scene"},
     {"vary", "{ \"contact.friction\" = [0.1, 1.0] }", "", "scene keys, each an array of numbers", "{}",
      "every scene once for each value, in every combination"},
     {"variants", "[\"linear\"]", "",
      "of \"linear\", \"nonlinear\", \"paper\", \"consistent\", \"unilateral\", \"friction=MU\"", "[]",
      "the exact solver with one choice changed, as one more run; friction is that of law unilateral"},
     {"tolerance", "0.01", "rad", "> 0", "0.01", "histories agree as long as angles stay that close"},
     {"repeats", "5", "", "a whole number from 1", "5", "timed runs after one to warm up"},
     {"results", "[\"angles\", \"impacts\"]", "",
      "of \"angles\", \"impacts\", \"patterns\", \"bodies\", \"histories\", \"forces\"", "all but \"forces\"",
      "what is computed and written"},
     {"softness", "\"split\"", "", "\"whole\" or \"split\", which needs \"bodies\" in `results`", "\"whole\"",
      "whether differences of engines are split into contact model, contact softness and time step"},
     {"time_limit", "600.0", "s", "> 0", "600", "of each run of an engine"},
     {"memory_limit", "4096", "MiB", "64 to 10⁹", "4096", "of each run of an engine"},
     {"engines", "", "", "tables [[engines]]", "none: exact runs alone",
      "what is compared with the exact solver"},
     {"trajectories", "", "", "tables [[trajectories]]", "none", "motions that other programs have written"},
     {"draws", "", "", "a table [draws]", no_default, "runs behind each number of an engine"},
     {"perturbations", "", "", "a table [perturbations]", no_default, "distributions where histories part"},
     {"statements", "", "", "a table [statements]", no_default, "scenes held against the paper"}}};

inline const KeyTable engine_keys{
    "[[engines]]",
    "an engine and how it runs: one series for each parameter set and value",
    {{"name", "\"ode\"", "", "ENGINE or ENGINE:SOLVER, see `rockstack list engines`", required_key,
      "of the engine; beside `worker`, one of its engines, its first if left out"},
     {"worker", "\"./my_engine.py\"", "", "a program, seen from the file's folder",
      "instead of `name`, or beside it", "an engine's own worker, see engines/README.md"},
     {"settings", "[\"tuned\"]", "", "of \"default\", \"tuned\"", "[\"default\", \"tuned\"]",
      "its parameter sets"},
     {"dt", "[1e-3]", "s", "at least one number > 0", "[1e-2, 1e-3, 1e-4]", "time steps"},
     {"parameters", "{ erp = [0.1, 0.2] }", "", "names of the engine's parameters, each a value or an array",
      "{}", "changes of its parameter set, in every combination"}}};

inline const KeyTable trajectory_keys{
    "[[trajectories]]",
    "a motion of a scene that another program has written, beside the engines",
    {{"name", "\"isaac\"", "", "letters, digits, - and _, no engine's name", required_key,
      "that its rows go by"},
     {"files", "[\"isaac.csv\"]", "", "at least one CSV file, seen from the suite's folder", required_key,
      "a run each, see comparisons/README.md; several are replicates"},
     {"scene", "\"scene\"", "", "the name of a scene of the suite", "its only scene", "of which it is"}}};

inline const KeyTable replicates_keys{
    "[draws]",
    "runs behind each number of an engine, which is their median",
    {{"runs", "5", "", "a whole number from 1 to 10000", required_key,
      "with the one at the nominal step and scene"},
     {"most_steps", "3e5", "", "a number > 0", "any number",
      "that these runs may take together: fewer are made where steps are many, one at least"},
     {"steps", "0.03", "", "0 to 0.5", "0.03", "largest relative change of the time step"},
     {"scene", "1e-6", "", "0 to 0.1", "1e-6", "largest relative change of the scene"},
     {"seed", "1", "", "a whole number from 0 to 2⁵³", "1", "of the changes of the scene"}}};

inline const KeyTable perturbations_keys{
    "[perturbations]",
    "many scenes that hardly differ, for distributions",
    {{"runs", "20", "", "a whole number from 2", required_key, "number of scenes"},
     {"size", "1e-6", "", "> 0, up to 0.1", "1e-6", "largest relative change"},
     {"seed", "1", "", "a whole number from 0 to 2⁵³", "1", "of the changes"}}};

inline const KeyTable statements_keys{
    "[statements]",
    "the paper's two examples among the scenes, each of two blocks",
    {{"free", "\"scene\"", "", "the name of a scene of the suite", required_key, "of Figs. 18 to 20"},
     {"shaken", "\"scene\"", "", "the name of a scene of the suite", required_key, "of Figs. 21 and 22"}}};

/// All tables of a suite file, in the order of a file.
inline constexpr std::initializer_list<const KeyTable*> suite_tables{
    &suite_keys, &engine_keys, &trajectory_keys, &replicates_keys, &perturbations_keys, &statements_keys};

}  // namespace rockstack
