#include "engines/worker/answer_check.hpp"

#include <fmt/format.h>

#include <cmath>

#include "analytic/scene/messages/input_error.hpp"
#include "analytic/scene/messages/one_line.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {
namespace {

bool is_word(std::string_view text, std::string_view others) {
  return !text.empty() && text.size() <= 60 && std::ranges::all_of(text, [&](char letter) {
    const bool usual = (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9');
    return usual || others.find(letter) != std::string_view::npos;
  });
}

bool is_line(const std::string& text) {
  return text.size() <= 200 && one_line(text) == text;
}

/// Names of the exact answer and of its variants, as rows of a comparison have them.
std::vector<std::string> taken_names() {
  std::vector<std::string> names{"exact", "rk4", "measured"};
  names.insert(names.end(), law_names.begin(), law_names.end());
  names.insert(names.end(), equation_names.begin(), equation_names.end());
  return names;
}

void require(bool holds, const char* key, const std::string& value, const std::string& allowed) {
  if (!holds) throw std::runtime_error(fmt::format("{} = {}: must be {}", key, value, allowed));
}

void check_setting(const Setting& setting) {
  const Setting must = shaking_setting();  // by which this program itself goes
  require(setting.name != must.name || (setting.whole && setting.choices == must.choices), "setting name",
          setting.name,
          fmt::format("of another one, or of the choices {}", fmt::join(must.choices, " and ")));
  require(is_word(setting.name, "_-.ABCDEFGHIJKLMNOPQRSTUVWXYZ"), "setting name", setting.name,
          "letters, digits, '_', '-' and '.', at most 60");
  require(is_line(setting.unit), "unit", setting.name, "one line");
  require(setting.least <= setting.most, "least", setting.name, "at most `most`");
  for (const double value : {setting.default_value, setting.tuned})
    require(setting.allows(value), setting.name.c_str(), fmt::format("{}", value), "within its own range");
  const auto count = static_cast<double>(setting.choices.size());
  require(setting.choices.empty() || (setting.whole && setting.least == 0 && setting.most == count - 1),
          "choices", setting.name, "the names of all whole numbers from least = 0 to most");
  for (const std::string& choice : setting.choices)
    require(is_word(choice, "_-.ABCDEFGHIJKLMNOPQRSTUVWXYZ"), "choice", choice, "a word");
}

void require(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error(what);
}

void require_count(const char* list, std::size_t has, std::size_t must, const std::string& what) {
  require(has == must, fmt::format("`{}` has {} numbers; must have {}, {}", list, has, must, what));
}

void require_range(const char* field, double value, double least, double most = largest_number) {
  require(value >= least && value <= most,
          fmt::format("`{}` must be from {} to {}; {} is not", field, least, most, value));
}

void require_range(const char* list, std::span<const double> values, double least) {
  for (const double value : values) require_range(list, value, least);
}

/// The run ends with the first sample in which a block is past its toppling angle, or with its last step.
void require_all_samples(const Setup& setup, const Trajectory& made) {
  const std::size_t blocks = setup.blocks.size(), all = (setup.steps + 1) * blocks, has = made.angles.size();
  const bool ends_early = has > 0 && has < all && has % blocks == 0 && has_ended(setup, made);
  if (!ends_early)
    require_count("angles", has, all,
                  fmt::format("{} in each of {} samples; fewer samples only where a block of the last one is "
                              "beyond its `toppling_angles`",
                              blocks, setup.steps + 1));
  require_count("velocities", made.velocities.size(), has, "as many as `angles`");
  for (std::size_t i = 0; i + blocks < has; ++i)
    if (std::abs(made.angles[i]) > setup.toppling_angles[i % blocks])
      throw std::runtime_error(
          fmt::format("`angles` must end with sample {}, in which block {} is beyond its `toppling_angles`",
                      i / blocks + 1, i % blocks + 1));
}

/// To half the digits of single precision, which an angle has that is read back from its cosine.
void require_same(const char* field, std::size_t block, double got, double asked) {
  const double apart = std::sqrt(std::numeric_limits<float>::epsilon()) * (1 + std::abs(asked));
  require(
      std::abs(got - asked) <= apart,
      fmt::format("`{}` must begin with the start; block {} has {} there, not {}", field, block, asked, got));
}

/// Places may be missing.
void require_start(const Setup& setup, const Trajectory& made) {
  for (std::size_t k = 0; k < setup.blocks.size(); ++k) {
    const Placement& block = setup.blocks[k];
    require_same("angles", k + 1, made.angles[k], block.angle);
    require_same("velocities", k + 1, made.velocities[k], block.angular_velocity);
    if (made.bodies.empty()) continue;
    const BodyState& body = made.bodies[k];
    require_same("bodies.x", k + 1, body.x, block.x);
    require_same("bodies.y", k + 1, body.y, block.y);
    require_same("bodies.velocity_x", k + 1, body.velocity_x, block.velocity_x);
    require_same("bodies.velocity_y", k + 1, body.velocity_y, block.velocity_y);
  }
}

/// The largest difference of an angle or angular velocity at the start, rad or rad/s; infinite for another
/// number of samples.
double distance_from_start(const Trajectory& made, const Setup& setup) {
  const std::size_t blocks = setup.blocks.size(), has = made.angles.size();
  const bool whole = has == (setup.steps + 1) * blocks && made.velocities.size() == has;
  if (!whole && (has < blocks || made.velocities.size() < blocks || !has_ended(setup, made))) return HUGE_VAL;
  double distance = 0;
  for (std::size_t k = 0; k < blocks; ++k)
    distance = std::max({distance, std::abs(made.angles[k] - setup.blocks[k].angle),
                         std::abs(made.velocities[k] - setup.blocks[k].angular_velocity)});
  return distance;
}

void require_contacts(const ContactRecord& contacts, std::size_t samples, const Setup& setup) {
  require_count("contacts.elastic", contacts.elastic.size(), samples, "one for each sample");
  require_range("contacts.elastic", contacts.elastic, 0);
  require_range("contacts.complementarity", contacts.complementarity, 0);
  require_range("contacts.friction_excess", contacts.friction_excess, 0);
  // Both follow from parameters within their ranges, however large or small they come out.
  constexpr double infinity = std::numeric_limits<double>::infinity();
  require_range("contacts.stiffness", contacts.stiffness, 0, infinity);
  require_range("contacts.damping", contacts.damping, 0, std::numeric_limits<double>::max());
  require_range("contacts.points", contacts.points, 1);
  const double end = static_cast<double>(samples - 1) * setup.dt;
  for (const ContactImpact& impact : contacts.impacts) {
    require_range("contacts.impacts.time", impact.time, 0, end);
    require_range("contacts.impacts.interface", impact.interface, 1,
                  static_cast<double>(setup.blocks.size()));
    require_range("contacts.impacts.speed", impact.speed, 0);
    require_range("contacts.impacts.after", impact.after, -largest_number);
  }
}

void require_reactions(const std::vector<Reaction>& reactions, std::size_t count) {
  require_count("reactions.normal", reactions.size(), count, "one for each step and interface");
  for (const Reaction& reaction : reactions) {
    require_range("reactions.normal", reaction.normal, -largest_number);
    require_range("reactions.tangential", reaction.tangential, -largest_number);
    if (!std::isnan(reaction.centre)) require_range("reactions.centre", reaction.centre, -largest_number);
  }
}

}  // namespace

void check_descriptions(const std::vector<EngineDescription>& engines) {
  require(!engines.empty(), "engines", "[]", "a list of at least one");
  std::set<std::string> names;
  const std::vector<std::string> taken = taken_names();
  for (const EngineDescription& engine : engines) {
    require(is_word(engine.name, "-"), "name", engine.name, "small letters, digits and '-', at most 60");
    require(std::ranges::find(taken, engine.name) == taken.end(), "name", engine.name,
            fmt::format("another one than {}, which are not engines'", fmt::join(taken, ", ")));
    require(is_word(engine.solver, "-"), "solver", engine.solver,
            "small letters, digits and '-', at most 60");
    require(names.insert(engine.name + ":" + engine.solver).second, "solver", engine.solver,
            "another one for each of an engine's");
    require(is_line(engine.version), "version", engine.name, "one line");
    require(is_line(engine.licence), "licence", engine.name, "one line");
    const Capabilities& able = engine.capabilities;
    require(able.largest_friction >= 0, "largest_friction", fmt::format("{}", able.largest_friction),
            "a number ≥ 0");
    for (const double lead : {able.lead, able.tuned_lead})
      require(std::abs(lead) <= 1, "lead", fmt::format("{}", lead), "a number from -1 to 1");
    std::set<std::string> settings;
    for (const Setting& setting : engine.settings) {
      check_setting(setting);
      require(settings.insert(setting.name).second, "setting name", setting.name, "given once");
    }
  }
}

void require_answer(const RunReply& reply, const RunRequest& asked) {
  static constexpr std::array states{"done", "failed", "not finite", "memory limit"};
  require(std::ranges::find(states, reply.status) != states.end(),
          "`status` must be \"done\", \"failed\", \"not finite\" or \"memory limit\"");
  require_range("peak_memory", reply.peak_memory, 0);
  if (reply.status != "done") return;
  const Trajectory& made = reply.trajectory;
  const std::size_t blocks = asked.setup.blocks.size();
  require(made.bodies.empty() || asked.bodies, "`bodies` must be left out, they are not asked for");
  require(!made.contacts || asked.bodies, "`contacts` must be left out, `bodies` are not asked for");
  require(made.reactions.empty() || asked.reactions, "`reactions` must be left out, they are not asked for");
  require(!made.bodies.empty() || !asked.bodies, "`bodies` must be there, they are asked for");
  require_all_samples(asked.setup, made);
  if (asked.bodies) require_count("bodies.x", made.bodies.size(), made.angles.size(), "as many as `angles`");
  require_finite(made, blocks, asked.setup.dt);
  require_start(asked.setup, made);
  const std::size_t samples = made.angles.size() / blocks;
  require_count("seconds", reply.seconds.size(), asked.repeats, "one for each of `repeats`");
  require_range("seconds", reply.seconds, 0);
  require_range("warnings", static_cast<double>(made.warnings), 0, static_cast<double>(samples - 1));
  if (made.contacts) require_contacts(*made.contacts, samples, asked.setup);
  if (!made.reactions.empty()) require_reactions(made.reactions, (samples - 1) * blocks);
}

bool answers_rather(const Trajectory& made, const Setup& other, const Setup& asked) {
  return distance_from_start(made, other) < distance_from_start(made, asked);
}

}  // namespace rockstack
