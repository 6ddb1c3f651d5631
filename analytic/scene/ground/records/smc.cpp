#include "analytic/scene/ground/records/smc.hpp"

#include "analytic/scene/ground/records/units.hpp"

namespace rockstack::records {
namespace {

constexpr std::size_t text_lines = 11;
constexpr std::size_t integers = 48;
constexpr std::size_t reals = 50;
constexpr std::size_t comments_index = 15;
constexpr std::size_t samples_index = 16;

/// "2 CORRECTED ACCELEROGRAM", "3 VELOCITY" …
bool recognises(Cursor cursor) {
  const std::string_view line = trimmed(cursor.peek());
  if (line.size() < 2 || line[0] < '1' || line[0] > '9' || line[1] != ' ') return false;
  return contains(line, "accelerogram") || contains(line, "velocity") || contains(line, "displacement") ||
         contains(line, "spectr");
}

std::string_view field(std::string_view line, std::size_t place, std::size_t width) {
  return line.size() <= place * width ? std::string_view() : line.substr(place * width, width);
}

/// The number of comment lines, which may be 0, and of samples, from the third line of integers.
struct Counts {
  std::size_t comments = 0;
  std::size_t samples = 0;
};

Counts read_counts(Cursor& cursor) {
  constexpr std::size_t per_line = 8;
  constexpr std::size_t width = 10;
  Counts counts;
  for (std::size_t first = 0; first < integers; first += per_line) {
    const std::string_view line = cursor.next("the 48 integers of the header");
    if (first <= comments_index && comments_index < first + per_line) {
      const std::string_view text = field(line, comments_index - first, width);
      if (number(cursor, text) != 0) counts.comments = count(cursor, text);
    }
    if (first <= samples_index && samples_index < first + per_line) {
      counts.samples = count(cursor, field(line, samples_index - first, width));
    }
  }
  return counts;
}

std::vector<Record> read(Cursor cursor) {
  const std::string_view title = cursor.next("the title");
  if (!contains(title, "accelerogram")) {
    cursor.fail("holds " + quoted(trimmed(title)) + ": only an accelerogram can be used");
  }
  cursor.skip(text_lines - 1, "the header");
  const Counts counts = read_counts(cursor);
  const std::vector<double> header = read_columns(cursor, reals, {5, 15});
  const double null = header[0];
  if (header[1] == null) cursor.fail("the header gives no sampling rate (second of the 50 reals)");
  const double interval = checked_interval(cursor, 1 / header[1]);
  for (std::size_t k = 0; k < counts.comments; ++k) {
    if (!cursor.next("comment lines").starts_with('|')) cursor.fail("expected a comment line, \"|…\"");
  }
  std::vector<double> samples = read_columns(cursor, counts.samples, {8, 10}, null);
  cursor.skip_blank();
  if (!cursor.at_end()) {
    cursor.next({});
    cursor.fail("surplus line after " + std::to_string(counts.samples) + " samples");
  }
  return {make_record(interval, std::move(samples), centimetre_per_second_squared, "USGS SMC")};
}

}  // namespace

const Format smc{recognises, read};

}  // namespace rockstack::records
