#pragma once

#include "analytic/scene/ground/synthetic.hpp"
#include "analytic/scene/input/key.hpp"

namespace rockstack {

// Every key of a scene file. One that is a number of a scene is a line here and a member there; others are
// read where the rest of their table is.

/// The number of each interface: those given, or the one number for all.
inline std::vector<double> each_interface(const Node& node, const Scene& scene) {
  if (node.kind != Node::Kind::array) return std::vector<double>(scene.blocks.size(), number(node));
  return one_each(node);
}
/// Stiffnesses of all interfaces, which may be infinite: those are rigid.
inline std::vector<double> each_stiffness(const Node& node, const Scene& scene) {
  if (node.kind != Node::Kind::array) return each_interface(node, scene);
  return mapped(entries(node, "a number for each block"), number);
}

/// "\"a\", \"b\" or \"c\"".
template <std::size_t count>
std::string one_of_words(const std::array<const char*, count>& names) {
  std::string words;
  for (std::size_t i = 0; i < count; ++i)
    words += (i == 0 ? "\"" : i + 1 < count ? ", \"" : " or \"") + std::string(names[i]) + "\"";
  return words;
}

inline const KeysOf<Scene> scene_keys{
    "",
    "a scene: a stack of blocks, its ground and how it starts",
    {{"title", "\"Two blocks\"", "", "a text", "the name of the file", "heads tables and figures"},
     {"duration", "5.0", "s", KeyRange{"> 0, up to 10⁷ √(size/acceleration)", 1 / largest_number},
      required_key, "of the motion", &Scene::duration},
     {"gravity", "9.81", "m/s²", above_zero, "acceleration of gravity, downwards", &Scene::gravity},
     {{"law", "\"consistent\"", "", one_of_words(law_names), "\"consistent\"",
       "of contact: pivots, with impacts whose impulses push or those of the paper; or blocks that rub, slip, lift "
       "off and land; or such blocks on springs at their corners"},
      [](const Node& node, Scene& scene) { scene.law = choice<Law>(node, law_names); }},
     {{"equations", "\"nonlinear\"", "", one_of_words(equation_names), "\"nonlinear\"",
       "of motion: in full; with geometry frozen upright, Eqs. (19)–(28) of the paper; or the usual linear ones, "
       "where sin(α − θ) is α − θ (Housner 1963)"},
      [](const Node& node, Scene& scene) { scene.equations = choice<Equations>(node, equation_names); }},
     {"blocks", "", "", "1 to 32 tables [[blocks]]", required_key, "the stack"},
     {"initial", "", "", "a table [initial]", no_default, "how it starts"},
     {"ground", "", "", "tables [ground.horizontal], [ground.vertical]", no_default, "how the ground moves"},
     {"contact", "", "", "a table [contact]", no_default, "how blocks touch"},
     {"engine", "", "", "a table [engine]", no_default, "what engines need besides"},
     {"restitution", "[0.9]", "", KeyRange{"a number from 0 to 1 for each block", 0, 1}, "that of the law",
      "of the interface under each block, where all above it rocks as one body: relative angular velocity "
      "after an impact over that before; of the exact solver alone: engines run without",
      &Scene::restitution}}};

inline const KeyTable block_keys{
    "[[blocks]]",
    "a block, from the bottom up",
    {{"width", "1.0", "m", "> 0", required_key, "across the plane of motion, 2b"},
     {"height", "2.5", "m", "> 0", required_key, "of the block, 2h"},
     {"density", "2500", "kg/m³", "> 0", required_key, "mass over width, height and 1 m of depth"},
     {"mass", "6250", "kg", "> 0", "instead of density", "of the block"},
     {"inertia", "3776", "kg·m²", "> 0", "that of a uniform rectangle", "about the centre of mass"},
     {"center_of_mass", "[0.0, 0.0]", "m", "inside the block, beside inertia", "[0, 0]",
      "from the block's middle, to the right and up; not for engines, small-angle equations or restitution"}}};

inline const KeysOf<InitialState> initial_keys{
    "[initial]",
    "the state at t = 0; blocks that lean alike with equal velocities are in contact",
    {{"angles", "[0.1]", "rad", KeyRange{"a number for each block, below its toppling angle"}, "all 0",
      "from the vertical, clockwise positive", &InitialState::angles},
     {"velocities", "[0.0]", "rad/s", KeyRange{"a number for each block"}, "all 0", "clockwise positive",
      &InitialState::velocities},
     {"slip_velocities", "[0.0]", "m/s",
      KeyRange{"a number for each block; law \"unilateral\" or \"compliant\""}, "all 0",
      "along what is below, to the right positive", &InitialState::slip_velocities},
     {"offsets", "[0.0]", "m",
      KeyRange{"a number for each block, so that it is over what is below; those laws"}, "all 0",
      "of a block's middle from that of what is below, along the face, to the right positive; of a block that leans, "
      "before it is turned about the corner that touches",
      &InitialState::offsets},
     {"gaps", "[0.0]", "m", KeyRange{"≥ 0 for each block; those laws, with unloaded springs", 0}, "all 0",
      "by which a block is above what is below at the start, to fall", &InitialState::gaps},
     {"gap_velocities", "[0.0]", "m/s", KeyRange{"a number for each block, 0 where it has no gap"}, "all 0",
      "at which a block with a gap rises over what is below; its slip velocity is of its centre too",
      &InitialState::gap_velocities},
     {{"springs", "\"loaded\"", "", "\"loaded\" or \"unloaded\"; law \"compliant\"", "\"loaded\"",
       "whether springs carry what rests on them at the start"},
      [](const Node& node, InitialState& initial) {
        initial.preloaded = !choice<bool>(node, {"loaded", "unloaded"});
      }}}};

inline const KeysOf<Scene> contact_keys{
    "[contact]",
    "how blocks touch",
    {{{"friction", "0.4", "", "a number from 0 to 1000, or one for each block", "1000",
       "Coulomb's coefficient of the interface under each block, in laws \"unilateral\" and "
       "\"compliant\" and in engines; laws of pivots never slip, and warn where they would have to"},
      [](const Node& node, Scene& scene) { scene.friction = each_interface(node, scene); }},
     {"restitution", "0.0", "", KeyRange{"a number from 0 to 1; law \"unilateral\"", 0, 1},
      "coefficient of contact points, which engines take too: what a point that meets a face keeps of "
      "its speed across it, backwards; of rocking under laws of pivots see restitution outside this table",
      &Scene::point_restitution},
     {{"restitution_law", "\"newton\"", "", "\"newton\" or \"poisson\", beside restitution", "\"newton\"",
       "what restitution multiplies: speeds of points, or, by Poisson's, impulses of compression, which expansion "
       "gives back; engines have their own"},
      [](const Node& node, Scene& scene) {
        scene.restitution_law = choice<RestitutionLaw>(node, {"newton", "poisson"});
      }},
     {{"stiffness", "inf", "N/m", "> 0 or inf, or one for each block; law \"compliant\"", "inf",
       "of a spring at each corner of the interface under each block, across the face; inf: rigid"},
      [](const Node& node, Scene& scene) { scene.springs.stiffness = each_stiffness(node, scene); }},
     {{"damping", "0.0", "N·s/m", "≥ 0, or one for each block; law \"compliant\"", "0",
       "of the dashpot beside each spring; nothing pulls"},
      [](const Node& node, Scene& scene) { scene.springs.damping = each_interface(node, scene); }},
     {{"bed_stiffness", "inf", "N/m²", "> 0 or inf, or one for each block; law \"compliant\"", "inf",
       "of a Winkler bed along the interface under each block, per length; inf: none; not beside stiffness"},
      [](const Node& node, Scene& scene) { scene.springs.bed_stiffness = each_stiffness(node, scene); }},
     {{"bed_damping", "0.0", "N·s/m²", "≥ 0, or one for each block; law \"compliant\"", "0",
       "of that bed, per length; no part of it pulls"},
      [](const Node& node, Scene& scene) { scene.springs.bed_damping = each_interface(node, scene); }},
     {{"tangential", "1.0", "", "> 0; law \"compliant\"", "1",
       "stiffness and damping along the face over those across it, up to friction; a bed has one such spring, "
       "at its middle, for all of its width"},
      [](const Node& node, Scene& scene) { scene.springs.tangential = number(node); }}}};

inline const KeysOf<Scene> ground_keys{
    "[ground]",
    "the ground's acceleration",
    {{"horizontal", "", "", "a table [ground.horizontal]", no_default, "positive to the right"},
     {"vertical", "", "", "a table [ground.vertical]", no_default, "positive up"},
     {"inclination", "0.0", "rad", by_itself("±π/4"),
      "slope of the ground, down to the right; angles and motions are along and across it",
      &Scene::inclination}}};

inline const KeyTable record_keys{
    "[ground.horizontal]",
    "a record; [ground.vertical] likewise, up positive",
    {{"record", "\"motion.csv\"", "",
      "a file beside the scene: AT2, COSMOS, ESM, GeoNet, K-NET, ObsPy, SMC, Volume 2, columns", required_key,
      "accelerogram; \"FILE:CHANNEL\" takes one of several channels"},
     {"from", "0.0", "s", "a time of the record", "0", "where the motion begins, at the nearest sample"},
     {"to", "1.0", "s", "a later time", "the record's end", "where it ends, at the nearest sample"},
     {"scale", "1.0", "", "any number", "1", "factor on the accelerations"},
     {"peak", "3.0", "m/s²", "> 0", "instead of scale", "largest acceleration, to which all are scaled"},
     {"time_scale", "1.0", "", "> 0", "1",
      "factor on the times; √λ for a model of λ times the size, whose angles are then those of the original"},
     {"limits", "\"none\"", "", "\"usual\" or \"none\"", "\"usual\"",
      "of a record: refuses a step below 10 µs or above 0.5 s and a peak above 10 g, or takes them as meant"}}};

inline const KeyTable samples_keys{
    "[ground.horizontal]",
    "accelerations in the file itself",
    {{"samples", "[0.0, 2.0, -1.0, 0.0]", "m/s²", "at least one number", required_key,
      "accelerations, straight lines between them, zero afterwards"},
     {"interval", "0.1", "s", "> 0", required_key, "time from one sample to the next"},
     {"scale", "1.0", "", "any number", "1", "factor on the accelerations"},
     {"peak", "3.0", "m/s²", "> 0", "instead of scale", "largest acceleration, to which all are scaled"},
     {"time_scale", "1.0", "", "> 0", "1",
      "factor on the times; √λ for a model of λ times the size, whose angles are then those of the original"}}};

inline const KeysOf<Pulse> pulse_keys{
    "[ground.horizontal]",
    "a pulse",
    {{"pulse", "\"half-sine\"", "", "\"half-sine\", \"rectangle\" or \"ricker\"", required_key, "its shape"},
     {"amplitude", "3.0", "m/s²", any_number, required_key, "largest acceleration", &Pulse::amplitude},
     {"period", "0.5", "s", above_zero, required_key, "of the whole sine; of a rectangle the length",
      &Pulse::period},
     {"start", "0.0", "s", from_zero, "when it begins", &Pulse::start}}};

inline const KeysOf<Pulse> harmonic_keys{
    "[ground.horizontal]",
    "one period of a sine or cosine, or several, or for ever",
    {{"pulse", "\"sine\"", "", "\"sine\" or \"cosine\"", required_key, "its shape"},
     {"amplitude", "3.0", "m/s²", any_number, required_key, "largest acceleration", &Pulse::amplitude},
     {"period", "0.5", "s", above_zero, required_key, "of one cycle", &Pulse::period},
     {"start", "0.0", "s", from_zero, "when it begins", &Pulse::start},
     {"cycles", "3.0", "", by_itself("> 0, or inf"),
      "periods, whole or not; inf: harmonic motion without end", &Pulse::cycles}}};

inline const KeysOf<Pulse> near_fault_keys{
    "[ground.horizontal]",
    "a near-fault pulse of Mavroeidis & Papageorgiou 2003",
    {{"pulse", "\"mavroeidis-papageorgiou\"", "", "\"mavroeidis-papageorgiou\"", required_key, "its shape"},
     {"amplitude", "3.0", "m/s²", any_number, required_key, "about the largest acceleration",
      &Pulse::amplitude},
     {"period", "0.5", "s", above_zero, required_key, "of the carrier", &Pulse::period},
     {"start", "0.0", "s", from_zero, "when it begins", &Pulse::start},
     {"cycles", "2.0", "", by_itself("> 1, up to 10⁶"), required_key,
      "γ: periods of the carrier under the envelope", &Pulse::cycles},
     {"phase", "0.0", "rad", any_number, "ν: of the carrier", &Pulse::phase}}};

inline const KeysOf<Pulse>& keys_of(PulseShape shape) {
  return shape == PulseShape::mavroeidis_papageorgiou               ? near_fault_keys
         : shape == PulseShape::sine || shape == PulseShape::cosine ? harmonic_keys
                                                                    : pulse_keys;
}

inline const KeysOf<SyntheticMotion> synthetic_keys{
    "[ground.horizontal]",
    "a made-up earthquake: noise through a ground layer, under an envelope",
    {{"synthetic", "1", "", "a whole number from 0 to 2⁵³", required_key, "seed: each gives another motion"},
     {"peak", "4.0", "m/s²", above_zero, required_key, "largest acceleration", &SyntheticMotion::peak},
     {"duration", "20.0", "s", by_itself("> 0, up to 1000"), "of the shaking", &SyntheticMotion::duration},
     {"interval", "0.01", "s", by_itself("the duration in 16 to 20000 parts"), "of samples",
      &SyntheticMotion::interval},
     {"frequency", "2.5", "Hz", by_itself("1/duration to 25, or to half the sampling rate"),
      "of the ground layer", &SyntheticMotion::frequency},
     {"damping", "0.6", "", by_itself("> 0, up to 1"), "of the ground layer, as a fraction of critical",
      &SyntheticMotion::damping}}};

inline const KeysOf<Scene> surface_keys{
    "[engine]",
    "what engines need and the exact solver does not",
    {{{"friction", "1000.0", "", "> 0; above 1000 as 1000", "1000",
       "the older name of contact.friction, of all interfaces; not beside it"},
      [](const Node& node, Scene& scene) {
        scene.friction.assign(scene.blocks.size(), std::min(number_above_zero(node), largest_friction));
      }},
     {"depth", "1.0", "m", above_zero, "of the blocks, out of the plane", &Scene::depth}}};

/// All tables of a scene file, in the order of a file; those of [ground.horizontal] are alternatives.
inline constexpr std::initializer_list<const KeyTable*> scene_tables{
    &scene_keys,   &block_keys, &initial_keys,  &contact_keys,    &ground_keys,    &record_keys,
    &samples_keys, &pulse_keys, &harmonic_keys, &near_fault_keys, &synthetic_keys, &surface_keys};

}  // namespace rockstack
