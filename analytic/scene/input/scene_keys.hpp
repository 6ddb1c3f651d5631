#pragma once

#include "analytic/scene/input/fields.hpp"

namespace rockstack {

// Every key of a scene file. A new one is a line here, and is read where the others of its table are.

inline constexpr KeyTable scene_keys{
    "",
    "a scene: a stack of blocks, its ground and how it starts",
    {{"title", "\"Two blocks\"", "", "a text", "the name of the file", "heads tables and figures"},
     {"duration", "5.0", "s", "> 0, up to 10⁷ √(size/acceleration)", required_key, "of the motion"},
     {"gravity", "9.81", "m/s²", "> 0", "9.81", "acceleration of gravity, downwards"},
     {"law", "\"consistent\"", "", "\"consistent\", \"paper\", \"unilateral\" or \"compliant\"",
      "\"consistent\"",
      "of contact: pivots, with impacts whose impulses push or those of the paper; or blocks that rub, slip, lift "
      "off and land; or such blocks on springs at their corners"},
     {"equations", "\"nonlinear\"", "", "\"nonlinear\", \"linear\" or \"small-angle\"", "\"nonlinear\"",
      "of motion: in full; with geometry frozen upright, Eqs. (19)–(28) of the paper; or the usual linear ones, "
      "where sin(α − θ) is α − θ (Housner 1963)"},
     {"blocks", "", "", "1 to 32 tables [[blocks]]", required_key, "the stack"},
     {"initial", "", "", "a table [initial]", no_default, "how it starts"},
     {"ground", "", "", "tables [ground.horizontal], [ground.vertical]", no_default, "how the ground moves"},
     {"contact", "", "", "a table [contact]", no_default, "how blocks touch"},
     {"engine", "", "", "a table [engine]", no_default, "what engines need besides"},
     {"restitution", "[0.9]", "", "a number from 0 to 1 for each block", "that of the law",
      "of the interface under each block, where all above it rocks as one body: relative angular velocity "
      "after an impact over that before; of the exact solver alone: engines run without"}}};

inline constexpr KeyTable block_keys{
    "[[blocks]]",
    "a block, from the bottom up",
    {{"width", "1.0", "m", "> 0", required_key, "across the plane of motion, 2b"},
     {"height", "2.5", "m", "> 0", required_key, "of the block, 2h"},
     {"density", "2500", "kg/m³", "> 0", required_key, "mass over width, height and 1 m of depth"},
     {"mass", "6250", "kg", "> 0", "instead of density", "of the block"},
     {"inertia", "3776", "kg·m²", "> 0", "that of a uniform rectangle", "about the centre of mass"},
     {"center_of_mass", "[0.0, 0.0]", "m", "inside the block, beside inertia", "[0, 0]",
      "from the block's middle, to the right and up; not for engines, small-angle equations or restitution"}}};

inline constexpr KeyTable initial_keys{
    "[initial]",
    "the state at t = 0; blocks that lean alike with equal velocities are in contact",
    {{"angles", "[0.1]", "rad", "a number for each block, below its toppling angle", "all 0",
      "from the vertical, clockwise positive"},
     {"velocities", "[0.0]", "rad/s", "a number for each block", "all 0", "clockwise positive"},
     {"slip_velocities", "[0.0]", "m/s", "a number for each block; law \"unilateral\" or \"compliant\"",
      "all 0", "along what is below, to the right positive"},
     {"offsets", "[0.0]", "m", "a number for each block, so that it is over what is below; those laws",
      "all 0",
      "of a block's middle from that of what is below, along the face, to the right positive; of a block that leans, "
      "before it is turned about the corner that touches"},
     {"gaps", "[0.0]", "m", "≥ 0 for each block; those laws, with unloaded springs", "all 0",
      "by which a block is above what is below at the start, to fall"},
     {"gap_velocities", "[0.0]", "m/s", "a number for each block, 0 where it has no gap", "all 0",
      "at which a block with a gap rises over what is below; its slip velocity is of its centre too"},
     {"springs", "\"loaded\"", "", "\"loaded\" or \"unloaded\"; law \"compliant\"", "\"loaded\"",
      "whether springs carry what rests on them at the start"}}};

inline constexpr KeyTable contact_keys{
    "[contact]",
    "how blocks touch",
    {{"friction", "0.4", "", "a number from 0 to 1000, or one for each block", "that of [engine]",
      "Coulomb's coefficient of the interface under each block, in laws \"unilateral\" and "
      "\"compliant\" and in engines; laws of pivots never slip, and warn where they would have to"},
     {"restitution", "0.0", "", "a number from 0 to 1; law \"unilateral\"", "0",
      "coefficient of contact points, which engines take too: what a point that meets a face keeps of "
      "its speed across it, backwards; of rocking under laws of pivots see restitution outside this table"},
     {"restitution_law", "\"newton\"", "", "\"newton\" or \"poisson\", beside restitution", "\"newton\"",
      "what restitution multiplies: speeds of points, or, by Poisson's, impulses of compression, which expansion "
      "gives back; engines have their own"},
     {"stiffness", "inf", "N/m", "> 0 or inf, or one for each block; law \"compliant\"", "inf",
      "of a spring at each corner of the interface under each block, across the face; inf: rigid"},
     {"damping", "0.0", "N·s/m", "≥ 0, or one for each block; law \"compliant\"", "0",
      "of the dashpot beside each spring; nothing pulls"},
     {"bed_stiffness", "inf", "N/m²", "> 0 or inf, or one for each block; law \"compliant\"", "inf",
      "of a Winkler bed along the interface under each block, per length; inf: none; not beside stiffness"},
     {"bed_damping", "0.0", "N·s/m²", "≥ 0, or one for each block; law \"compliant\"", "0",
      "of that bed, per length; no part of it pulls"},
     {"tangential", "1.0", "", "> 0; law \"compliant\"", "1",
      "stiffness and damping along the face over those across it, up to friction; a bed has one such spring, "
      "at its middle, for all of its width"}}};

inline constexpr KeyTable ground_keys{
    "[ground]",
    "the ground's acceleration",
    {{"horizontal", "", "", "a table [ground.horizontal]", no_default, "positive to the right"},
     {"vertical", "", "", "a table [ground.vertical]", no_default, "positive up"},
     {"inclination", "0.0", "rad", "±π/4", "0",
      "slope of the ground, down to the right; angles and motions are along and across it"}}};

inline constexpr KeyTable record_keys{
    "[ground.horizontal]",
    "a record; [ground.vertical] likewise, up positive",
    {{"record", "\"motion.csv\"", "",
      "a file beside the scene: AT2, COSMOS, ESM, GeoNet, K-NET, ObsPy, SMC, Volume 2, columns", required_key,
      "accelerogram; \"FILE:CHANNEL\" takes one of several channels"},
     {"scale", "1.0", "", "any number", "1", "factor on the accelerations"},
     {"peak", "3.0", "m/s²", "> 0", "instead of scale", "largest acceleration, to which all are scaled"},
     {"time_scale", "1.0", "", "> 0", "1",
      "factor on the times; √λ for a model of λ times the size, whose angles are then those of the original"},
     {"limits", "\"none\"", "", "\"usual\" or \"none\"", "\"usual\"",
      "of a record: refuses a step below 10 µs or above 0.5 s and a peak above 10 g, or takes them as meant"}}};

inline constexpr KeyTable samples_keys{
    "[ground.horizontal]",
    "accelerations in the file itself",
    {{"samples", "[0.0, 2.0, -1.0, 0.0]", "m/s²", "at least one number", required_key,
      "accelerations, straight lines between them, zero afterwards"},
     {"interval", "0.1", "s", "> 0", required_key, "time from one sample to the next"},
     {"scale", "1.0", "", "any number", "1", "factor on the accelerations"},
     {"peak", "3.0", "m/s²", "> 0", "instead of scale", "largest acceleration, to which all are scaled"},
     {"time_scale", "1.0", "", "> 0", "1",
      "factor on the times; √λ for a model of λ times the size, whose angles are then those of the original"}}};

inline constexpr KeyTable pulse_keys{
    "[ground.horizontal]",
    "a pulse",
    {{"pulse", "\"half-sine\"", "", "\"half-sine\", \"rectangle\" or \"ricker\"", required_key, "its shape"},
     {"amplitude", "3.0", "m/s²", "any number", required_key, "largest acceleration"},
     {"period", "0.5", "s", "> 0", required_key, "of the whole sine; of a rectangle the length"},
     {"start", "0.0", "s", "≥ 0", "0", "when it begins"}}};

inline constexpr KeyTable harmonic_keys{
    "[ground.horizontal]",
    "one period of a sine or cosine, or several, or for ever",
    {{"pulse", "\"sine\"", "", "\"sine\" or \"cosine\"", required_key, "its shape"},
     {"amplitude", "3.0", "m/s²", "any number", required_key, "largest acceleration"},
     {"period", "0.5", "s", "> 0", required_key, "of one cycle"},
     {"start", "0.0", "s", "≥ 0", "0", "when it begins"},
     {"cycles", "3.0", "", "> 0, or inf", "1", "periods, whole or not; inf: harmonic motion without end"}}};

inline constexpr KeyTable near_fault_keys{
    "[ground.horizontal]",
    "a near-fault pulse of Mavroeidis & Papageorgiou 2003",
    {{"pulse", "\"mavroeidis-papageorgiou\"", "", "\"mavroeidis-papageorgiou\"", required_key, "its shape"},
     {"amplitude", "3.0", "m/s²", "any number", required_key, "about the largest acceleration"},
     {"period", "0.5", "s", "> 0", required_key, "of the carrier"},
     {"start", "0.0", "s", "≥ 0", "0", "when it begins"},
     {"cycles", "2.0", "", "> 1, up to 10⁶", required_key, "γ: periods of the carrier under the envelope"},
     {"phase", "0.0", "rad", "any number", "0", "ν: of the carrier"}}};

inline constexpr KeyTable synthetic_keys{
    "[ground.horizontal]",
    "a made-up earthquake: noise through a ground layer, under an envelope",
    {{"synthetic", "1", "", "a whole number from 0 to 2⁵³", required_key, "seed: each gives another motion"},
     {"peak", "4.0", "m/s²", "> 0", required_key, "largest acceleration"},
     {"duration", "20.0", "s", "> 0, up to 1000", "20", "of the shaking"},
     {"interval", "0.01", "s", "the duration in 16 to 20000 parts", "0.01", "of samples"},
     {"frequency", "2.5", "Hz", "1/duration to 25, or to half the sampling rate", "2.5",
      "of the ground layer"},
     {"damping", "0.6", "", "> 0, up to 1", "0.6", "of the ground layer, as a fraction of critical"}}};

inline constexpr KeyTable surface_keys{
    "[engine]",
    "what engines need and the exact solver does not",
    {{"friction", "1000.0", "", "> 0", "1000",
      "coefficient between any two surfaces; not beside contact.friction"},
     {"depth", "1.0", "m", "> 0", "1", "of the blocks, out of the plane"}}};

/// All tables of a scene file, in the order of a file; those of [ground.horizontal] are alternatives.
inline constexpr std::initializer_list<const KeyTable*> scene_tables{
    &scene_keys,   &block_keys, &initial_keys,  &contact_keys,    &ground_keys,    &record_keys,
    &samples_keys, &pulse_keys, &harmonic_keys, &near_fault_keys, &synthetic_keys, &surface_keys};

}  // namespace rockstack
