#pragma once

#include <iterator>

#include "analytic/scene/applied_forces.hpp"

namespace rockstack {

/// One component of the ground's acceleration over a stretch of time: a straight line, or part of a pulse; or
/// a push, N for m/s². As gravity along an inclined ground acts like an acceleration of it the other way, it
/// is in here too.
template <class Real>
struct GroundComponent {
  Real end = std::numeric_limits<Real>::infinity();  ///< s
  Real value = 0;                                    ///< at the start, m/s²; beside a pulse a constant
  Real rate = 0;                                     ///< its change, m/s³
  const Pulse* pulse = nullptr;                      ///< in place of the change
  Real elapsed = 0;  ///< from the start of the pulse to that of the stretch, s

  Real at(const Real& offset) const {
    return pulse ? value + acceleration(*pulse, elapsed + offset) : line_at(offset);
  }
  Real line_at(const Real& offset) const { return value + offset * rate; }
};

/// A stretch of time over which the ground's acceleration and pushes are smooth, in the number type of a
/// calculation.
template <class Real>
struct GroundPiece {
  Real start;   ///< s
  Real length;  ///< s, > 0
  GroundComponent<Real> horizontal, vertical;
  std::vector<GroundComponent<Real>> pushes = {};

  Loading<Real> at(const Real& offset) const {
    Loading<Real> loading{horizontal.at(offset), vertical.at(offset)};
    for (const GroundComponent<Real>& push : pushes) loading.sizes[loading.pushes++] = push.at(offset);
    return loading;
  }

  /// True where no component is a pulse.
  bool straight() const {
    return !horizontal.pulse && !vertical.pulse &&
           std::none_of(pushes.begin(), pushes.end(), [](const auto& push) { return push.pulse != nullptr; });
  }
};

/// Walks through a scene's ground motion and pushes piece by piece: pieces end at the samples of any
/// component, where a pulse starts or ends, at steps of velocities, and at the end of the scene. Without
/// ground motion there is one piece.
template <class Real>
class GroundPieces {
 public:
  explicit GroundPieces(const Scene& scene) : scene_(scene), duration_(scene.duration) {
    downhill_ = Real(scene.gravity) * sin(Real(scene.inclination));
    piece_.horizontal.value = 0 - downhill_;
    piece_.pushes.resize(scene.pushes.size());
    push_samples_.resize(scene.pushes.size(), 0);
    has_applied_forces_ = rockstack::has_applied_forces(scene);
    find_piece();
  }

  /// Whether more acts than the acceleration of the ground.
  bool has_applied_forces() const { return has_applied_forces_; }

  /// Whether velocities change at once where the piece starts, and nobody has taken that yet.
  bool steps_now() const { return steps_now_; }
  /// By what they do.
  [[gnu::cold]] Loading<Real> take_steps() {
    steps_now_ = false;
    Loading<Real> sum{step_at(scene_.horizontal), step_at(scene_.vertical)};
    for (const Push& push : scene_.pushes) sum.sizes[sum.pushes++] = step_at(push.force);
    return sum;
  }

  bool finished() const { return !(piece_.start < duration_); }
  const GroundPiece<Real>& current() const { return piece_; }
  /// Where a motion has come to within it, and how much is left of it, s.
  const Real& offset() const { return offset_; }
  Real remaining() const { return piece_.length - offset_; }
  Real time() const { return piece_.start + offset_; }
  void go(const Real& length) { offset_ += length; }

  void advance() {
    piece_.start = end_;
    offset_ = 0;
    find_piece();
  }

  /// A record along the ground, where nothing else moves it: pieces end at its samples alone.
  struct Record {
    const double* samples;
    Real interval;        ///< s
    Real constant;        ///< to be added, m/s²
    std::ptrdiff_t last;  ///< up to, and without, this sample a piece is as long as the interval
  };
  std::optional<Record> record() const {
    const auto& motion = scene_.horizontal;
    if (motion.pulse || motion.samples.empty() || !scene_.vertical.empty()) return std::nullopt;
    const Real whole = std::min<Real>(duration_ / Real(motion.interval), Real(motion.samples.size()));
    return Record{motion.samples.data(), Real(motion.interval), 0 - downhill_,
                  static_cast<std::ptrdiff_t>(whole) - 1};
  }
  /// At which the current piece of a record starts.
  std::ptrdiff_t sample() const { return horizontal_sample_; }

  /// By so many pieces of a record, > 0, of which the last ends at a sample.
  void advance_by(std::ptrdiff_t pieces) {
    horizontal_sample_ += pieces - 1;
    end_ = piece_.horizontal.end = Real(horizontal_sample_ + 1) * Real(scene_.horizontal.interval);
    advance();
  }

