#pragma once

#include "analytic/scene/ground/synthetic.hpp"
#include "analytic/scene/input/applied_forces_keys.hpp"
#include "analytic/scene/input/key.hpp"
#include "analytic/scene/pattern.hpp"

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

// What the page of `rockstack live` has on its sliders.
inline constexpr UsualNumbers usual_lengths{0.1, 10, true}, usual_accelerations{-10, 10},
    usual_peaks{0.1, 15, true}, usual_periods{0.05, 5, true}, usual_starts{0, 10}, usual_cycles{0.5, 10},
    usual_scales{-3, 3}, usual_shares{0, 1};

inline const std::vector<NamedChoice> laws{{name(Law::paper), "pivots"},
                                           {name(Law::consistent), "pivots"},
                                           {name(Law::unilateral), "slip, lift-off"},
                                           {name(Law::compliant), "springs"}};
inline const std::vector<NamedChoice> equations_of_motion{{name(Equations::nonlinear)},
                                                          {name(Equations::linear), "as the paper has them"},
                                                          {name(Equations::small_angle)}};
inline const std::vector<NamedChoice> restitution_laws{{"newton", "speeds"}, {"poisson", "impulses"}};
inline const std::vector<NamedChoice> single_pulses{{"half-sine"}, {"rectangle"}, {"ricker"}};
inline const std::vector<NamedChoice> harmonics{{"sine"}, {"cosine"}};
inline const std::vector<NamedChoice> near_fault_pulses{{"mavroeidis-papageorgiou"}};

inline const KeysOf<Scene> scene_keys{
    "",
    "a scene: a stack of blocks, its ground and how it starts",
    {{"title", "\"Two blocks\"", "", "a text", "the name of the file", "heads tables and figures"},
     {"duration", "5.0", "s", KeyRange{"> 0, up to 10⁷ √(size/acceleration)", 1 / largest_number},
      required_key, "of the motion", &Scene::duration, UsualNumbers{0.5, 60, true}},
     {"gravity", "9.81", "m/s²", above_zero, "acceleration of gravity, downwards", &Scene::gravity,
      UsualNumbers{1, 25}},
     {"law", "\"consistent\"", laws,
      "of contact: pivots, with impacts whose impulses push or those of the paper; or blocks that rub, slip, lift "
      "off and land; or such blocks on springs at their corners",
      &Scene::law},
     {"equations", "\"nonlinear\"", equations_of_motion,
      "of motion: in full; with geometry frozen upright, Eqs. (19)–(28) of the paper; or the usual linear ones, "
      "where sin(α − θ) is α − θ (Housner 1963)",
      &Scene::equations},
     {"blocks", "", "", "1 to 32 tables [[blocks]]", required_key, "the stack"},
     {"initial", "", "", "a table [initial]", no_default, "how it starts"},
     {"ground", "", "", "tables [ground.horizontal], [ground.vertical]", no_default, "how the ground moves"},
     {"contact", "", "", "a table [contact]", no_default, "how blocks touch"},
     {"push", "", "", "up to 8 tables [[push]]", no_default, "forces on blocks"},
     {"wall", "", "", "a table [wall]", no_default, "what one block rocks away from"},
     {"restraint", "", "", "up to 8 tables [[restraint]]", no_default, "tendons and dampers"},
     {"engine", "", "", "a table [engine]", no_default, "what engines need besides"},
     {"restitution", "[0.9]", "", KeyRange{"a number from 0 to 1 for each block", 0, 1}, "that of the law",
      "of the interface under each block, where all above it rocks as one body: relative angular velocity "
      "after an impact over that before; of the exact solver alone: engines run without",
      &Scene::restitution, usual_shares}}};

inline const KeyTable block_keys{
    "[[blocks]]",
    "a block, from the bottom up",
    {{"width", "1.0", "m", "> 0", required_key, "across the plane of motion, 2b", usual_lengths},
     {"height", "2.5", "m", "> 0", required_key, "of the block, 2h", usual_lengths},
     {"density", "2500", "kg/m³", "> 0", required_key, "mass over width, height and 1 m of depth",
      UsualNumbers{100, 20000, true}},
     {"mass", "6250", "kg", "> 0", "instead of density", "of the block", UsualNumbers{1, 1e6, true}},
     {"inertia", "3776", "kg·m²", "> 0", "that of a uniform rectangle", "about the centre of mass"},
     {"center_of_mass", "[0.0, 0.0]", "m", "inside the block, beside inertia", "[0, 0]",
      "from the block's middle, to the right and up; not for small-angle equations or restitution"}}};

