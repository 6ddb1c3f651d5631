#include "analytic/scene/input/ground_reader.hpp"

#include "analytic/scene/ground/records/record_file.hpp"
#include "analytic/scene/ground/synthetic.hpp"
#include "analytic/scene/input/fields.hpp"
#include "analytic/scene/input/scene_keys.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {
namespace {

GroundMotion from_record(const Node& table, const Node& node, const std::filesystem::path& folder,
                         MotionLibrary& library) {
  require_table(table, record_keys);
  const std::filesystem::path name = folder / text(node);
  const std::filesystem::path file = record_file(name);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    throw wrong_value(node, "a record's file, none is at " + one_line(file.string()));
  }
  GroundMotion motion = *library.record(name);
  motion.source = node.text + " (" + motion.source + ")";
  return motion;
}

GroundMotion from_samples(const Node& table, const Node& samples) {
  require_table(table, samples_keys);
  GroundMotion motion{required_number(table, "interval"), numbers(samples), "samples in the scene file"};
  if (motion.empty()) throw wrong_value(samples, "at least one number");
  return motion;
}

GroundMotion from_pulse(const Node& table, const Node& shape) {
  Pulse pulse;
  pulse.shape = choice<PulseShape>(shape, {{"sine", PulseShape::sine},
                                           {"cosine", PulseShape::cosine},
                                           {"half-sine", PulseShape::half_sine},
                                           {"rectangle", PulseShape::rectangle},
                                           {"ricker", PulseShape::ricker},
                                           {"mavroeidis-papageorgiou", PulseShape::mavroeidis_papageorgiou}});
  if (pulse.shape == PulseShape::mavroeidis_papageorgiou) {
    require_table(table, near_fault_keys);
    pulse.cycles = required_number(table, "cycles");
    pulse.phase = number_or(table, "phase", pulse.phase);
  } else if (pulse.shape == PulseShape::sine || pulse.shape == PulseShape::cosine) {
    require_table(table, harmonic_keys);
    pulse.cycles = number_or(table, "cycles", pulse.cycles);
  } else {
    require_table(table, pulse_keys);
  }
  pulse.amplitude = required_number(table, "amplitude");
  pulse.period = required_number(table, "period");
  pulse.start = number_or(table, "start", pulse.start);
  GroundMotion motion;
  motion.source = shape.text + " pulse";
  motion.pulse = pulse;
  return motion;
}

GroundMotion from_synthetic(const Node& table, const Node& seed, MotionLibrary& library) {
  require_table(table, synthetic_keys);
  SyntheticMotion motion;
  motion.seed = static_cast<std::uint64_t>(whole_number(seed, 0, largest_seed));
  motion.peak = required_number(table, "peak");
  motion.duration = number_or(table, "duration", motion.duration);
  motion.interval = number_or(table, "interval", motion.interval);
  motion.frequency = number_or(table, "frequency", motion.frequency);
  motion.damping = number_or(table, "damping", motion.damping);
  validate(motion, table.key);
  GroundMotion result = *library.synthetic(motion);
  for (double& sample : result.samples) sample *= motion.peak;
  return result;
}

GroundMotion unscaled(const Node& table, const std::filesystem::path& folder, MotionLibrary& library) {
  if (const Node* record = find(table, "record")) return from_record(table, *record, folder, library);
  if (const Node* samples = find(table, "samples")) return from_samples(table, *samples);
  throw missing_key(table, "record", "given, or samples and interval, or a pulse or synthetic in its place");
}

void scale_by(GroundMotion& motion, const Node& node) {
  const double factor = number(node);
  require_signed(node.key, factor);
  for (double& sample : motion.samples) sample *= factor;
}

void scale_to_peak(GroundMotion& motion, const Node& node) {
  const double wanted = number(node);
  require_positive(node.key, wanted);
  const double largest = peak(motion);
  if (largest == 0) throw wrong_value(node, "left out where every sample is zero");
  // Divided first, so that the largest sample comes out as the peak to the last bit.
  for (double& sample : motion.samples) sample = sample / largest * wanted;
}

}  // namespace

GroundMotion read_ground_motion(const Node& table, const std::filesystem::path& folder,
                                MotionLibrary& library) {
  if (const Node* pulse = find(table, "pulse")) return from_pulse(table, *pulse);
  if (const Node* seed = find(table, "synthetic")) return from_synthetic(table, *seed, library);
  GroundMotion motion = unscaled(table, folder, library);
  const Node* scale = find(table, "scale");
  const Node* wanted_peak = find(table, "peak");
  if (scale != nullptr && wanted_peak != nullptr) throw excluded_key(*wanted_peak, *scale);
  if (scale != nullptr) scale_by(motion, *scale);
  if (wanted_peak != nullptr) scale_to_peak(motion, *wanted_peak);
  return motion;
}

}  // namespace rockstack
