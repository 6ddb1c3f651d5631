#include "tests/analytic/proof/prover.hpp"

#include <algorithm>
#include <cmath>

namespace rockstack::proof {
namespace {

/// A time that is known no better than this, as a power of 2 of a second, is no proved digit any more.
constexpr double coarsest = -60;

/// The largest whole-number exponent of two of all widths of a state.
double widest(const Motion& motion) {
  double result = -std::numeric_limits<double>::infinity();
  for (const std::vector<Ball>* values : {&motion.angles, &motion.rates})
    for (const Ball& value : *values) result = std::max(result, width_exponent(value));
  return result;
}

bool at_rest(const Pattern& pattern) {
  return std::all_of(pattern.begin(), pattern.end(), [](int side) { return side == 0; });
}

class Prover {
 public:
  Prover(const ExactScene& scene, const ProofOptions& options)
      : options_(options), paper_(scene.paper), stack_(make_stack(scene)), pieces_(ground_pieces(scene)) {
    start(scene);
  }

  Proof run() {
    try {
      while (!proof_.whole && proof_.events.size() < options_.most_events) advance();
      if (!proof_.whole) proof_.end = "so many events were asked for";
    } catch (const Undecided& undecided) {
      proof_.end = undecided.what();
    }
    proof_.until = motion_.time;
    proof_.witnesses.push_back({{"kind", "end"}, {"why", proof_.end}});
    return std::move(proof_);
  }

 private:
  void start(const ExactScene& scene) {
    Rational angle_below, rate_below;
    for (std::size_t k = 0; k < stack_.size(); ++k) {
      const Rational angle = scene.angles[k] - angle_below;
      const Rational rate = scene.velocities[k] - rate_below;
      const int side = angle.sign() != 0 ? angle.sign() : rate.sign();
      motion_.pattern.push_back(side);
      motion_.angles.emplace_back(angle);
      motion_.rates.emplace_back(rate);
      motion_.zeros.push_back(angle.sign() == 0 && side != 0 ? 1 : 0);
      angle_below = scene.angles[k];
      rate_below = scene.velocities[k];
    }
  }

  const GroundPiece& piece() const { return pieces_[piece_]; }
  Ball offset() const { return motion_.time - Ball(piece().start); }
  Ball left() const { return Ball(piece().end) - motion_.time; }

  void end(const std::string& why) {
    proof_.end = why;
    proof_.whole = true;
  }

  /// Goes on to the next event, or a step.
  void advance() {
    if (open_at_once()) return;
    if (rests_for_ever()) return end("the stack rests for ever");
    const Ball here = offset();
    const Enclosure enclosure = enclose(stack_, motion_, piece(), here, radius_);
    const double longest = landing_soon(radius_ / 8);
    radius_ *= 1.4;
    const bool ends_piece = !negative(Ball(longest) - left());
    const Ball length = ends_piece ? magnitude(left()) : Ball(longest);
    if (!positive(left())) throw Undecided("an event where a ground piece ends");
    const Motion before = motion_;
    const Step step(stack_, before, piece(), here, enclosure, length);
    ++proof_.steps;
    follow(step, ends_piece);
  }

  /// Through a step to its first event, or its end.
  void follow(const Step& step, bool ends_piece) {
    std::vector<ZeroSearch> searches;
    for (const Watched& watched : step.watched()) searches.push_back(step.search(watched));
    const std::size_t first = first_of(step, searches);
    if (first == searches.size()) {
      proof_.witnesses.push_back(step_witness(step, searches, ends_piece));
      return go(step, ends_piece);
    }
    const Watched& watched = step.watched()[first];
    const Ball time = *searches[first].zero;
    if (ends_piece && !positive(left() - time)) throw Undecided("an event where a ground piece ends");
    proof_.witnesses.push_back(event_witness(step, searches, watched, time));
    Motion next = step.at(time);
    next.time = motion_.time + time;
    motion_ = std::move(next);
    if (width_exponent(motion_.time) > coarsest) throw Undecided("all bits are used up");
    handle(watched);
  }

  /// To the end of a step, or of the ground's piece.
  void go(const Step& step, bool ends_piece) {
    Motion next = step.at(ends_piece ? left() : step.length());
    next.time = ends_piece ? Ball(piece().end) : motion_.time + step.length();
    motion_ = std::move(next);
    if (!ends_piece) return;
    if (++piece_ == pieces_.size()) end("the end of the scene");
  }

  /// The guard that is zero first; their number where none is. @throws Undecided
  std::size_t first_of(const Step& step, const std::vector<ZeroSearch>& searches) const {
    std::size_t first = searches.size();
    for (std::size_t i = 0; i < searches.size(); ++i)
      if (searches[i].zero &&
          (first == searches.size() || approximate(*searches[i].zero) < approximate(*searches[first].zero)))
        first = i;
    for (std::size_t i = 0; i < searches.size(); ++i)
      if (i != first && searches[i].zero &&
          !positive(lower(*searches[i].zero) - upper(*searches[first].zero)))
        throw Undecided("two events at one time: of interfaces " +
                        std::to_string(step.watched()[first].interface + 1) + " and " +
                        std::to_string(step.watched()[i].interface + 1));
    return first;
  }

