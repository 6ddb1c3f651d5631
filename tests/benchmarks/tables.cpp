#include "tests/benchmarks/tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace rockstack::benchmarks {
namespace {

std::string printed(const char* format, double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

/// The settings of a method that no faster one betters, the fastest first.
std::vector<Measurement> front(const std::vector<Measurement>& measurements, const std::string& scene,
                               const std::string& method) {
  std::vector<Measurement> all;
  std::copy_if(measurements.begin(), measurements.end(), std::back_inserter(all), [&](const Measurement& m) {
    return m.scene == scene && m.method == method && std::isfinite(m.error);
  });
  std::sort(all.begin(), all.end(),
            [](const Measurement& a, const Measurement& b) { return a.seconds < b.seconds; });
  std::vector<Measurement> result;
  for (const Measurement& m : all)
    if (result.empty() || m.error < result.back().error) result.push_back(m);
  return result;
}

}  // namespace

std::vector<std::string> distinct(const std::vector<Measurement>& measurements,
                                  std::string Measurement::*field) {
  std::vector<std::string> result;
  for (const Measurement& measurement : measurements)
    if (std::find(result.begin(), result.end(), measurement.*field) == result.end())
      result.push_back(measurement.*field);
  return result;
}

std::optional<double> seconds_at(const std::vector<Measurement>& measurements, const std::string& scene,
                                 const std::string& method, double error) {
  const std::vector<Measurement> settings = front(measurements, scene, method);
  const auto enough =
      std::find_if(settings.begin(), settings.end(), [&](const Measurement& m) { return m.error <= error; });
  if (enough == settings.end()) return std::nullopt;
  if (enough == settings.begin()) return enough->seconds;
  const Measurement& before = *std::prev(enough);
  const double least = std::max(enough->error, std::numeric_limits<double>::min());
  const double share = std::log(before.error / error) / std::log(before.error / least);
  return before.seconds * std::pow(enough->seconds / before.seconds, share);
}

void write_columns(const std::vector<Measurement>& measurements, std::ostream& out) {
  out << "scene\tmethod\tsetting\terror_rad\ttime_s\n";
  for (const Measurement& m : measurements)
    out << m.scene << '\t' << m.method << '\t' << m.setting << '\t' << m.error << '\t' << m.seconds << '\n';
}

void write_equal_errors(const std::vector<Measurement>& measurements, std::span<const double> errors,
                        std::ostream& out) {
  const auto methods = distinct(measurements, &Measurement::method);
  out << "scene,error (rad)," << methods.front() << " (ms)";
  for (std::size_t i = 1; i < methods.size(); ++i) out << ',' << methods[i] << " (times)";
  out << '\n';
  for (const std::string& scene : distinct(measurements, &Measurement::scene)) {
    for (const double error : errors) {
      out << scene << ',' << printed("%.0e", error);
      const auto first = seconds_at(measurements, scene, methods.front(), error);
      for (const std::string& method : methods) {
        const auto seconds = seconds_at(measurements, scene, method, error);
        const bool is_time = method == methods.front();
        const double value = seconds ? *seconds * (is_time ? 1e3 : 1 / first.value_or(1)) : 0;
        out << ',' << (seconds ? printed(is_time ? "%.2g" : value < 9.95 ? "%.1f" : "%.0f", value) : "-");
      }
      out << '\n';
    }
  }
}

}  // namespace rockstack::benchmarks