inline const KeysOf<InitialState> initial_keys{
    "[initial]",
    "the state at t = 0; blocks that lean alike with equal velocities are in contact",
    {{"angles", "[0.1]", "rad", KeyRange{"a number for each block, below its toppling angle"}, "all 0",
      "from the vertical, clockwise positive", &InitialState::angles},
     {"velocities", "[0.0]", "rad/s", KeyRange{"a number for each block"}, "all 0", "clockwise positive",
      &InitialState::velocities, UsualNumbers{-2, 2}},
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
       "\"compliant\" and in engines; laws of pivots never slip, and warn where they would have to",
       UsualNumbers{0.01, largest_friction, true}},
      [](const Node& node, Scene& scene) { scene.friction = each_interface(node, scene); }},
     {{"kinetic_friction", "0.4", "",
       "a number from 0 to friction, or one for each block; not law \"compliant\"", "friction",
       "the coefficient of what slides, and of impulses; of engines that have a second one",
       UsualNumbers{0.01, largest_friction, true}},
      [](const Node& node, Scene& scene) { scene.kinetic_friction = each_interface(node, scene); }},
     {"restitution", "0.0", "", KeyRange{"a number from 0 to 1; law \"unilateral\"", 0, 1},
      "coefficient of contact points, which engines take too: what a point that meets a face keeps of "
      "its speed across it, backwards; of rocking under laws of pivots see restitution outside this table",
      &Scene::point_restitution, usual_shares},
     {"restitution_law", "\"newton\"", restitution_laws,
      "what restitution multiplies: speeds of points, or, by Poisson's, impulses of compression, which expansion "
      "gives back; engines have their own",
      &Scene::restitution_law, ", beside restitution"},
     {{"stiffness", "inf", "N/m", "> 0 or inf, or one for each block; law \"compliant\"", "inf",
       "of a spring at each corner of the interface under each block, across the face; inf: rigid",
       UsualNumbers{1e5, 1e11, true}},
      [](const Node& node, Scene& scene) { scene.springs.stiffness = each_stiffness(node, scene); }},
     {{"damping", "0.0", "N·s/m", "≥ 0, or one for each block; law \"compliant\"", "0",
       "of the dashpot beside each spring; nothing pulls", UsualNumbers{0, 1e6}},
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

inline const KeysOf<Wall> wall_keys{
    "[wall]",
    "a rigid wall that one block stands against; laws of pivots, beside no push, restraint, velocity step, restitution or center_of_mass",
    {{{"side", "\"left\"", "", "\"left\" or \"right\"", required_key,
       "of the block; it rocks to the other side alone"},
      [](const Node& node, Wall& wall) {
        wall.side = choice<bool>(node, {"left", "right"}) ? 1 : -1;
      }},
     {{"restitution", "0.3", "", "a number from 0 to 1", "that of its shape (analytic/scene/wall.hpp)",
       "what a strike leaves of the angular velocity, backwards; of the exact solver alone", usual_shares},
      [](const Node& node, Wall& wall) { wall.restitution = number(node); }}}};

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
     {"scale", "1.0", "", "any number", "1", "factor on the accelerations", usual_scales},
     {"peak", "3.0", "m/s²", "> 0", "instead of scale", "largest acceleration, to which all are scaled",
      usual_peaks},
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
     {"scale", "1.0", "", "any number", "1", "factor on the accelerations", usual_scales},
     {"peak", "3.0", "m/s²", "> 0", "instead of scale", "largest acceleration, to which all are scaled",
      usual_peaks},
     {"time_scale", "1.0", "", "> 0", "1",
      "factor on the times; √λ for a model of λ times the size, whose angles are then those of the original"}}};

