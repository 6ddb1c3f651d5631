#include "comparisons/studies/round/study.hpp"

namespace rockstack {
namespace {

constexpr KeyRange tilts{"≥ 0, below the toppling angle", 0};

/// A ground motion, with accelerations alone.
GroundMotion read_motion(const Node& ground, const char* axis, double scale, const SceneDocument& document,
                         MotionLibrary& library) {
  const Node* table = find(ground, axis);
  if (table == nullptr) return {};
  if (const Node* steps = find(*table, "velocity_steps"))
    throw wrong_value(*steps, "left out: a round column has accelerations alone");
  GroundMotion motion = read_ground_motion(*table, document.folder, library);
  for (double& sample : motion.samples) sample *= scale;
  if (motion.pulse) motion.pulse->amplitude *= scale;
  validate(motion, table->key);
  return motion;
}

void require_start(const RoundScene& scene) {
  const double most = toppling_angle(planar_scene(scene, 0), 0);
  if (!(scene.tilt < most))
    throw FieldError("initial.tilt", scene.tilt, "below " + number_text(most) + ", the toppling angle");
  if (scene.tilt == 0)
    for (const auto& [key, rate] : {std::pair("tilt_rate", scene.tilt_rate),
                                    {"precession", scene.precession},
                                    {"spin", scene.spin},
                                    {"motion", scene.steady ? 1.0 : 0.0}})
      if (rate != 0)
        throw FieldError(std::string("initial.") + key, rate,
                         "left out where there is no tilt: the column stands");
  if (!scene.steady) return;
  if (scene.tilt_rate != 0 || scene.precession != 0 || scene.spin != 0)
    throw FieldError("initial.motion", "\"steady\"", "left out beside tilt_rate, precession or spin");
  if (!steady_precession(scene.body(), scene.tilt))
    throw FieldError("initial.motion", "\"steady\"", "left out past balance, where no precession is steady");
}

}  // namespace

const KeysOf<RoundScene> round_keys{
    "",
    "a round column, for `rockstack round`: a uniform cylinder that rolls on its rim without slip",
    {{"title", "\"A drum\"", "", "a text", "the name of the file", "heads tables and figures",
      &RoundScene::title},
     {"duration", "10.0", "s", KeyRange{"> 0, up to 10⁴", 1 / largest_number, 1e4}, required_key,
      "of the motion", &RoundScene::duration},
     {"gravity", "9.81", "m/s²", above_zero, "acceleration of gravity, downwards", &RoundScene::gravity},
     {"radius", "0.25", "m", above_zero, required_key, "of the base", &RoundScene::radius},
     {"height", "2.0", "m", above_zero, required_key, "of the column", &RoundScene::height},
     {"equations",
      "\"angles\"",
      {{"angles"}, {"axis", "no angles"}},
      "which of two derivations is solved",
      &RoundScene::equations},
     {"room",
      "\"space\"",
      {{"space"}, {"plane", "that of x and z, with Housner's impacts"}},
      "where the column moves",
      &RoundScene::room},
     {"initial", "", "", "a table [initial]", no_default, "how it starts"},
     {"ground", "", "", "tables [ground.x], [ground.y], [ground.z]", no_default, "how the ground moves"}}};

const KeysOf<RoundScene> round_initial_keys{
    "[initial]",
    "the state of a round column at t = 0; without tilt it stands",
    {{"tilt", "0.1", "rad", tilts, "of the axis from the vertical, towards x", &RoundScene::tilt},
     {"tilt_rate", "0.0", "rad/s", any_number, "of the tilt", &RoundScene::tilt_rate},
     {"precession", "0.2", "rad/s", any_number, "of the direction of tilt, counterclockwise from above",
      &RoundScene::precession},
     {"spin", "0.0", "rad/s", any_number, "of the column, along its axis", &RoundScene::spin},
     {{"motion", "\"steady\"", "", "\"steady\", beside tilt alone", no_default,
       "precession and spin are those of a centre of mass at rest"},
      [](const Node& node, RoundScene& scene) {
        scene.steady = choice<bool>(node, {"free", "steady"});
      }}}};

const KeysOf<RoundScene> round_ground_keys{
    "[ground]",
    "how the ground under a round column moves: tables x, y and z, each as [ground.horizontal] of a scene",
    {{"scale", "1.0", "", any_number, "multiplies all of it", &RoundScene::scale},
     {"x", "", "", "a table [ground.x]", no_default, "in the direction of the tilt"},
     {"y", "", "", "a table [ground.y]", no_default, "sideways, counterclockwise from above"},
     {"z", "", "", "a table [ground.z]", no_default, "upwards"}}};

RoundScene make_round(const SceneDocument& document, MotionLibrary& library) {
  RoundScene scene;
  try {
    scene.title = document.title;
    read_members(document.root, round_keys, scene);
    require_ranges("", round_keys, scene);
    if (const Node* initial = find(document.root, "initial"))
      read_members(*initial, round_initial_keys, scene);
    require_ranges("initial.", round_initial_keys, scene);
    require_start(scene);
    if (const Node* ground = find(document.root, "ground")) {
      read_members(*ground, round_ground_keys, scene);
      require_ranges("ground.", round_ground_keys, scene);
      scene.x = read_motion(*ground, "x", scene.scale, document, library);
      scene.y = read_motion(*ground, "y", scene.scale, document, library);
      scene.z = read_motion(*ground, "z", scene.scale, document, library);
    }
  } catch (const FieldError& error) {
    throw InputError(nearest(document.root, error.key).place + ": " + error.what());
  }
  return scene;
}

}  // namespace rockstack
