#pragma once

#include "analytic/mechanics/impact.hpp"
#include "analytic/steps/rk4.hpp"

namespace rockstack {

/// What is left of the chatter of one interface, the others going on as they do.
template <class Real, int N>
struct RestOfChatter {
  int interface;
  Real duration;                                         ///< s
  PatternSolution<Real, N> impact;                       ///< the last one that is followed
  PatternSolution<Real, N> closure;                      ///< the one that stands for all others
  Vector<Real, N> angles;                                ///< at both, rad
  Real fastest;                                          ///< no relative angle accelerates more, rad/s²
  std::array<PatternSolution<Real, N>, 2> flights = {};  ///< accelerations and forces, on either side

  /// By how much velocities differ from those of the closed stack at most, rad/s.
  Vector<Real, N> velocity_jump() const { return impact.relative - closure.relative; }
};

/// Chatter of one interface alone, as a series: impacts that throw it to and fro, and change nothing else.
/// Angles of the others and their momenta are continuous through all of it (EndOfChatter), so that a stack
/// whose interface closes at once moves on as it does after the last impact, but for a share of u³, u the
/// speed at which it would have parted. That share is measured: from one impact on the closed stack is
/// followed past two flights (by Runge–Kutta's method, whose error, of the fifth order of a brief time, is
/// far below), and set beside the stack that would close there. As u falls by r over two flights, what
/// they differ by is 1 − r³ of what closing at the first would have cost. Closing costs less than the
/// resolution from the speed on that follows from it, as long as flights keep their length for their speed:
/// where they do not, as where the interface is about to open for good, it is measured anew.
template <class Real, int N>
class ZenoSummation {
 public:
  /// Keeps a reference to `model`. `resolution` is of angles in rad, and of velocities in √(g/H), > 0.
  ZenoSummation(const Model<Real, N>& model, const Real& resolution)
      : model_(model), resolution_(resolution) {}

  /// Whether chatter has to be followed further than it counts: flights are below a coarse resolution sooner.
  bool worthwhile() const { return resolution_ < coarse; }

  /// An impact of a number in the history, to the state after it, `offset` into a ground piece.
  struct Landing {
    const Impact<Real, N>& impact;
    const BeforeImpact<Real, N>& before;
    const PatternSolution<Real, N>& after;
    const GroundPiece<Real>& piece;
    Real offset;
    std::size_t number;
  };

  /// Goes on watching; whether from here on chatter moves the motion by less than the resolution.
  bool below_resolution(const Landing& landing) {
    const int interface = thrown_alone(landing);
    const Real speed = interface < 0 ? Real(0) : abs(landing.after.relative[interface]);
    const bool follows = interface >= 0 && interface == interface_ && landing.number == number_ + 1 &&
                         landing.piece.start == piece_start_;
    number_ = landing.number;
    if (interface < 0 || speed > slow * rate_) {
      interface_ = -1;
    } else if (!follows) {
      watch(landing, interface, speed);
    } else if (++flights_ % 2 == 0) {
      if (flights_ == 2 ? measure(landing, speed) : goes_on_alike(landing, speed)) return speed <= harmless_;
      watch(landing, interface, speed);
    }
    return false;
  }

  /// What is left of chatter that is harmless; nothing where it may have company. `fastest` bounds relative
  /// angular accelerations, rad/s² (EndOfChatter).
  std::optional<RestOfChatter<Real, N>> rest(const Landing& landing, const Real& fastest) const {
    const Real speed = abs(landing.after.relative[interface_]);
    const Real duration = duration_ * (speed / speed_) / (1 - ratio_);
    if (duration > landing.piece.length - landing.offset) return std::nullopt;
    const auto closure = velocities_after(model_, landing.before,
                                          with_closed(landing.after.pattern, Interfaces().set(interface_)));
    RestOfChatter<Real, N> rest{interface_, duration, landing.after, closure, landing.impact.before.angles,
                                fastest};
    if (!others_stay_open(rest)) return std::nullopt;
    const Real change = most_change(landing, rest, speed);
    State<Real, N> flight{landing.after.pattern, rest.angles, rest.closure.relative};
    for (PatternSolution<Real, N>& solution : rest.flights) {
      solution = accelerate(model_, flight, landing.before.directions, landing.piece.at(landing.offset));
      if (!comes_back(rest, solution, change)) return std::nullopt;
      flight.pattern[interface_] = opposite(flight.pattern[interface_]);
    }
    return rest;
  }

 private:
  static constexpr double coarse = 1e-10;
  // In units of √(g/H) and √(H/g): Runge–Kutta's method errs by some 10⁻¹¹ over a brief time, where slow
  // chatter counts by a share of 10⁻⁶.
  static constexpr double slow = 1e-2;
  static constexpr double brief = 2e-2;
  // Bound of r: chatter that falls more slowly lasts so long that the motion changes it on the way.
  static constexpr double brisk = 0.8;
  // A share of u³ that is less is not told from rounding. It lets chatter be summed up from 5·10⁻⁵ on.
  static constexpr double least_share = 2e-3;
  // What is left of it then is so short that nothing changes by as much as this in it.
  static constexpr double distance = 1e-2;
  // What brings flights back has changed where their lengths have by more than this share.
  static constexpr double alikeness = 0.1;

