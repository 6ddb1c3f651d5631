#pragma once

#include <optional>
#include <vector>

#include "analytic/scene/ground/records/format.hpp"
#include "analytic/scene/ground/records/header.hpp"

namespace rockstack::records {

/// What a table holds: its time step, and columns that are a series each.
struct Content {
  Interval interval;
  std::vector<std::size_t> columns;
  std::vector<Unit> units;  ///< of those
};

/// Whether the numbers of a column count rows, one by one.
bool counts(const std::vector<double>& values);

/// Whether numbers rise by equal steps, as times do.
bool rises_evenly(const std::vector<double>& values);

/// The column of times: the one whose title says so; without titles the first, where it rises from row to row
/// as no acceleration does.
std::optional<std::size_t> time_column(const RecordTable& table, const Header& header);

/// The step that lines of text say. Precondition: they do.
Interval step_of(const Header& header);

/// The step of times, with which that of the header must agree, or that of the header alone.
Interval interval_of(const RecordTable& table, const Header& header, const std::optional<std::size_t>& time);

/// Takes of titled columns those of the highest derivative; without titles all but times and numbers of rows.
/// @throws InputError where there is none, where a unit is missing, unknown, or contradicts the header, and
/// where titles name factors.
Content titled_content(const RecordTable& table, const Header& header);
Content plain_content(const RecordTable& table, const Header& header);

}  // namespace rockstack::records
