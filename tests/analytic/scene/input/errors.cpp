#include <gtest/gtest.h>
#include <sys/stat.h>

#include "analytic/scene/input/scene_file.hpp"
#include "analytic/scene/messages/input_error.hpp"
#include "tests/analytic/scene/input/scene_text.hpp"

namespace rockstack {
namespace {

/// two_blocks() with one line (from 1) in place of what stands there.
std::string with_line(int line, const std::string& replacement) {
  std::string text = two_blocks();
  std::size_t start = 0;
  for (int k = 1; k < line; ++k) start = text.find('\n', start) + 1;
  return text.replace(start, text.find('\n', start) - start, replacement);
}

struct Case {
  int line;
  std::string replacement;
  const char* error;
};

void expect_errors(std::initializer_list<Case> cases) {
  for (const Case& each : cases) EXPECT_EQ(error_of(with_line(each.line, each.replacement)), each.error);
}

TEST(SceneErrors, TheSceneUsedHereIsRightByItself) {
  EXPECT_EQ(error_of(two_blocks()), "");
}

TEST(SceneErrors, NumbersOutOfRange) {
  expect_errors({
      {1, "duration = 0", "scene.toml:1: duration = 0: must be a number from 1e-20 to 1e+20"},
      {1, "duration = inf", "scene.toml:1: duration = inf: must be a number from 1e-20 to 1e+20"},
      {1, "duration = 1\ngravity = nan", "scene.toml:2: gravity = nan: must be a number from 1e-20 to 1e+20"},
      {3, "width = -1", "scene.toml:3: blocks.1.width = -1: must be a number from 1e-20 to 1e+20"},
      {8, "height = nan", "scene.toml:8: blocks.2.height = nan: must be a number from 1e-20 to 1e+20"},
      {5, "mass = 0.0", "scene.toml:5: blocks.1.mass = 0: must be a number from 1e-20 to 1e+20"},
      {5, "density = -0.1", "scene.toml:5: blocks.1.density = -0.1: must be a number from 1e-20 to 1e+20"},
      {5, "mass = 1\ninertia = -2",
       "scene.toml:6: blocks.1.inertia = -2: must be a number from 1e-40 to 1e+40"},
      {11, "angles = [0.1, -inf]", "scene.toml:11: initial.angles.2 = -inf: must be a finite number"},
      {12, "velocities = [nan, 0]", "scene.toml:12: initial.velocities.1 = nan: must be a finite number"},
      {12, "[engine]\nfriction = 0", "scene.toml:13: engine.friction = 0: must be a number > 0"},
      {12, "[engine]\ndepth = -1", "scene.toml:13: engine.depth = -1: must be a number from 1e-20 to 1e+20"},
  });
}

TEST(SceneErrors, FrictionAndSlip) {
  expect_errors({
      {12, "[contact]\nfriction = 0.3\n[engine]\nfriction = 0.3",
       "scene.toml:15: engine.friction = 0.3: must be left out where contact.friction is given "
       "(scene.toml:13), which engines take too"},
      {12, "[contact]\nfriction = -0.1",
       "scene.toml:13: contact.friction.1 = -0.1: must be a number from 0 to 1000"},
      {12, "[contact]\nfriction = [0.1, 1e4]",
       "scene.toml:13: contact.friction.2 = 10000: must be a number from 0 to 1000"},
      {12, "[contact]\nfriction = [0.1]",
       "scene.toml:13: contact.friction = an array of 1: must be a number, or as many as there are blocks, 2"},
      {12, "[contact]\nfriction = 0.3\nkinetic_friction = [0.2, 0.4]",
       "scene.toml:14: contact.kinetic_friction.2 = 0.4: must be at most contact.friction, 0.3 there"},
      {1,
       "duration = 5\nlaw = \"compliant\"\ncontact = { stiffness = 1e9, friction = 0.4, kinetic_friction = 0.2 "
       "}",
       "scene.toml:3: contact.kinetic_friction.1 = 0.2: must be that of contact.friction under law compliant, "
       "where springs along a face would jump as it slides"},
      {12, "[wall]\nside = \"left\"",
       "scene.toml:12: wall = a table: must be left out where a stack has 2 blocks: a wall is beside one"},
      {12, "[contact]\nfriction = \"high\"", "scene.toml:13: contact.friction = \"high\": must be a number"},
      {12, "[contact]\nrestitution = 1.5",
       "scene.toml:13: contact.restitution = 1.5: must be a number from 0 to 1"},
      {12, "[contact]\nrestitution = 0.5",
       "scene.toml:13: contact.restitution = 0.5: must be 0 under law consistent, whose impacts have the ratio "
       "restitution"},
      {12, "[contact]\nrestitution = 0.5\nrestitution_law = \"stronge\"",
       "scene.toml:14: contact.restitution_law = \"stronge\": must be \"newton\" or \"poisson\""},
      {12, "[contact]\nrestitution_law = \"poisson\"",
       "scene.toml:13: contact.restitution_law = \"poisson\": must be left out where contact.restitution is, "
       "whose law it is"},
      {12, "slip_velocities = [0, 1]",
       "scene.toml:12: initial.slip_velocities = not all 0: must be all 0 under law consistent, where nothing "
       "slips or lifts: say law = \"unilateral\""},
      {1, "duration = 1\nlaw = \"unilateral\"\nequations = \"linear\"",
       "scene.toml:3: equations = linear: must be nonlinear under law unilateral"},
      {1, "duration = 1\nlaw = \"unilateral\"\nrestitution = [1, 1]",
       "scene.toml:3: restitution = [1, …]: must be left out under law unilateral, where contact.restitution is "
       "of points"},
      {1, "duration = 1\nlaw = \"compliant\"\nequations = \"linear\"",
       "scene.toml:3: equations = linear: must be nonlinear under law compliant"},
      {12, "[contact]\nstiffness = 1e8",
       "scene.toml:13: contact.stiffness = 1e+08: must be left out under law consistent: springs are for law compliant"},
      {12, "[contact]\nbed_stiffness = 1e8",
       "scene.toml:13: contact.bed_stiffness = 1e+08: must be left out under law consistent: springs are for "
       "law compliant"},
      {12, "[contact]\nbed_damping = [1, 0]",
       "scene.toml:13: contact.bed_damping = 1: must be left out under law consistent: springs are for law "
       "compliant"},
      {12, "springs = 1", "scene.toml:12: initial.springs = 1: must be \"loaded\" or \"unloaded\""},
  });
}

TEST(SceneErrors, AnInterfaceHasCornerSpringsOrABed) {
  const auto contact = [](const std::string& lines) {
    return error_of("law = \"compliant\"\n" + with_line(12, "[contact]\n" + lines));
  };
  EXPECT_EQ(contact("restitution = 0.5"),
            "scene.toml:14: contact.restitution = 0.5: must be 0 under law compliant, where dashpots decide "
            "(contact.damping)");
  EXPECT_EQ(contact("stiffness = [inf, 1e8]\nbed_stiffness = [1e7, 1e9]"),
            "scene.toml:15: contact.bed_stiffness.2 = 1e+09: must be inf where contact.stiffness is not: an "
            "interface has springs at corners or a bed");
  for (const std::string angles : {"", "0.1"})
    EXPECT_EQ(error_of("law = \"compliant\"\n" +
                       with_line(11, "angles = [" + angles + "]\nsprings = \"unloaded\"") +
                       "[contact]\nbed_stiffness = 1e9\n"),
              "scene.toml:12: initial.angles = an array of " + std::to_string(angles.empty() ? 0 : 1) +
                  ": must be as long as there are blocks, 2");
  EXPECT_EQ(contact("bed_stiffness = [0, 1e8]"),
            "scene.toml:14: contact.bed_stiffness.1 = 0: must be a number from 1e-20 to 1e+20");
  EXPECT_EQ(contact("bed_damping = [0, -1]"),
            "scene.toml:14: contact.bed_damping.2 = -1: must be a number from 0 to 1e+20");
}

TEST(SceneErrors, SpringsThatDoNothingAreRefused) {
  const auto contact = [](const std::string& lines) {
    return error_of("law = \"compliant\"\n" + with_line(12, "[contact]\n" + lines));
  };
  EXPECT_EQ(
      contact("bed_stiffness = 1e8\ndamping = 1e4"),
      "scene.toml:15: contact.damping = 10000: must be left out without contact.stiffness: it is of the "
      "dashpot beside each spring");
  EXPECT_EQ(
      contact("stiffness = 1e8\nbed_damping = 1e4"),
      "scene.toml:15: contact.bed_damping = 10000: must be left out without contact.bed_stiffness: it is "
      "of the bed");
  for (const char* key : {"friction", "stiffness", "damping", "bed_stiffness", "bed_damping"})
    EXPECT_EQ(contact(std::string(key) + " = []"), std::string("scene.toml:14: contact.") + key +
                                                       " = an array of 0: must be a number for each block");
  EXPECT_EQ(contact("damping = 1e4").substr(0, 38), "scene.toml:14: contact.damping = 10000");
  EXPECT_EQ(contact("bed_damping = [0, 1e4]").substr(0, 42), "scene.toml:14: contact.bed_damping = 10000");
  for (const char* lines : {"", "tangential = 2"})
    EXPECT_EQ(contact(lines),
              "scene.toml:1: law = compliant: must be another, or contact.stiffness or contact.bed_stiffness "
              "given: no interface is soft");
  // What stands for no springs at all may be compared with some.
  EXPECT_EQ(contact("stiffness = inf\ndamping = 1e4\ntangential = 0.5"), "");
}

// A block of m = 2500 kg by 1 m³: on two springs of k it gives way by mg/(2k), on a bed of κ by mg/κ.
TEST(SceneErrors, SpringsThatABlockWouldSinkThroughAreRefused) {
  const auto on = [](const std::string& lines) {
    return error_of(
        "duration = 1\nlaw = \"compliant\"\n[[blocks]]\nwidth = 1\nheight = 1\ndensity = 2500\n"
        "[contact]\n" +
        lines);
  };
  EXPECT_EQ(
      on("stiffness = 1e2"),
      "scene.toml:8: contact.stiffness.1 = 100: must be at least 1.23e+05: under the weight above it the "
      "interface would give way by 123 m, at most a tenth of a block's height, 1 m, is a contact");
  EXPECT_NE(on("stiffness = 1.22e5"), "");
  EXPECT_EQ(on("stiffness = 1.23e5"), "");
  EXPECT_NE(on("bed_stiffness = 2.45e5"), "");
  EXPECT_EQ(on("bed_stiffness = 2.46e5"), "");
}

// One block of m = 2500 kg, b = h = 0.5 m, I = m/6: tr M⁻¹K = 2k (1 + t) (1 + 6/4)/m.
TEST(SceneErrors, SpringsThatAreTooFastToBeFollowedAreRefused) {
  const auto on = [](const std::string& lines) {
    return error_of(
        "duration = 8\nlaw = \"compliant\"\n[[blocks]]\nwidth = 1\nheight = 1\ndensity = 2500\n"
        "[contact]\n" +
        lines);
  };
  EXPECT_EQ(
      on("stiffness = 1e7\ntangential = 1e12"),
      "scene.toml:9: contact.tangential = 1e+12: must be such that springs take at most 1e+07 steps: as "
      "fast as 1.41e+08 rad/s, they would take 1.41e+08");
  EXPECT_EQ(on("stiffness = 1e17").substr(0, 40), "scene.toml:8: contact.stiffness.1 = 1e+1");
  EXPECT_EQ(on("stiffness = 1e16"), "");
  EXPECT_EQ(on("stiffness = 1e9\ndamping = 1e11").substr(0, 39), "scene.toml:9: contact.damping.1 = 1e+11");
  // A stretch relaxes at k/c where the slider moves, and no friction is endless.
  EXPECT_EQ(on("stiffness = 1e9\ndamping = 10"), "");
  EXPECT_EQ(on("friction = 0.5\nstiffness = 1e9\ndamping = 10").substr(0, 36),
            "scene.toml:10: contact.damping.1 = 1");
  EXPECT_EQ(on("bed_stiffness = 1e9\nbed_damping = 1e12").substr(0, 43),
            "scene.toml:9: contact.bed_damping.1 = 1e+12");
}

// Two blocks, the lower one 1.25 m wide and the upper one 1 m.
TEST(SceneErrors, OffsetsAndGapsHaveTheirRanges) {
  const auto with = [](const std::string& law, const std::string& lines) {
    return error_of("duration = 1\nlaw = \"" + law +
                    "\"\n[[blocks]]\nwidth = 1.25\nheight = 1\ndensity = 2500\n"
                    "[[blocks]]\nwidth = 1\nheight = 1\ndensity = 2500\n[initial]\n" +
                    lines);
  };
  EXPECT_EQ(with("unilateral", "offsets = [9, 1.12]"), "");
  EXPECT_EQ(
      with("unilateral", "offsets = [0, -1.125]"),
      "scene.toml:12: initial.offsets.2 = -1.125: must be between ±1.125 m, so that the block is over the one "
      "below");
  EXPECT_EQ(with("unilateral", "gaps = [-0.1, 0]"),
            "scene.toml:12: initial.gaps.1 = -0.1: must be a number from 0 to 1e+20");
  EXPECT_EQ(with("unilateral", "gaps = [0.1]"),
            "scene.toml:12: initial.gaps = an array of 1: must be as long as there are blocks, 2");
  EXPECT_EQ(
      with("unilateral", "gaps = [0.1, 0]\ngap_velocities = [1, 1]"),
      "scene.toml:13: initial.gap_velocities.2 = 1: must be 0 where initial.gaps has none: a block that touches "
      "turns and slips");
  EXPECT_EQ(
      with("paper", "gaps = [0.1, 0]"),
      "scene.toml:12: initial.gaps = not all 0: must be all 0 under law paper, where nothing slips or lifts: say "
      "law = \"unilateral\"");
  EXPECT_EQ(
      with("compliant", "gaps = [0.1, 0]\n[contact]\nstiffness = 1e8"),
      "scene.toml:12: initial.gaps.1 = 0.1: must be 0, or beside initial.springs = \"unloaded\": what falls "
      "bears on no spring");
}

TEST(SceneErrors, AToppledStartNamesTheLimit) {
  const std::string line = error_of(with_line(11, "angles = [0, 2.0]"));
  EXPECT_EQ(line.substr(0, 49), "scene.toml:11: initial.angles.2 = 2: must be betw");
  EXPECT_NE(line.find("for block 2, its toppling angle; 2 degrees are 0.034907"), std::string::npos);
}

// Under 9.81 m/s² blocks of 1 m may rock for 10⁷ √(0.7/9.81) s.
TEST(SceneErrors, ADurationThatMayHaveNoEndIsRefused) {
  EXPECT_EQ(error_of(with_line(1, "duration = 2e6")), "");
  EXPECT_EQ(error_of(with_line(1, "duration = 1e8")).substr(0, 48),
            "scene.toml:1: duration = 1e+08: must be at most ");
  // At 10⁸ rad/s a tenth of a second has ten million radians.
  EXPECT_EQ(error_of(with_line(12, "velocities = [1e8, 0]")).substr(0, 41),
            "scene.toml:1: duration = 5: must be at mo");
}

TEST(SceneErrors, WrongTypes) {
  expect_errors({
      {1, "duration = \"5 s\"", "scene.toml:1: duration = \"5 s\": must be a number"},
      {3, "width = true", "scene.toml:3: blocks.1.width = true: must be a number"},
      {3, "width = 1979-05-27", "scene.toml:3: blocks.1.width = 1979-05-27: must be a number"},
      {11, "angles = 0.1", "scene.toml:11: initial.angles = 0.1: must be an array of numbers"},
      {11, "angles = [0.1, \"a\"]", "scene.toml:11: initial.angles.2 = \"a\": must be a number"},
      {1, "duration = 1\ntitle = 3", "scene.toml:2: title = 3: must be a text in quotes"},
      {1, "duration = 1\nengine = [1]", "scene.toml:2: engine = an array of 1: must be a table"},
      {1, "duration = 1\nlaw = \"papr\"",
       "scene.toml:2: law = \"papr\": must be \"paper\" or \"consistent\" or \"unilateral\" or "
       "\"compliant\"; did you mean paper?"},
      {1, "duration = 1\nlaw = \"Coulomb\"",
       "scene.toml:2: law = \"Coulomb\": must be \"paper\" or \"consistent\" or \"unilateral\" or "
       "\"compliant\""},
      {1, "duration = 1\nequations = 2",
       "scene.toml:2: equations = 2: must be \"nonlinear\" or \"linear\" or \"small-angle\""},
  });
  EXPECT_EQ(error_of("duration = 1\nblocks = 3\n"),
            "scene.toml:2: blocks = 3: must be an array of tables, [[blocks]]");
  EXPECT_EQ(error_of("duration = 1\nblocks = [3]\n"), "scene.toml:2: blocks.1 = 3: must be a table");
}

TEST(SceneErrors, UnknownKeysListTheKnownOnes) {
  expect_errors({
      {1, "durration = 5",
       "scene.toml:1: durration: unknown key, must be one of title, duration, gravity, law, equations, blocks, "
       "initial, ground, contact, push, wall, restraint, engine, restitution; did you mean duration?"},
      {7, "widht = 1.0",
       "scene.toml:7: blocks.2.widht: unknown key, must be one of width, height, density, mass, inertia, "
       "center_of_mass; did you mean width?"},
      {12, "speeds = [0, 0]",
       "scene.toml:12: initial.speeds: unknown key, must be one of angles, velocities, slip_velocities, offsets, gaps, gap_velocities, springs"},
      {12, "[ground]\nsideways = 1",
       "scene.toml:13: ground.sideways: unknown key, must be one of horizontal, vertical, inclination"},
      {12, "[ground.vertical]\nspectrum = 1",
       "scene.toml:12: ground.vertical.record: missing, must be given, or samples and interval, a pulse, synthetic or "
       "velocity_steps in its place"},
      {12, "[ground.vertical]\npulse = \"half-sine\"\namplitude = 1\nperiod = 1\ncycles = 2",
       "scene.toml:16: ground.vertical.cycles: unknown key, must be one of pulse, amplitude, period, start"},
      {12, "[engine]\ngrip = 1", "scene.toml:13: engine.grip: unknown key, must be one of friction, depth"},
  });
}

TEST(SceneErrors, PushesActOnBlocksAndInOneWay) {
  expect_errors({
      {12, "[[push]]\nblock = 3\nforce = 1",
       "scene.toml:13: push.1.block = 3: must be one of the blocks, 1 to 2"},
      {12, "[[push]]\nblock = 1",
       "scene.toml:12: push.1.force: missing, must be given, or impulse in its place"},
      {12, "[[push]]\nblock = 1\nforce = 1\nimpulse = 1",
       "scene.toml:15: push.1.impulse = 1: must be left out where force is given (scene.toml:14)"},
      {12, "[[push]]\nblock = 1\nforce = 1\nheight = 20",
       "scene.toml:15: push.1.height = 20: must be a number from 0 to 1.25"},
      {12, "[[push]]\nblock = 1\nforce = 1\nfrom = 2\nto = 1",
       "scene.toml:16: push.1.to = 1: must be later than the force begins"},
      {12, "[[push]]\nblock = 1\nimpulse = 1\nfrom = -1",
       "scene.toml:15: push.1.from = -1: must be a number from 0 to 1e+20"},
      {12, "[[push]]\nblock = 1\nforce = { samples = [1, 2] }",
       "scene.toml:14: push.1.force.interval: missing, must be a number"},
      {12, "[ground.horizontal]\nvelocity_steps = [1, 2]\ntimes = [1, 1]",
       "scene.toml:14: ground.horizontal.times.2 = 1: must be later than the one before"},
      {12, "[ground.horizontal]\nvelocity_steps = [1, 2]\ntimes = [1]",
       "scene.toml:14: ground.horizontal.times = an array of 1: must be as long as velocity_steps, 2"},
  });
}

TEST(SceneErrors, RestraintsJoinTwoPointsApart) {
  const std::string tendon = "[[restraint]]\nkind = \"tendon\"\nblock = 1\nstiffness = 1e6\npoint = [0, 1]\n";
  const std::string below = tendon + "to_point = [0, -1]\n";
  expect_errors({
      {12, "[[restraint]]\nblock = 1",
       "scene.toml:12: restraint.1.kind: missing, must be \"tendon\" or \"damper\""},
      {12, tendon, "scene.toml:12: restraint.1.to_point: missing, must be [x, y] in m"},
      {12, tendon + "to_point = [0, 1]",
       "scene.toml:17: restraint.1.to_point = [0, 1]: must be elsewhere: it has no length where the stack "
       "stands upright"},
      {12, below + "to_block = 1", "scene.toml:18: restraint.1.to_block = 1: must be another block"},
      {12, below + "prestress = 2\nyield = 1",
       "scene.toml:19: restraint.1.yield = 1: must be > prestress, or inf"},
      {12, below + "damping = 1",
       "scene.toml:18: restraint.1.damping: unknown key, must be one of kind, block, point, to_block, "
       "to_point, stiffness, prestress, yield"},
  });
  EXPECT_EQ(
      error_of("law = \"compliant\"\n" + with_line(12, below + "[contact]\nstiffness = 1e9")),
      "scene.toml:1: law = compliant: must be another beside restraint, which springs at corners do not know");
}

TEST(SceneErrors, MissingKeysNameTheLineOfTheirTable) {
  expect_errors({
      {1, "title = \"no duration\"", "scene.toml:1: duration: missing, must be a number"},
      {7, "", "scene.toml:6: blocks.2.width: missing, must be a number"},
      {8, "", "scene.toml:6: blocks.2.height: missing, must be a number"},
      {5, "", "scene.toml:2: blocks.1.density: missing, must be given, or mass in its place"},
  });
  EXPECT_EQ(error_of("duration = 1\n"), "scene.toml:1: blocks = 0 blocks: must be 1 to 32 blocks");
}

TEST(SceneErrors, MassAndDensityExcludeEachOther) {
  EXPECT_EQ(error_of(with_line(9, "mass = 3\ndensity = 4")),
            "scene.toml:9: blocks.2.mass = 3: must be left out where density is given (scene.toml:10)");
}

TEST(SceneErrors, ArraysAreAsLongAsThereAreBlocks) {
  expect_errors({
      {11, "angles = [0, 0, 0]",
       "scene.toml:11: initial.angles = an array of 3: must be as long as there are blocks, 2"},
      {12, "velocities = []",
       "scene.toml:12: initial.velocities = an array of 0: must be as long as there are blocks, 2"},
  });
}

TEST(SceneErrors, ThirtyTwoBlocksAreTheMost) {
  std::string text = "duration = 1\n";
  for (int k = 0; k < 32; ++k) text += "[[blocks]]\nwidth = 1\nheight = 1\nmass = 1\n";
  EXPECT_EQ(error_of(text), "");
  text += "[[blocks]]\nwidth = 1\nheight = 1\nmass = 1\n";
  EXPECT_EQ(error_of(text), "scene.toml:2: blocks = 33 blocks: must be 1 to 32 blocks");
}

TEST(SceneErrors, BrokenTomlNamesItsLine) {
  for (const char* broken :
       {"width = ", "width 1.0", "width = 1.0.0", "width = \"\x01\"", "é = 1", "width = 1.0 é"}) {
    const std::string line = error_of(with_line(7, broken));
    EXPECT_EQ(line.substr(0, 28), "scene.toml:7: must be TOML: ") << broken;
    EXPECT_EQ(line.find('\n'), std::string::npos) << broken;
  }
}

TEST(SceneErrors, OddTextStaysOnOneLine) {
  EXPECT_EQ(error_of(with_line(1, "duration = \"a\\nb\"")),
            "scene.toml:1: duration = \"a\\x0ab\": must be a number");
  EXPECT_EQ(error_of(with_line(12, "\"a\\nb\" = 1")),
            "scene.toml:12: initial.a\\x0ab: unknown key, must be one of angles, velocities, "
            "slip_velocities, offsets, gaps, gap_velocities, springs");
}

TEST(SceneErrors, AFileThatIsNotThereOrADirectory) {
  const TemporaryFolder folder;
  const auto text = [](const std::filesystem::path& file) {
    try {
      read_scene(file);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string missing = (folder.path() / "none.toml").string();
  EXPECT_EQ(text(missing), missing + ": must be a file, or a name from `rockstack list`; nothing is there");
  EXPECT_EQ(text(folder.path()),
            folder.path().string() + ": must be a file, this is a folder, a pipe or a device");
  EXPECT_EQ(text("/dev/zero"), "/dev/zero: must be a file, this is a folder, a pipe or a device");
  const auto pipe = folder.path() / "pipe.toml";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(text(pipe), pipe.string() + ": must be a file, this is a folder, a pipe or a device");
  const auto huge = folder.write("huge.toml", "");
  std::filesystem::resize_file(huge, (std::uintmax_t{64} << 20U) + 1);
  EXPECT_EQ(text(huge), huge.string() + ": must be a file, at most 64 MiB large");
}

TEST(SceneErrors, KeysAndValuesAreNestedAsDeepAsAnySceneNeedsAndNoDeeper) {
  const auto parts = [](int count) {
    std::string key = "a";
    for (int k = 1; k < count; ++k) key += k % 2 == 0 ? ".'b=#'" : " . \"c\\\"\"";
    return key;
  };
  const char* refusal = "must be TOML with keys of at most 32 parts";
  for (const std::string& line :
       {"[" + parts(20000) + "]", parts(33) + " = 1", "x = { " + parts(33) + " = 1 }"})
    EXPECT_EQ(error_of(with_line(1, "duration = 1\n" + line)), std::string("scene.toml:2: ") + refusal);
  EXPECT_NE(error_of(with_line(1, "duration = 1\n" + parts(32) + " = 1")).find("unknown key"),
            std::string::npos);
  const std::string dots(100, '.');
  EXPECT_EQ(error_of(with_line(1, "# " + dots + "\ntitle = \"" + dots + "\"\nduration = 1")), "");
  const std::string deep = "duration = 1\nx = " + std::string(40, '[') + std::string(40, ']');
  EXPECT_TRUE(error_of(with_line(1, deep)).starts_with("scene.toml:2: must be TOML: "));
}

}  // namespace
}  // namespace rockstack
