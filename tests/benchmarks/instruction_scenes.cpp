// Solves one scene once, for counting instructions: instruction_scenes NAME; without a name, lists names.

#include <cstdio>
#include <functional>
#include <map>
#include <string>

#include "analytic/scene/ground/synthetic.hpp"
#include "analytic/solve.hpp"

namespace rockstack::benchmarks {
namespace {

struct Question {
  Scene scene;
  SolveOptions options = {};
};

/// Two seconds of blocks that keep rocking: few impacts, so that the smooth motion is what counts.
Question rocking(std::vector<Block> blocks, const std::vector<double>& angles) {
  Question question;
  question.scene.duration = 2;
  question.scene.initial = {angles, std::vector<double>(angles.size(), 0)};
  question.scene.blocks = std::move(blocks);
  return question;
}

const Block slender = make_block(1, 4, 2500);
const Block base = make_block(2, 4, 2500);

Question one_block() {
  return rocking({slender}, {0.15});
}

Question two_blocks() {
  return rocking({slender, slender}, {0.1, -0.1});
}

Question closed_base() {
  return rocking({base, slender}, {0, 0.15});
}

GroundMotion record() {
  GroundMotion motion = make_synthetic({.seed = 1, .peak = 0.5, .duration = 4});
  motion.samples.resize(201);
  return motion;
}

Question with_record(Question question) {
  question.scene.horizontal = record();
  return question;
}

Question with_vertical(Question question) {
  question.scene.vertical = record();
  return with_record(question);
}

Question with_samples(Question question) {
  question.options.sample_times = regular_times(1e-3, question.scene.duration);
  return question;
}

Question with_validity(Question question) {
  question.options.validity = true;
  return question;
}

Question with_friction(Question question, double friction) {
  question.scene.law = Law::unilateral;
  question.scene.friction.assign(question.scene.blocks.size(), friction);
  return question;
}

/// Drums of a column, shaken until many of its interfaces chatter.
Question column(std::size_t drums) {
  Question question = rocking(std::vector<Block>(drums, make_block(1, 1, 2700)), std::vector<double>(drums));
  question.scene.duration = 4;
  question.scene.law = Law::consistent;
  question.scene.horizontal = make_synthetic({.seed = 1, .peak = 6, .duration = 4});
  return question;
}

constexpr double rough = 2;        // nothing slips
constexpr double slippery = 0.15;  // blocks slip while they rock

const std::map<std::string, std::function<Question()>> questions = {
    {"column-3", [] { return column(3); }},
    {"column-4", [] { return column(4); }},
    {"column-6", [] { return column(6); }},
    {"column-8", [] { return column(8); }},
    {"column-12", [] { return column(12); }},
    {"one-block", one_block},
    {"one-block-record", [] { return with_record(one_block()); }},
    {"one-block-record-vertical", [] { return with_vertical(one_block()); }},
    {"one-block-samples", [] { return with_samples(one_block()); }},
    {"one-block-validity", [] { return with_validity(one_block()); }},
    {"one-block-rough", [] { return with_friction(one_block(), rough); }},
    {"one-block-rough-record", [] { return with_friction(with_record(one_block()), rough); }},
    {"one-block-slippery", [] { return with_friction(one_block(), slippery); }},
    {"one-block-slippery-record", [] { return with_friction(with_record(one_block()), slippery); }},
    {"two-blocks-rough", [] { return with_friction(two_blocks(), rough); }},
    {"two-blocks-rough-record", [] { return with_friction(with_record(two_blocks()), rough); }},
    {"two-blocks-slippery", [] { return with_friction(two_blocks(), slippery); }},
    {"two-blocks-slippery-record", [] { return with_friction(with_record(two_blocks()), slippery); }},
    {"two-blocks", two_blocks},
    {"two-blocks-record", [] { return with_record(two_blocks()); }},
    {"two-blocks-record-vertical", [] { return with_vertical(two_blocks()); }},
    {"two-blocks-closed-base", closed_base},
    {"two-blocks-closed-base-record", [] { return with_record(closed_base()); }},
    {"two-blocks-samples", [] { return with_samples(two_blocks()); }},
    {"two-blocks-validity", [] { return with_validity(two_blocks()); }}};

}  // namespace
}  // namespace rockstack::benchmarks

int main(int arguments, char** values) {
  using rockstack::benchmarks::questions;
  if (arguments < 2) {
    for (const auto& question : questions) std::puts(question.first.c_str());
    return 0;
  }
  const auto question = questions.at(values[1])();
  std::printf("%zu events\n", rockstack::solve(question.scene, question.options).events.size());
}
