#pragma once

#include <optional>
#include <string>

#include "analytic/scene/ground/records/table.hpp"
#include "analytic/scene/ground/records/vocabulary.hpp"

namespace rockstack::records {

/// A unit that lines of text name, and the line that names another.
struct Stated {
  std::optional<Unit> unit = {};
  std::size_t line = 0, contradicted = 0;
};

/// What the lines of text of a file say of all its numbers.
struct Header {
  Stated acceleration = {};  ///< after "units" or "acceleration": "IN UNITS OF G"
  Stated other = {};         ///< a velocity's or displacement's, after "units"
  Stated aside = {};         ///< an acceleration's in brackets elsewhere: "RAW VALUES (gal)"; never g
  std::string unknown = {};  ///< stands after "units" or "acceleration", and is no unit of acceleration
  std::size_t unknown_line = 0;
  std::size_t acceleration_line = 0;  ///< that has that word; 0: none
  std::size_t mixed_line = 0;  ///< that has a velocity or a displacement, beside an acceleration; 0: none
  std::optional<double> interval = {};  ///< s
  std::size_t interval_line = 0;
  std::size_t resampled_line = 0;  ///< that says samples were left out, averaged or interpolated; 0: none
  std::size_t count = 0, count_line = 0;                ///< of values, after NPTS; else 0
  std::size_t stated_count = 0, stated_count_line = 0;  ///< of values, in other words; else 0
  std::optional<double> missing = {};                   ///< stands for missing data
  std::size_t spectrum_line = 0;                        ///< that says the numbers are a spectrum; 0: none
  std::size_t last_line = 0;                            ///< above the numbers
};

/// @throws InputError at a step or count that is none, and at a second one that differs.
Header read_header(const RecordTable& table);

/// Unit of all columns that have none of their own. @throws InputError where it is not named, or twice.
Unit stated_unit(const RecordTable& table, const Header& header);

/// The unit of a quantity that lines of text name after words of a topic, or after "units"; of times only
/// after such words. @throws InputError where another stands there, or two differ.
std::optional<Unit> unit_in_header(const RecordTable& table, Topic topic, Quantity quantity);

/// A unit among the words of a text, and what stands in its place.
struct Found {
  std::optional<Unit> unit = {};
  std::string_view text;
};

/// The unit that a segment begins with: its longest run of words that is one, unless a number or a sign of
/// units follows, which would belong to it.
Found unit_at(std::string_view text, std::size_t start);

/// Sets the time step. @throws InputError at the cursor's line where another was set before.
void note_interval(const Cursor& cursor, double interval, Header& header);

/// Reads time steps and rates in a line of the header, and "NPTS" with them. @throws InputError at a step
/// that is none, or differs from another.
void read_steps(const Cursor& cursor, const Line& line, bool may_count, Header& header);

/// Reads what else a line of the header says of all numbers: how many they are, which of them stands for
/// missing data, that they are a spectrum, that samples were left out or interpolated. @throws InputError
/// where they are to be multiplied by a factor, or are normalised: whether that has been done is not said.
void read_statements(const Cursor& cursor, const Line& line, Header& header);

}  // namespace rockstack::records