  /// Advances past this piece and all on whose samples |ẍg| stays below `limit`, where ẍg is known by samples
  /// and the ground does not move up or down. Precondition: it is below at the end of this one.
  void advance_past(const Real& limit) {
    const auto& samples = scene_.horizontal.samples;
    if (!samples.empty() && end_ == piece_.horizontal.end && scene_.vertical.empty()) {
      std::ptrdiff_t next = horizontal_sample_ + 2;
      while (next < std::ssize(samples) && Real(next) * Real(scene_.horizontal.interval) < duration_ &&
             abs(Real(samples[next]) - downhill_) < limit)
        ++next;
      return advance_by(next - 1 - horizontal_sample_);
    }
    advance();
  }

 private:
  void find_piece() {
    follow(scene_.horizontal, 0 - downhill_, horizontal_sample_, piece_.horizontal);
    follow(scene_.vertical, 0, vertical_sample_, piece_.vertical);
    end_ = std::min({piece_.horizontal.end, piece_.vertical.end, duration_});
    if (has_applied_forces_) follow_pushes_and_steps();
    piece_.length = end_ - piece_.start;
  }

  [[gnu::cold]] void follow_pushes_and_steps() {
    for (std::size_t i = 0; i < piece_.pushes.size(); ++i) {
      follow(scene_.pushes[i].force, 0, push_samples_[i], piece_.pushes[i]);
      end_ = std::min(end_, piece_.pushes[i].end);
    }
    const auto note = [&](const GroundMotion& motion) {
      for (const auto& [time, size] : motion.steps) {
        if (Real(time) == piece_.start) steps_now_ = true;
        if (Real(time) > piece_.start) end_ = std::min(end_, Real(time));
      }
    };
    note(scene_.horizontal);
    note(scene_.vertical);
    for (const Push& push : scene_.pushes) note(push.force);
  }

  Real step_at(const GroundMotion& motion) const {
    Real sum = 0;
    for (const auto& [time, size] : motion.steps)
      if (Real(time) == piece_.start) sum += Real(size);
    return sum;
  }

  /// A component from the start of the piece on, to the next sample after `sample`, which is found anew where
  /// the other component has ended the piece before. `constant` is added to it.
  void follow(const GroundMotion& motion, const Real& constant, std::ptrdiff_t& sample,
              GroundComponent<Real>& component) const {
    if (motion.pulse) {
      component = pulse_component(*motion.pulse, constant);
    } else if (!motion.samples.empty()) {
      sample = component.end == piece_.start ? sample + 1 : last_sample(motion);
      component = line_component(motion, constant, sample);
    }
  }

  GroundComponent<Real> pulse_component(const Pulse& pulse, const Real& constant) const {
    const Real start(pulse.start);
    const Real end = start + Real(length(pulse));
    if (piece_.start < start) return {start, constant};
    if (piece_.start < end) return {end, constant, 0, &pulse, piece_.start - start};
    return still(constant);
  }

  /// Before or at the start of the piece; after the end of the samples any number beyond theirs.
  std::ptrdiff_t last_sample(const GroundMotion& motion) const {
    const Real interval(motion.interval);
    // The quotient of a sample's time by the interval may round to just below its number.
    const auto sample =
        static_cast<std::ptrdiff_t>(std::min<Real>(piece_.start / interval, Real(motion.samples.size())));
    return Real(sample + 1) * interval <= piece_.start ? sample + 1 : sample;
  }

  static GroundComponent<Real> still(const Real& constant) {
    return {std::numeric_limits<Real>::infinity(), constant};
  }

  GroundComponent<Real> line_component(const GroundMotion& motion, const Real& constant,
                                       std::ptrdiff_t sample) const {
    if (sample + 1 >= std::ssize(motion.samples)) return still(constant);
    const Real interval(motion.interval);
    const auto samples = motion.samples.begin() + sample;
    const Real first(samples[0]);
    const Real rate = (Real(samples[1]) - first) / interval;
    return {Real(sample + 1) * interval, first + (piece_.start - Real(sample) * interval) * rate + constant,
            rate};
  }

  const Scene& scene_;
  Real duration_;
  Real downhill_;  ///< gravity along the ground, to the right, m/s²
  GroundPiece<Real> piece_{};
  Real end_ = 0;  ///< of the piece, s
  Real offset_ = 0;
  std::ptrdiff_t horizontal_sample_ = 0;
  std::ptrdiff_t vertical_sample_ = 0;
  std::vector<std::ptrdiff_t> push_samples_;
  bool has_applied_forces_ = false, steps_now_ = false;
};

}  // namespace rockstack
