#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <random>

#include "analytic/scene/ground/records/record_file.hpp"
#include "analytic/scene/messages/input_error.hpp"
#include "tests/analytic/scene/ground/records/layouts.hpp"

namespace rockstack {
namespace {

constexpr double step = 0.025;
constexpr std::size_t count = 40;

/// A unit as people spell it. Where it is ambiguous, or none, the file must be refused.
struct Spelling {
  const char* text;
  double factor;
  bool readable = true;
};

constexpr double inch = 0.0254, foot = 0.3048;
constexpr std::array spellings{Spelling{"m/s2", 1},
                               Spelling{"m/s^2", 1},
                               Spelling{"m/s**2", 1},
                               Spelling{"m/s\u00b2", 1},
                               Spelling{"m s-2", 1},
                               Spelling{"m s^-2", 1},
                               Spelling{"m s\u207b\u00b2", 1},
                               Spelling{"m\u00b7s\u207b\u00b2", 1},
                               Spelling{"m.s-2", 1},
                               Spelling{"m*s^-2", 1},
                               Spelling{"m * s^-2", 1},
                               Spelling{"m / s2", 1},
                               Spelling{"m/s/s", 1},
                               Spelling{"m/sec2", 1},
                               Spelling{"m/sec^2", 1},
                               Spelling{"m/sec/sec", 1},
                               Spelling{"M/S**2", 1},
                               Spelling{"M/S2", 1},
                               Spelling{"m/s^{2}", 1},
                               Spelling{"m/s^(2)", 1},
                               Spelling{"m/(s^2)", 1},
                               Spelling{"cm/s2", 0.01},
                               Spelling{"cm/s^2", 0.01},
                               Spelling{"cm s^-2", 0.01},
                               Spelling{"cm/sec/sec", 0.01},
                               Spelling{"CM/SEC**2", 0.01},
                               Spelling{"cm\u00b7s\u207b\u00b2", 0.01},
                               Spelling{"gal", 0.01},
                               Spelling{"Gal", 0.01},
                               Spelling{"gals", 0.01},
                               Spelling{"mm/s2", 1e-3},
                               Spelling{"mm s-2", 1e-3},
                               Spelling{"mm/s\u00b2", 1e-3},
                               Spelling{"in/s2", inch},
                               Spelling{"in/sec^2", inch},
                               Spelling{"ft/s2", foot},
                               Spelling{"ft/sec\u00b2", foot},
                               Spelling{"g", g},
                               Spelling{"G", g},
                               Spelling{"%g", 0.01 * g},
                               Spelling{"mg", 1e-3 * g},
                               Spelling{"m/s 2", 1, false},
                               Spelling{"m/s*s", 1, false},
                               Spelling{"m/s", 1, false},
                               Spelling{"ms-2", 1, false},
                               Spelling{"V", 1, false},
                               Spelling{"counts", 1, false}};

/// The signal of all files, m/s²: its peak is 0.35 g at 0.25 s.
double truth(std::size_t k) {
  const double t = step * static_cast<double>(k);
  return k == 10 ? 0.35 * g : 2.7 * std::sin(16 * t) * std::exp(-t);
}

/// A text under way, with the places where files differ.
struct File {
  Spelling unit;
  char separator = ',';
  char point = '.';
  std::string place, layout;
};

std::string digits(double value, const File& file, int decimals = 6) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*f", decimals, value);
  std::string text = buffer.data();
  std::ranges::replace(text, '.', file.point);
  return text;
}

/// A column: its title without a unit, its unit, and its numbers.
struct Column {
  std::string title, unit;
  std::function<std::string(std::size_t)> cell;
};

std::vector<Column> columns_of(const File& file) {
  const auto number = [file](double factor, double power) {
    return [=](std::size_t k) { return digits(truth(k) * power / factor, file, 8); };
  };
  const auto every = [file](double step_of_file) {
    return [=](std::size_t k) { return digits(step_of_file * static_cast<double>(k), file); };
  };
  const Column time{"Time", "s", every(step)}, milliseconds{"Time", "ms", every(1000 * step)};
  const Column acceleration{"Acceleration", file.unit.text, number(file.unit.factor, 1)};
  const Column velocity{"Velocity", "cm/s", number(0.01, 0.05)};
  const Column displacement{"Displacement", "mm", number(1e-3, 0.01)};
  const Column index{"", "", [](std::size_t k) { return std::to_string(k); }};
  const Column sample{"Sample", "", [](std::size_t k) { return std::to_string(k + 1); }};
  static const std::map<std::string, std::vector<int>> orders{
      {"plain", {0, 2}},        {"reversed", {2, 0}}, {"velocity first", {0, 3, 2}},
      {"all", {0, 2, 3, 4}},    {"index", {5, 0, 2}}, {"displacement first", {0, 4, 2}},
      {"milliseconds", {1, 2}}, {"alone", {2}},       {"sample", {6, 2}},
      {"no time", {3, 2}}};
  const std::array list{time, milliseconds, acceleration, velocity, displacement, index, sample};
  std::vector<Column> columns;
  for (const int k : orders.at(file.layout)) columns.push_back(list[static_cast<std::size_t>(k)]);
  return columns;
}

std::string joined(const std::vector<Column>& columns, const File& file,
                   const std::function<std::string(const Column&)>& text) {
  std::string line;
  for (const Column& column : columns)
    line +=
        (line.empty() && &column == &columns.front() ? "" : std::string(1, file.separator)) + text(column);
  return line + "\n";
}

std::string titles(const std::vector<Column>& columns, const File& file) {
  const auto with_unit = [&](const char* open, const char* close) {
    return joined(columns, file, [=](const Column& column) {
      return column.title + (column.unit.empty() ? "" : open + column.unit + close);
    });
  };
  // Milliseconds are said where their numbers are, whatever else is.
  const bool row = file.place == "row";
  const auto names = joined(columns, file, [&](const Column& column) {
    return column.title + (column.unit == "ms" && !row ? " (ms)" : "");
  });
  if (file.place == "round brackets") return with_unit(" (", ")");
  if (file.place == "square brackets") return with_unit(" [", "]");
  if (file.place == "words") return with_unit(" ", "");
  if (row) return names + joined(columns, file, [](const Column& column) { return column.unit; });
  return names;
}

std::string text_of(const File& file, int said) {
  const std::vector<Column> columns = columns_of(file);
  std::string text = "Station: made up (G)\n# PGA (g): 0.35\n";
  if (file.place == "units") text += std::string("# units: ") + file.unit.text + "\n";
  if (file.place == "sentence") text += std::string("# acceleration in ") + file.unit.text + ", time in s\n";
  const bool timed = columns.front().title == "Time" || columns.back().title == "Time" || columns.size() > 2;
  const char* const steps[] = {"dt = 0.025 s", "Sampling rate: 40 Hz", "Time step (ms): 25.0",
                               "Sampling interval = 25 milliseconds", "Sampling rate: 0.025 s"};
  if (!timed) text += std::string(steps[said]) + "\n";
  text += titles(columns, file);
  for (std::size_t k = 0; k < count; ++k)
    text += joined(columns, file, [&](const Column& column) { return column.cell(k); });
  return text;
}

std::string encoded(const std::string& text, const std::string& encoding) {
  if (encoding == "mark") return "\xEF\xBB\xBF" + text;
  if (encoding == "windows") return with_windows_line_ends(text);
  if (encoding == "no end") return text.substr(0, text.size() - 1);
  if (encoding == "latin" || encoding == "utf-16") {
    const bool wide = encoding == "utf-16";
    std::string bytes = wide ? "\xFF\xFE" : "";
    for (std::size_t k = 0; k < text.size(); ++k) {
      unsigned code = static_cast<unsigned char>(text[k]);
      if (code >= 0xe0) {
        code = ((code & 0xfU) << 12U) | ((static_cast<unsigned char>(text[k + 1]) & 0x3fU) << 6U) |
               (static_cast<unsigned char>(text[k + 2]) & 0x3fU);
        k += 2;
      } else if (code >= 0xc0) {
        code = ((code & 0x1fU) << 6U) | (static_cast<unsigned char>(text[++k]) & 0x3fU);
      }
      if (!wide && code > 0xff) return text;
      bytes += static_cast<char>(code & 0xffU);
      if (wide) bytes += static_cast<char>(code >> 8U);
    }
    return bytes;
  }
  return text;
}

/// Whether a record is that of the file: its peak and all samples to the decimals that are written.
bool is_true(const Record& record, const File& file) {
  if (std::abs(record.interval - step) > 1e-9 || record.samples.size() != count) return false;
  for (std::size_t k = 0; k < count; ++k)
    if (std::abs(record.samples[k] - truth(k)) > 1e-8 * file.unit.factor + 1e-12) return false;
  return true;
}

TEST(GeneratedRecords, AreReadRightlyOrRefusedWithWhatIsMissing) {
  const std::array places{"round brackets", "square brackets", "words", "row", "units", "sentence"};
  const std::array layouts{
      "plain",        "reversed", "velocity first", "all",    "index", "displacement first",
      "milliseconds", "alone",    "sample",         "no time"};
  const std::array encodings{"plain", "mark", "windows", "latin", "utf-16", "no end"};
  const std::array<std::pair<char, char>, 6> signs{
      {{',', '.'}, {';', '.'}, {';', ','}, {'\t', '.'}, {'\t', ','}, {' ', '.'}}};
  std::mt19937_64 random(1906);
  int files = 0, readable = 0, refused = 0;
  for (const Spelling& spelling : spellings)
    for (const char* place : places)
      for (const char* layout : layouts) {
        const auto& [separator, point] = signs[random() % signs.size()];
        const char* const encoding = encodings[random() % encodings.size()];
        const File file{spelling, separator, point, place, layout};
        const std::string text = text_of(file, static_cast<int>(random() % 5));
        ++files;
        readable += spelling.readable ? 1 : 0;
        try {
          const auto series = records::read_series("file", encoded(text, encoding));
          EXPECT_TRUE(spelling.readable && is_true(series.front(), file))
              << place << ", " << layout << ", " << encoding << ": " << series.front().interval << " s, "
              << series.front().taken << "\n"
              << text.substr(0, 300);
        } catch (const InputError& error) {
          const std::string line = error.what();
          refused += spelling.readable ? 1 : 0;
          EXPECT_TRUE(line.starts_with("file:") && line.find_first_of("0123456789") == 5) << line;
          EXPECT_TRUE(line.find("unit") != line.npos || line.find("step") != line.npos ||
                      line.find("time") != line.npos || line.find("column") != line.npos ||
                      line.find("this line has no end") != line.npos)
              << line;
          if (std::getenv("ROCKSTACK_SHOW_REFUSALS") != nullptr && spelling.readable)
            std::printf("%s | %s, %s, %s\n%s\n", line.c_str(), place, layout, encoding,
                        text.substr(0, 200).c_str());
        }
      }
  std::printf("%d files, %d of them say all: %d refused (%.1f %%)\n", files, readable, refused,
              100.0 * refused / readable);
  EXPECT_LT(refused, readable / 20);
}

}  // namespace
}  // namespace rockstack
