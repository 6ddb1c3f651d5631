#pragma once

#include "analytic/steps/ground_pieces.hpp"
#include "analytic/unilateral/contact_chatter.hpp"
#include "analytic/unilateral/contact_course.hpp"
#include "analytic/unilateral/contact_demands.hpp"
#include "analytic/unilateral/solve_unilateral.hpp"

namespace rockstack {

/// Goes from event to event of a stack that may slip and lift off.
///
/// An event leaves a force, a gap or a speed at zero to rounding, so that what follows is decided by how it
/// goes on: by the laws of contact as they stand a moment later (10⁻⁷ √(H/g)) on the course that just ended.
/// Of what starts at zero by such a decision, courses are looked at from that moment on.
class ContactSolver {
 public:
  /// Keeps a reference to `scene`.
  ContactSolver(const Scene& scene, const ContactOptions& options);
  /// @throws std::runtime_error where the motion cannot go on.
  void run();
  /// Up to the end, or to where the motion could not go on.
  ContactHistory history() &&;

 private:
  /// The first event of a step.
  struct Found {
    double s = 1;
    std::vector<Course> courses;  ///< those that end there
  };

  void start();
  void advance();
  Found find(const ModeSeries& series) const;
  bool is_fresh(const Course& course) const;
  void handle(const Found& found, const ModeSeries& series);
  bool apply(const Found& found, std::vector<Joint>& joints);
  void land(const Course& course, std::vector<Joint>& joints) const;
  bool pass_corner(int interface, std::vector<Joint>& joints);
  void land_negligible(int interface, std::vector<Joint>& joints) const;
  void close_negligible(std::vector<Joint>& joints) const;
  void collide(const std::vector<Joint>& before, std::vector<Joint> touching, int interface);
  std::vector<BodyPlacement> held_rates(const std::vector<Joint>& joints) const;
  void hold();
  std::vector<Joint> with_slips(std::vector<Joint> mode) const;
  /// Decides by the laws of contact for the moment `later`, s.
  void decide(const std::vector<Joint>& before, const Bodies& moment, double later);
  std::vector<Joint> follow_without_solution(const std::vector<Joint>& joints);
  std::vector<Joint> with_corners(std::vector<Joint> joints, std::vector<Joint> mode, const Bodies& moment,
                                  const FreeVector& free) const;
  bool has_others(const std::vector<Joint>& joints, const std::vector<Joint>& mode, const Bodies& moment,
                  const FreeVector& free) const;
  void mark_fresh(const std::vector<Joint>& before);
  std::vector<Joint> with_fresh(std::vector<Joint> joints) const;

  FreeVector free_acceleration(double later) const;
  double time() const { return pieces_.current().start + offset_; }
  void note_step(const ModeSeries& series, double end_s);
  void sample(const ModeSeries& series, double end_s);
  void note_peaks(const ModeSeries& series, double end_s);
  void note_sample(double time, Bodies bodies);
  void note(ContactEventKind kind, int interface, const std::vector<Joint>& from,
            const std::vector<BodyPlacement>& before, Solutions solutions = Solutions::one);
  void note_stall();

  const Scene& scene_;
  FrictionStack stack_;
  FrictionStack smooth_;  ///< the stack without friction
  GroundPieces<double> pieces_;
  ContactChatter chatter_;
  std::vector<double> toppling_angles_, sample_times_;
  double unit_time_ = 0;  ///< √(H/g), s
  double moment_ = 0;     ///< s
  double longest_ = 0;    ///< step, s
  double offset_ = 0;     ///< into the current piece, s
  Bodies bodies_;
  std::vector<Joint> joints_;
  bool decided_ = false;         ///< the step starts at an event
  std::vector<double> fresh_;    ///< when each joint parted from rest, s
  std::vector<double> slid_;     ///< when each joint started to slide from rest, s
  std::vector<Joint> fresh_of_;  ///< what it was before
  std::size_t next_sample_ = 0;
  double last_decision_ = -1;  ///< s
  double burst_start_ = 0;     ///< s
  int burst_ = 0;
  bool ended_ = false;
  std::optional<ContactDemands> demands_;  ///< where they are asked for
  ContactHistory history_;
};

}  // namespace rockstack