  void handle(const Watched& watched) {
    const std::size_t k = watched.interface;
    const Pattern from = motion_.pattern;
    if (watched.kind == EventKind::impact) return impact(k);
    if (watched.kind == EventKind::opening) {
      motion_.pattern[k] = watched.side;
      motion_.zeros[k] = 3;
      chattering_ = stack_.size();
    }
    note(watched.kind, k, from);
    if (watched.kind == EventKind::topple) end("a block topples");
  }

  void impact(std::size_t k) {
    const Pattern from = motion_.pattern;
    const Ball speed = Ball(-from[k]) * motion_.rates[k];
    if (!positive(speed)) throw Undecided("a closing speed");
    motion_.angles[k] = motion_.rates[k] = Ball();
    const Decision decision = unit_impact(stack_, paper_, from, k, motion_.angles);
    proof_.witnesses.push_back(decision_witness("impact", k, decision));
    motion_.pattern = decision.pattern;
    for (std::size_t j = 0; j < from.size(); ++j) {
      const bool touched = j == k || from[j] == 0;
      motion_.zeros[j] = motion_.pattern[j] && touched ? 1 : 0;
      motion_.rates[j] = motion_.pattern[j] ? motion_.rates[j] + speed * decision.rates[j] : Ball();
    }
    note(EventKind::impact, k, from);
    const bool again = chattering_ == k;
    chattering_ = motion_.pattern[k] ? k : stack_.size();
    if (again && motion_.pattern[k] && slow(motion_.rates[k])) accumulate_here(k);
  }

  bool slow(const Ball& rate) const {
    const double speed = std::abs(approximate(rate));
    return speed < options_.slow_speed || (speed < 1e-3 && 2 * std::log2(speed) < widest(motion_) + 2);
  }

  void accumulate_here(std::size_t k) {
    const Pattern from = motion_.pattern;
    const Accumulation accumulation = accumulate(stack_, paper_, motion_, k, piece(), offset(), left());
    proof_.witnesses.push_back(accumulation_witness(k, accumulation));
    motion_ = accumulation.after;
    chattering_ = stack_.size();
    note(EventKind::accumulation, k, from);
    if (width_exponent(motion_.time) > coarsest) throw Undecided("all bits are used up");
  }

  void note(EventKind kind, std::size_t k, const Pattern& from) {
    proof_.events.push_back({kind, k, from, motion_.pattern, motion_.time,
                             summed(motion_.pattern, motion_.angles),
                             summed(motion_.pattern, motion_.rates)});
  }

  /// Where a margin is not positive now.
  bool open_at_once() {
    const Ball here = offset();
    const Point<Ball> ground{acceleration(piece().horizontal, here), acceleration(piece().vertical, here)};
    const Accelerations<Ball> found =
        accelerate(stack_, motion_.pattern, motion_.angles, motion_.rates, ground);
    bool held = true;
    for (std::size_t k = 0; k < stack_.size(); ++k)
      if (!motion_.pattern[k])
        held = held && positive(found.margins[k].right) && positive(found.margins[k].left);
    if (held) return false;
    const Decision decision = opening_at_once(stack_, motion_.pattern, motion_.angles, motion_.rates, ground);
    const Pattern from = motion_.pattern;
    std::size_t first = stack_.size();
    for (std::size_t k = 0; k < from.size(); ++k) {
      if (decision.pattern[k] == from[k]) continue;
      motion_.zeros[k] = 2;
      first = std::min(first, k);
    }
    motion_.pattern = decision.pattern;
    proof_.witnesses.push_back(decision_witness("opening at once", first, decision));
    note(EventKind::opening, first, from);
    return true;
  }

  bool rests_for_ever() const {
    return at_rest(motion_.pattern) && piece_ + 1 == pieces_.size() && piece().horizontal.still() &&
           piece().vertical.still();
  }

  /// A first guess of the step: a little past the landing that present accelerations foresee, or the longest
  /// one.
  double landing_soon(double longest) const {
    const Ball here = offset();
    const Accelerations<Ball> found =
        accelerate(stack_, motion_.pattern, motion_.angles, motion_.rates,
                   {acceleration(piece().horizontal, here), acceleration(piece().vertical, here)});
    double result = longest;
    for (std::size_t k = 0; k < stack_.size(); ++k) {
      const int side = motion_.pattern[k];
      const double angle = side * approximate(motion_.angles[k]);
      const double rate = side * approximate(motion_.rates[k]);
      const double half = side * approximate(found.relative[k]) / 2;
      const double discriminant = rate * rate - 4 * angle * half;
      if (side == 0 || motion_.zeros[k] > 1 || !(half < 0) || !(discriminant > 0)) continue;
      const double time = (-rate - std::sqrt(discriminant)) / (2 * half);
      if (time > 0) result = std::min(result, 1.25 * time);
    }
    return result;
  }

  ProofOptions options_;
  bool paper_;
  Stack stack_;
  std::vector<GroundPiece> pieces_;
  Motion motion_;
  std::size_t piece_ = 0;
  double radius_ = 0.3;          ///< s, of the next disc to be tried
  std::size_t chattering_ = 32;  ///< the interface of the last event where that was an impact; else none
  Proof proof_;
};

}  // namespace

Proof prove(const ExactScene& scene, const ProofOptions& options) {
  const Precision bits(options.bits);
  return Prover(scene, options).run();
}

}  // namespace rockstack::proof
