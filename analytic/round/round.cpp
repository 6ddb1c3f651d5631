#include "analytic/round/round.hpp"

#include "analytic/polynomials/crossing.hpp"
#include "analytic/round/forms.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "analytic/steps/body_force.hpp"

namespace rockstack {
namespace {

constexpr std::size_t terms = max_terms<double>;

/// Where a function that changes sign on [0, 1] does, by bisection to rounding.
template <class Function>
double sign_change(const Function& function) {
  double low = 0, high = 1;
  const bool at_low = function(low) > 0;
  for (int i = 0; i < std::numeric_limits<double>::digits; ++i) {
    const double middle = (low + high) / 2;
    ((function(middle) > 0) == at_low ? low : high) = middle;
  }
  return high;
}

/// The ground's motion as scenes of blocks have it, with that along y where they have a push.
Scene walked(const RoundScene& scene) {
  Scene ground;
  ground.duration = scene.duration;
  ground.horizontal = scene.x;
  ground.vertical = scene.z;
  ground.pushes = {{.point = {}, .direction = 0, .force = scene.y}};
  return ground;
}

/// Steps of a motion, after which it is not followed any further.
constexpr std::size_t most_steps = 10'000'000;

template <class Form>
class RoundSolver {
 public:
  RoundSolver(const RoundScene& scene, const std::vector<double>& times)
      : scene_(scene),
        toppling_(toppling_angle(planar_scene(scene, 0), 0)),
        ground_(walked(scene)),
        pieces_(ground_),
        times_(times) {}

  RoundMotion run(const Rolling<double>& start) {
    if (start.tilt > 0) row_ = form_.row(start);
    bool rolls = start.tilt > 0;
    for (std::size_t steps = 0; !pieces_.finished() && !motion_.toppled; ++steps) {
      if (steps == most_steps)
        throw std::runtime_error("there are too many steps at " + number_text(pieces_.time()) + " s");
      if (rolls)
        step();
      else
        rolls = stand();
      if (!(pieces_.remaining() > 0)) pieces_.advance();
    }
    return std::move(motion_);
  }

 private:
  /// What is felt over a step, from here on.
  Felt<Jet> felt_over(double length) const {
    const auto force = scaled_body_force(body_.gravity, pieces_.current(), pieces_.offset(), length);
    const auto over = [&](double sign, const Polynomial<double>& series) {
      return jet(terms, [&](std::size_t n) { return sign * coefficient(series, n) / (length * length); });
    };
    return {over(-1, force.x), over(1, force.pushes[0]), over(-1, force.y)};
  }

  /// The longest step that the ground allows, s.
  double longest() const { return std::min(pieces_.remaining(), longest_series(pieces_.current())); }

  /// Stands until what is felt passes the edge of the base, or as long as a series of it holds. Returns
  /// whether the column has lifted.
  bool stand() {
    const double length = longest(), start = pieces_.time(), slope = body_.radius / body_.half_height;
    const Felt<Jet> felt = felt_over(length);
    const Jet margin = slope * slope * (felt.up * felt.up) - felt.x * felt.x - felt.y * felt.y;
    const auto lifts = first_crossing(margin.series);
    const double share = lifts.value_or(1);
    for (; next_ < times_.size() && times_[next_] <= start + share * length; ++next_)
      note_sample({}, times_[next_]);
    pieces_.go(share * length);
    if (lifts) lift();
    return lifts.has_value();
  }

  /// Starts to roll over the rim on the side to which the column is thrown, θ ~ t³. For the first instants it
  /// is in a plane, which turns with what is felt; what that leaves out of ψ decays as t^(−9/4) (the solution
  /// of (t⁶ψ')' + κt³ψ = 0 by Liouville and Green).
  void lift() {
    event(RoundEvent::lift, {}, pieces_.time());
    const double length =
        std::min(1e-4 * std::sqrt(body_.half_height / body_.gravity), pieces_.remaining() / 2);
    const Felt<Jet> felt = felt_over(length);
    const auto [x, x_rate] = tangent(felt.x.series, 1.0);
    const auto [y, y_rate] = tangent(felt.y.series, 1.0);
    const double along = std::hypot(x, y);
    form_ = {-x / along, -y / along};
    // At θ = 0 the moment about the rim is linear in what is felt, and zero as it lifts.
    double tilt = 0, advance = 0;
    for (std::size_t n = 1; n < terms; ++n) {
      const double pushed = -(form_.east * felt.x[n] + form_.north * felt.y[n]);
      const double moment = body_.half_height * pushed - body_.radius * felt.up[n];
      const double share = moment / body_.contact * length * length / static_cast<double>(n + 1);
      advance += share;
      tilt += share / static_cast<double>(n + 2);
    }
    pieces_.go(length);
    const double turn = (x * y_rate - y * x_rate) / (along * along * length);
    row_ = form_.row({tilt, advance / length, -turn * tilt, 0, 0});
  }