  /// The interface that impacts alone, and goes on to its other side as the others stay as they are; or −1.
  static int thrown_alone(const Landing& landing) {
    const Pattern& from = landing.impact.before.pattern;
    int thrown = -1;
    for (int k = 0; k < from.size; ++k) {
      const bool impacts = landing.impact.impacting.test(k);
      if (landing.after.pattern[k] != (impacts ? opposite(from[k]) : from[k])) return -1;
      if (impacts && thrown >= 0) return -1;
      if (impacts) thrown = k;
    }
    return thrown;
  }

  State<Real, N> closed_at(const Landing& landing, int interface) const {
    const Pattern pattern = with_closed(landing.after.pattern, Interfaces().set(interface));
    const Chain<Real, N> chain = make_chain(model_.stack, pattern, landing.before.directions);
    return {pattern, landing.impact.before.angles,
            nearest_allowed(model_.stack, pattern, chain, landing.before.motion)};
  }

  void watch(const Landing& landing, int interface, const Real& speed) {
    interface_ = interface;
    piece_start_ = landing.piece.start;
    offset_ = landing.offset;
    speed_ = last_speed_ = speed;
    flights_ = 0;
    closed_ = closed_at(landing, interface);
    directions_ = landing.before.directions;
  }

  /// From which speed on closing is harmless; false where chatter falls too slowly to tell.
  bool measure(const Landing& landing, const Real& speed) {
    duration_ = landing.offset - offset_;
    ratio_ = speed / speed_;
    if (!(ratio_ < brisk) || duration_ * rate_ > brief) return false;
    const State<Real, N> found = closed_at(landing, interface_);
    const State<Real, N> followed =
        short_steps_(closed_, directions_, {}, landing.piece, offset_, duration_, {}).at(1);
    const Real angles = (found.angles - followed.angles).cwiseAbs().maxCoeff();
    const Real velocities = (found.velocities - followed.velocities).cwiseAbs().maxCoeff();
    const Real cube = speed_ * speed_ * speed_ / (rate_ * rate_ * rate_);
    const Real cost = std::max<Real>(angles, velocities / rate_) / (1 - ratio_ * ratio_ * ratio_);
    last_offset_ = landing.offset;
    last_speed_ = speed;
    harmless_ = speed_ * cbrt(resolution_ / std::max<Real>(cost, least_share * cube));
    return true;
  }

  /// Whether two more flights were as long as the first two, for their speed.
  bool goes_on_alike(const Landing& landing, const Real& speed) {
    const Real expected = duration_ * (last_speed_ / speed_);
    const bool alike = abs(landing.offset - last_offset_ - expected) <= alikeness * expected;
    last_offset_ = landing.offset;
    last_speed_ = speed;
    return alike;
  }

  bool others_stay_open(const RestOfChatter<Real, N>& rest) const {
    const Vector<Real, N> thrown = rest.velocity_jump();
    for (int k = 0; k < thrown.size(); ++k) {
      if (k == rest.interface || rest.closure.pattern[k] == Contact::closed) continue;
      const Real speed = abs(rest.closure.relative[k]) + 2 * abs(thrown[k]);
      if (abs(rest.angles[k]) <= (speed + rest.fastest * rest.duration) * rest.duration) return false;
    }
    return true;
  }

  /// By how much relative accelerations change through the rest, rad/s²: as the stack moves on, as its rates
  /// change in flights, and as the ground's acceleration does.
  Real most_change(const Landing& landing, const RestOfChatter<Real, N>& rest, const Real& speed) const {
    const Point<Real> ground = landing.piece.at(landing.offset).ground;
    const Point<Real> later = landing.piece.at(landing.offset + rest.duration).ground;
    return (rest.duration * rate_ * rate_ + speed) * rate_ +
           rest.fastest * (later - ground).template lpNorm<1>() / model_.gravity;
  }

  /// Whether a flight comes back, and opens nothing else, with something to spare.
  bool comes_back(const RestOfChatter<Real, N>& rest, const PatternSolution<Real, N>& flight,
                  const Real& change) const {
    for (int k = 0; k < flight.size(); ++k) {
      if (k == rest.interface) {
        const Real back = -Real(sign(flight.pattern[k])) * flight.relative[k];
        if (back * distance < change) return false;
      } else if (flight.pattern[k] == Contact::closed) {
        const Margins<Real> margin = margins(model_.stack, flight.reactions, k);
        const Real whole = (margin.right + margin.left) / 2;
        if (!(std::min(margin.right, margin.left) > distance * whole && whole > flight.rounding[k]) ||
            change > distance * rest.fastest)
          return false;
      }
    }
    return true;
  }

  const Model<Real, N>& model_;
  Real resolution_;
  Rk4Steps<Real, N> short_steps_{model_, {.step = std::numeric_limits<double>::max()}};
  Real rate_ = sqrt(model_.gravity / (2 * model_.stack.half_height.sum()));  ///< √(g/H), 1/s
  // since the impact from which on chatter has been watched
  int interface_ = -1;
  int flights_ = 0;
  std::size_t number_ = 0;  ///< of the last impact
  Real piece_start_{}, offset_{}, speed_{};
  Real last_offset_{}, last_speed_{};  ///< at the last even flight
  State<Real, N> closed_;
  Directions<Real, N> directions_;
  // of its first two flights
  Real duration_{}, ratio_{}, harmless_{};
};

}  // namespace rockstack