inline const KeyTable steps_keys{
    "[ground.horizontal]",
    "steps of the ground's velocity: impulses on all masses",
    {{"velocity_steps", "[0.3, -0.3]", "m/s", "at least one number", required_key,
      "by which the ground's velocity changes at once"},
     {"times", "[0.0, 0.5]", "s", "as many, from 0 on, each later than the one before", required_key,
      "of the steps"},
     {"scale", "1.0", "", "any number", "1", "factor on the steps", usual_scales}}};

inline const KeysOf<Pulse> pulse_keys{
    "[ground.horizontal]",
    "a pulse",
    {{"pulse", "\"half-sine\"", single_pulses, "its shape"},
     {"amplitude", "3.0", "m/s²", any_number, required_key, "largest acceleration", &Pulse::amplitude,
      usual_accelerations},
     {"period", "0.5", "s", above_zero, required_key, "of the whole sine; of a rectangle the length",
      &Pulse::period, usual_periods},
     {"start", "0.0", "s", from_zero, "when it begins", &Pulse::start, usual_starts}}};

inline const KeysOf<Pulse> harmonic_keys{
    "[ground.horizontal]",
    "one period of a sine or cosine, or several, or for ever",
    {{"pulse", "\"sine\"", harmonics, "its shape"},
     {"amplitude", "3.0", "m/s²", any_number, required_key, "largest acceleration", &Pulse::amplitude,
      usual_accelerations},
     {"period", "0.5", "s", above_zero, required_key, "of one cycle", &Pulse::period, usual_periods},
     {"start", "0.0", "s", from_zero, "when it begins", &Pulse::start, usual_starts},
     {"cycles", "3.0", "", by_itself("> 0, or inf"),
      "periods, whole or not; inf: harmonic motion without end", &Pulse::cycles, usual_cycles}}};

inline const KeysOf<Pulse> near_fault_keys{
    "[ground.horizontal]",
    "a near-fault pulse of Mavroeidis & Papageorgiou 2003",
    {{"pulse", "\"mavroeidis-papageorgiou\"", near_fault_pulses, "its shape"},
     {"amplitude", "3.0", "m/s²", any_number, required_key, "about the largest acceleration",
      &Pulse::amplitude, usual_accelerations},
     {"period", "0.5", "s", above_zero, required_key, "of the carrier", &Pulse::period, usual_periods},
     {"start", "0.0", "s", from_zero, "when it begins", &Pulse::start, usual_starts},
     {"cycles", "2.0", "", by_itself("> 1, up to 10⁶"), required_key,
      "γ: periods of the carrier under the envelope", &Pulse::cycles, usual_cycles},
     {"phase", "0.0", "rad", any_number, "ν: of the carrier", &Pulse::phase, UsualNumbers{-3.15, 3.15}}}};

inline const KeysOf<Pulse>& keys_of(PulseShape shape) {
  return shape == PulseShape::mavroeidis_papageorgiou               ? near_fault_keys
         : shape == PulseShape::sine || shape == PulseShape::cosine ? harmonic_keys
                                                                    : pulse_keys;
}

inline const KeysOf<SyntheticMotion> synthetic_keys{
    "[ground.horizontal]",
    "a made-up earthquake: noise through a ground layer, under an envelope",
    {{"synthetic", "1", "", whole_numbers(0, largest_seed), required_key, "seed: each gives another motion",
      &SyntheticMotion::seed, UsualNumbers{0, 100}},
     {"peak", "4.0", "m/s²", above_zero, required_key, "largest acceleration", &SyntheticMotion::peak,
      usual_peaks},
     {"duration", "20.0", "s", by_itself("> 0, up to 1000"), "of the shaking", &SyntheticMotion::duration},
     {"interval", "0.01", "s", by_itself("the duration in 16 to 20000 parts"), "of samples",
      &SyntheticMotion::interval},
     {"frequency", "2.5", "Hz", by_itself("1/duration to 25, or to half the sampling rate"),
      "of the ground layer", &SyntheticMotion::frequency, UsualNumbers{0.5, 10, true}},
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
    &scene_keys,     &block_keys,   &initial_keys, &contact_keys, &wall_keys,     &ground_keys,
    &record_keys,    &samples_keys, &steps_keys,   &pulse_keys,   &harmonic_keys, &near_fault_keys,
    &synthetic_keys, &push_keys,    &tendon_keys,  &damper_keys,  &surface_keys};

}  // namespace rockstack
