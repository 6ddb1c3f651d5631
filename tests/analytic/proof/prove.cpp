#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "tests/analytic/proof/proved_table.hpp"

namespace rockstack::proof {
namespace {

struct Arguments {
  std::string scene, duration, table, certificate;
  ProofOptions options;
};

void print_summary(const Proof& proof) {
  std::size_t accumulations = 0;
  for (const ProvedEvent& event : proof.events)
    accumulations += event.kind == EventKind::accumulation ? 1 : 0;
  std::printf("%zu events are proved, %zu of them accumulations of impacts, up to %.15g s: %s\n",
              proof.events.size(), accumulations, approximate(proof.until), proof.end.c_str());
  if (!proof.events.empty())
    std::printf("the last one is known to 2^%.0f s; %zu steps\n",
                std::ceil(width_exponent(proof.events.back().time)), proof.steps);
}

/// The scene's file as it stands, what was changed in it, and all inferences.
nlohmann::ordered_json certificate(const Arguments& arguments, const Proof& proof) {
  return {{"scene", arguments.scene},
          {"duration", arguments.duration},
          {"bits", arguments.options.bits},
          {"inferences", proof.witnesses}};
}

int run(const Arguments& arguments) {
  ExactScene scene = read_exact_scene(arguments.scene);
  if (!arguments.duration.empty()) scene.duration = decimal(arguments.duration);
  const Proof proof = prove(scene, arguments.options);
  print_summary(proof);
  if (!arguments.table.empty()) {
    std::ofstream output(arguments.table);
    write_table(output, proof);
  }
  if (!arguments.certificate.empty())
    std::ofstream(arguments.certificate) << certificate(arguments, proof).dump(1);
  return 0;
}

}  // namespace
}  // namespace rockstack::proof

int main(int argc, char** argv) {
  try {
    rockstack::proof::Arguments arguments;
    CLI::App app{"Proves when events of a scene happen, of laws of pivots, in exact inputs."};
    app.add_option("scene", arguments.scene, "a scene file")->required()->check(CLI::ExistingFile);
    app.add_option("--bits", arguments.options.bits, "of numbers")->check(CLI::Range(64, 100000));
    app.add_option("--events", arguments.options.most_events, "at most so many");
    app.add_option("--duration", arguments.duration, "in place of the scene's, s");
    app.add_option("--slow", arguments.options.slow_speed,
                   "chatter below this speed is summed up at once, rad/s");
    app.add_option("--table", arguments.table, "a CSV file for events");
    app.add_option("--certificate", arguments.certificate, "a JSON file for all inferences");
    CLI11_PARSE(app, argc, argv);
    return rockstack::proof::run(arguments);
  } catch (const std::exception& error) {
    std::fputs(error.what(), stderr);
    std::fputs("\n", stderr);
    return 2;
  }
}
