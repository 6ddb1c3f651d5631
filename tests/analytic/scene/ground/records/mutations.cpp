#include "tests/analytic/scene/ground/records/mutations.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

#include "analytic/scene/ground/records/record_file.hpp"
#include "analytic/scene/messages/input_error.hpp"
#include "tests/analytic/scene/ground/records/layouts.hpp"

namespace rockstack {
namespace {

std::size_t below(std::size_t bound, std::mt19937_64& random) {
  return std::uniform_int_distribution<std::size_t>(0, bound - 1)(random);
}

constexpr std::array insertions{"nan", "-inf",  "1e999",    "1e-999", "99999999999999999999",
                                "-1",  "0",     "(",        ")",      "\n",
                                "\r",  "\t",    "-999.0",   "1.7e38", "=",
                                ":",   "(8F0)", "****",     "NPTS",   "/&",
                                "|",   "E",     "(0F10.5)", "\x80"};

void wound(std::string& text, std::mt19937_64& random) {
  const std::size_t at = below(text.size(), random);
  const std::size_t length = 1 + below(30, random);
  switch (below(6, random)) {
    case 0:
      text[at] = static_cast<char>(below(256, random));
      break;
    case 1:
      text[at] = "0123456789+-.eE "[below(16, random)];
      break;
    case 2:
      text.erase(at, length);
      break;
    case 3:
      text.insert(at, insertions[below(insertions.size(), random)]);
      break;
    case 4:
      text.insert(below(text.size(), random), text.substr(at, length));
      break;
    default:
      text.resize(below(8, random) == 0 ? at : text.size());
      break;
  }
}

}  // namespace

std::vector<std::string> one_of_each_layout() {
  const auto samples = made_up_samples();
  const auto even = made_up_samples(20);
  std::vector<std::string> texts{peer_text(samples),
                                 with(peer_text(samples), "NPTS=   19, DT=   0.005 SEC", "19 0.005 NPTS, DT"),
                                 cosmos_channel(samples),
                                 cosmos_channel(samples, "velocity") + cosmos_channel(samples),
                                 volume2_channel(samples) + volume2_channel(samples),
                                 smc_text(samples),
                                 esm_text(samples),
                                 geonet_component(samples),
                                 knet_text(even),
                                 one_column_text(samples),
                                 two_column_text(samples, 0.005)};
  return texts;
}

std::string mutated(std::string text, std::mt19937_64& random) {
  for (std::size_t left = 1 + below(4, random); left > 0 && !text.empty(); --left) wound(text, random);
  return text;
}

Outcome outcome_of(const std::string& text) {
  try {
    for (const Record& record : records::read_series("file", text)) {
      if (!(record.interval > 0) || !std::isfinite(record.interval))
        throw std::logic_error("time step: " + text);
      if (record.samples.empty()) throw std::logic_error("no samples: " + text);
      for (const double sample : record.samples) {
        if (!std::isfinite(sample)) throw std::logic_error("not finite: " + text);
      }
    }
    return Outcome::record;
  } catch (const InputError& error) {
    const std::string line = error.what();
    if (!line.starts_with("file:") || line.find('\n') != std::string::npos)
      throw std::logic_error("error: " + line);
    return Outcome::refused;
  }
}

}  // namespace rockstack
