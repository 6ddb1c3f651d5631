#pragma once

#include <vector>

#include "analytic/scene/ground/records/header.hpp"

namespace rockstack::records {

/// Refuses text between the numbers of a series, which may be the head of another.
void check_whole(const RecordTable& table);

/// Refuses numbers such as 025 between commas: what parts columns may be a decimal point as well.
void check_commas(const RecordTable& table);

/// Refuses a table whose header speaks of a spectrum, unless a title says in full that a column is time.
void check_history(const RecordTable& table, const Header& header);

/// Refuses numbers of lines, as of cards, among values that go on from line to line.
void check_cards(const RecordTable& table);

/// Refuses what the header says stands for missing data, in the columns of a series.
void check_present(const RecordTable& table, const Header& header, const std::vector<std::size_t>& columns);

/// Puts pairs of a time and a value that stand side by side below each other: where there are no titles, and
/// the times in the order of reading rise by equal steps.
void unfold_pairs(RecordTable& table);

/// Names the columns of a LabVIEW measurement file (.lvm) by its header: channels in the line X_Value, their
/// units after Y_Unit_Label, times in s. @throws InputError where the count after Samples is another, or
/// channels have times of their own.
void label_labview(RecordTable& table);

/// Refuses rows of numbers with text beside them below the last row, and numbers that are made comments
/// there.
void check_tail(const RecordTable& table);

/// Refuses a column in which some numbers have three digits after a point or comma, and all others none: it
/// may part thousands.
void check_thousands(const RecordTable& table, std::size_t column);

/// Refuses numbers of nines alone that come more than once and are more than twice as large as all others:
/// marks of missing data.
void check_marks(const RecordTable& table, std::size_t column);

}  // namespace rockstack::records
