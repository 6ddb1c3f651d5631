#include "comparisons/interfaces/python/solve.hpp"

#include "analytic/solve.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analytic/scene/messages/input_error.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "analytic/solve_batch.hpp"
#include "comparisons/interfaces/python/interrupts.hpp"
#include "comparisons/interfaces/python/motion.hpp"
#include "comparisons/runs/execution/executor.hpp"

namespace rockstack::python {
namespace {

namespace py = pybind11;

using Times = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// What of a motion is asked for.
struct Asked {
  SolveOptions options = {.validity = true, .peaks = true};
  std::optional<double> interval;  ///< between samples, s

  SolveOptions of(const Scene& scene) const {
    SolveOptions result = options;
    if (interval) result.sample_times = regular_times(*interval, scene.duration);
    return result;
  }
};

/// A motion, whole or up to where it could not be followed, and then why.
using Outcome = std::pair<std::shared_ptr<HeldMotion>, std::optional<std::string>>;

void require_positive_number(const char* name, double value) {
  if (!(value > 0) || !std::isfinite(value))
    throw InputError(std::string(name) + " = " + number_text(value) + ": must be a finite number > 0");
}

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

Asked ask(const std::optional<double>& interval, const std::optional<Times>& times,
          const std::string& integrator, double tolerance, double step) {
  Asked asked;
  if (integrator != "taylor" && integrator != "rk4")
    throw InputError("integrator = " + integrator + ": must be taylor or rk4");
  asked.options.integrator = integrator == "rk4" ? Integrator::rk4 : Integrator::taylor;
  require_positive_number("step", step);
  asked.options.step = step;
  asked.options.tolerance = asked.options.resolution = tolerance;
  if (times) {
    asked.options.sample_times = sample_times(*times);
  } else if (interval) {
    require_positive_number("interval", *interval);
    asked.interval = interval;
  }
  validate(asked.options);
  return asked;
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

Outcome solve_one(const ScenePointer& scene, const Asked& asked) {
  try {
    const py::gil_scoped_release free;
    SolveOptions options = asked.of(scene->scene);
    const std::function<bool()> unwanted = Interrupts();
    options.cancelled = &unwanted;
    return outcome_of(scene, [&] { return solve(scene->scene, options); });
  } catch (const Stopped&) {
    throw py::error_already_set();
  }
}

/// Scenes that threads take one after the other.
class Pile {
 public:
  Pile(const std::vector<ScenePointer>& scenes, const Asked& asked, const std::atomic<bool>& stop)
      : outcomes(scenes.size()), scenes_(scenes), asked_(asked), stop_(stop), unwanted_([this] {
          return stop_.load();
        }) {}

  /// What each thread does. Motions without samples are solved side by side.
  void work() {
    if (asked_.interval || !asked_.options.sample_times.empty()) {
      while (const auto number = next()) outcomes[*number] = alone(scenes_[*number]);
    } else {
      batch();
    }
  }

  std::vector<Outcome> outcomes;

 private:
  std::optional<std::size_t> next() {
    const std::size_t number = next_++;
    return number < scenes_.size() && !stop_ ? std::optional(number) : std::nullopt;
  }

  Outcome alone(const ScenePointer& scene) const {
    SolveOptions options = asked_.of(scene->scene);
    options.cancelled = &unwanted_;
    return outcome_of(scene, [&] { return solve(scene->scene, options); });
  }

  void batch() {
    std::vector<std::size_t> numbers;
    const auto give = [&]() -> std::optional<Scene> {
      const auto number = next();
      if (!number) return std::nullopt;
      numbers.push_back(*number);
      return scenes_[*number]->scene;
    };
    SolveOptions options = asked_.options;
    options.cancelled = &unwanted_;
    solve_batch(give, options, [&](Solved&& solved) {
      const std::size_t number = numbers[solved.number];
      outcomes[number] = outcome_of(scenes_[number], [&] {
        if (solved.failure) std::rethrow_exception(solved.failure);
        return std::move(solved.history);
      });
    });
  }

  const std::vector<ScenePointer>& scenes_;
  const Asked& asked_;
  const std::atomic<bool>& stop_;
  std::function<bool()> unwanted_;
  std::atomic<std::size_t> next_ = 0;
};

std::vector<Outcome> solve_all(const std::vector<ScenePointer>& scenes, const Asked& asked,
                               std::size_t threads) {
  std::vector<Outcome> outcomes;
  beside_interpreter([&](const std::atomic<bool>& stop) {
    Pile pile(scenes, asked, stop);
    std::vector<std::size_t> parts(threads);
    make_threads(threads)->run(parts, {[&](std::size_t) {
                                         pile.work();
                                         return std::string();
                                       },
                                       [](std::size_t, const std::string&) {}, [] { return false; }});
    outcomes = std::move(pile.outcomes);
  });
  return outcomes;
}

}  // namespace

void add_solve(py::module_& core) {
  py::class_<Asked>(core, "Asked")
      .def(py::init(&ask), py::arg("interval"), py::arg("times"), py::arg("integrator"), py::arg("tolerance"),
           py::arg("step"));
  core.def("solve", &solve_one);
  core.def("solve_many", &solve_all);
}

}  // namespace rockstack::python
