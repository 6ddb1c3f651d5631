#include "analytic/solve.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "analytic/scene/messages/number_text.hpp"
#include "analytic/solve_batch.hpp"
#include "comparisons/interfaces/python/module.hpp"
#include "comparisons/runs/execution/executor.hpp"
#include "comparisons/suites/compare_choice.hpp"

namespace rockstack::python {
namespace {

using Times = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// What of a motion is asked for.
struct SolveRequest {
  SolveOptions options = {.validity = true, .peaks = true};
  std::optional<double> interval;  ///< between samples, s

  SolveOptions of(const Scene& scene, const std::function<bool()>& cancelled) const {
    SolveOptions result = options;
    if (interval) result.sample_times = regular_times(*interval, scene.duration);
    result.cancelled = &cancelled;
    return result;
  }
};

/// A motion, whole or up to where it could not be followed, and then why.
using Outcome = std::pair<std::shared_ptr<HeldMotion>, std::optional<std::string>>;

std::vector<double> sample_times(const Times& times) {
  if (times.ndim() != 1)
    throw InputError("times = an array of " + std::to_string(times.ndim()) + " dimensions: must have one");
  std::vector<double> list(times.data(), times.data() + times.size());
  double last = 0;
  for (const double time : list) {
    if (!(time >= last && time < std::numeric_limits<double>::infinity()))
      throw InputError("times: " + number_text(time) + " s after " + number_text(last) +
                       " s: must be numbers that ascend from 0 or later");
    last = time;
  }
  return list;
}

SolveRequest make_request(const std::optional<double>& interval, const std::optional<Times>& times,
                          const std::string& integrator, double tolerance, double step) {
  SolveRequest request;
  if (integrator != "taylor" && integrator != "rk4")
    throw InputError("integrator = " + integrator + ": must be taylor or rk4");
  request.options.integrator = integrator == "rk4" ? Integrator::rk4 : Integrator::taylor;
  require_above_zero("step", step);
  request.options.step = step;
  request.options.tolerance = request.options.resolution = tolerance;
  if (times) {
    request.options.sample_times = sample_times(*times);
  } else if (interval) {
    require_above_zero("interval", *interval);
    request.interval = interval;
  }
  validate(request.options);
  return request;
}

/// @throws Stopped, or what tells of wrong input.
Outcome outcome_of(const ScenePointer& scene, const std::function<History()>& history) {
  try {
    return {std::make_shared<HeldMotion>(HeldMotion{scene, history()}), std::nullopt};
  } catch (const Unfinished& unfinished) {
    return {std::make_shared<HeldMotion>(HeldMotion{scene, unfinished.history}), unfinished.what()};
  } catch (const std::runtime_error& failure) {
    return {nullptr, failure.what()};
  } catch (const std::domain_error& failure) {
    return {nullptr, failure.what()};
  }
}

Outcome solved(const ScenePointer& scene, const SolveRequest& request,
               const std::function<bool()>& cancelled) {
  return outcome_of(scene, [&] { return solve(scene->scene, request.of(scene->scene, cancelled)); });
}

Outcome solve_one(const ScenePointer& scene, const SolveRequest& request) {
  try {
    const py::gil_scoped_release free;
    return solved(scene, request, interrupts());
  } catch (const Stopped&) {
    throw py::error_already_set();
  }
}

/// Solves scenes side by side, as long as `next` has a number of one.
void solve_side_by_side(const std::vector<ScenePointer>& scenes, const SolveOptions& options,
                        const std::function<std::optional<std::size_t>()>& next,
                        std::vector<Outcome>& outcomes) {
  std::vector<std::size_t> numbers;
  const auto give = [&]() -> std::optional<Scene> {
    const auto number = next();
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    return scenes[*number]->scene;
  };
  solve_batch(give, options, [&](Solved&& solved) {
    const std::size_t number = numbers[solved.number];
    outcomes[number] = outcome_of(scenes[number], [&] {
      if (solved.failure) std::rethrow_exception(solved.failure);
      return std::move(solved.history);
    });
  });
}

/// Threads take one scene after the other; motions without samples are solved side by side.
std::vector<Outcome> solve_all(const std::vector<ScenePointer>& scenes, const SolveRequest& request,
                               std::size_t threads, const py::object& tell) {
  std::vector<Outcome> outcomes(scenes.size());
  ToldProgress progress{tell, 0, scenes.size()};
  beside_interpreter(
      [&](const std::function<bool()>& stopped) {
        std::atomic<std::size_t> taken = 0;
        const auto next = [&]() -> std::optional<std::size_t> {
          const std::size_t number = taken++;
          return number < scenes.size() && !stopped() ? std::optional(number) : std::nullopt;
        };
        const auto work = [&](std::size_t) {
          if (request.interval || !request.options.sample_times.empty()) {
            while (const auto number = next()) {
              outcomes[*number] = solved(scenes[*number], request, stopped);
              ++progress.done;
            }
          } else {
            solve_side_by_side(scenes, request.of({}, stopped), next, outcomes);
          }
          return std::string();
        };
        const std::vector<std::size_t> parts(threads);
        make_threads(threads)->run(parts, {work});
      },
      progress);
  return outcomes;
}

}  // namespace

void add_solve(py::module_& core) {
  py::class_<SolveRequest>(core, "SolveRequest")
      .def(py::init(&make_request), py::arg("interval"), py::arg("times"), py::arg("integrator"),
           py::arg("tolerance"), py::arg("step"));
  core.def("solve", &solve_one);
  core.def("solve_many", &solve_all);
}

}  // namespace rockstack::python