  /// Makes a step: orders of the series one by one, each from the rates of those before.
  void step() {
    const double length = std::min(longest_, longest());
    const Felt<Jet> felt = felt_over(length);
    std::array<Jet, Form::size> series;
    for (std::size_t i = 0; i < Form::size; ++i) put(series[i].series, 0, row_[i]);
    for (std::size_t n = 1; n < terms; ++n) {
      const auto cut = [n](const Jet& whole) { return jet(n, [&](std::size_t i) { return whole[i]; }); };
      Row<Jet> known;
      std::copy(series.begin(), series.end(), known.begin());
      const Row<Jet> rate = form_.template rates<Jet>(body_, known, {cut(felt.x), cut(felt.y), cut(felt.up)});
      for (std::size_t i = 0; i < Form::size; ++i)
        put(series[i].series, n, length * rate[i][n - 1] / static_cast<double>(n));
    }
    const double share = std::min(converged(series), longest() / length);
    for (Jet& each : series) rescale(each.series, share);
    longest_ = share * length;
    take(series, longest_);
  }

  /// The step's length over that of the series at which the last two terms are below rounding.
  double converged(const std::array<Jet, Form::size>& series) const {
    const Row<double> scales = form_.scales(row_, rate_);
    double share = 1.5;
    for (std::size_t i = 0; i < Form::size; ++i)
      for (const std::size_t n : {terms - 2, terms - 1})
        if (const double last = std::abs(series[i][n]); last > 0)
          share = std::min(share, std::pow(std::numeric_limits<double>::epsilon() / 8 * scales[i] / last,
                                           1 / static_cast<double>(n)));
    return share;
  }

  /// Goes on to the end of a step, or to where the column topples.
  void take(const std::array<Jet, Form::size>& series, double length) {
    const double start = pieces_.time();
    const auto row_at = [&](double s) {
      Row<double> row{};
      for (std::size_t i = 0; i < Form::size; ++i) row[i] = value(series[i].series, s);
      return row;
    };
    const auto at = [&](double s) { return form_.rolling(row_at(s)); };
    const Rolling<double> first = at(0), last = at(1);
    if (!(last.tilt > 0))
      throw std::domain_error("the base lands flat at about " + number_text(start) +
                              " s, before anything moves it sideways: what follows is open");
    const bool falls = last.tilt > toppling_;
    const double end = falls ? sign_change([&](double s) { return at(s).tilt - toppling_; }) : 1;
    note(state_of(first, start));
    for (; next_ < times_.size() && times_[next_] <= start + end * length; ++next_)
      note_sample(at(std::min(end, (times_[next_] - start) / length)), times_[next_]);
    // Steady precession turns at rounding's will.
    const bool clear =
        std::max(std::abs(first.tilt_rate), std::abs(last.tilt_rate)) > 1e-9 * rate_ * last.tilt;
    if (clear && !falls && (first.tilt_rate > 0) != (last.tilt_rate > 0)) {
      const double s = sign_change([&](double point) { return at(point).tilt_rate; });
      event(last.tilt_rate > 0 ? RoundEvent::passage : RoundEvent::peak, at(s), start + s * length);
    }
    if (falls) {
      motion_.toppled = start + end * length;
      event(RoundEvent::topple, at(end), *motion_.toppled);
    }
    row_ = row_at(1);
    pieces_.go(length);
  }

  RoundState state_of(Rolling<double> rolling, double time) const {
    rolling.azimuth += rolling.tilt > 0 ? std::atan2(form_.north, form_.east) : 0;
    return {time, rolling, support(body_, rolling, felt_at(scene_, time)), energy(body_, rolling)};
  }

  void event(RoundEvent kind, const Rolling<double>& rolling, double time) {
    motion_.events.emplace_back(kind, state_of(rolling, time));
    note(motion_.events.back().second);
  }

  void note_sample(const Rolling<double>& rolling, double time) {
    motion_.samples.push_back(state_of(rolling, time));
    note(motion_.samples.back());
  }

  void note(const RoundState& state) {
    motion_.largest_tilt = std::max(motion_.largest_tilt, state.rolling.tilt);
    motion_.demand.normal = std::min(motion_.demand.normal, state.support.normal);
    motion_.demand.friction = std::max(motion_.demand.friction, state.support.friction);
  }

  const RoundScene& scene_;
  Cylinder body_ = scene_.body();
  double rate_ = std::sqrt(body_.gravity / body_.half_height);  ///< √(g/h), 1/s
  double toppling_;                                             ///< rad
  Scene ground_;
  GroundPieces<double> pieces_;
  const std::vector<double>& times_;
  std::size_t next_ = 0;  ///< of the times
  Form form_{1, 0};
  Row<double> row_{};
  double longest_ = 1 / rate_;  ///< s, for the next step
  RoundMotion motion_;
};

Rolling<double> start_of(const RoundScene& scene) {
  const Cylinder body = scene.body();
  const double sine = std::sin(scene.tilt);
  if (!scene.steady) return {scene.tilt, scene.tilt_rate, -scene.precession * sine, scene.spin, 0};
  const double omega1 = -*steady_precession(body, scene.tilt) * sine;
  return {scene.tilt, 0, omega1, -body.half_height / body.radius * omega1, 0};
}

}  // namespace

RoundMotion solve_round(const RoundScene& scene, const std::vector<double>& times) {
  if (const auto direction = plane_of(scene)) return solve_in_plane(scene, *direction, times);
  return scene.equations == RollingEquations::angles
             ? RoundSolver<ByAngles>(scene, times).run(start_of(scene))
             : RoundSolver<ByAxis>(scene, times).run(start_of(scene));
}

}  // namespace rockstack
