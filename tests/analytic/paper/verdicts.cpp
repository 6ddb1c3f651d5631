#include "tests/analytic/paper/verdicts.hpp"

#include <stdexcept>
#include <string>

namespace rockstack::paper {

std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::definition:
      return "definition";
    case Verdict::agrees:
      return "agrees";
    case Verdict::misprint:
      return "misprint";
    case Verdict::ambiguous:
      return "ambiguous";
  }
  throw std::invalid_argument("no such verdict");
}

const std::vector<VerdictRow>& verdicts() {
  using enum Verdict;
  static const std::vector<VerdictRow> rows{
      {1, 7, agrees},        {8, 9, misprint},      {10, 10, agrees},     {11, 11, definition},
      {12, 12, agrees},      {13, 13, misprint},    {14, 15, agrees},     {16, 17, definition},
      {18, 21, agrees},      {22, 24, misprint},    {25, 25, agrees},     {26, 27, definition},
      {28, 31, agrees},      {32, 35, misprint},    {36, 36, agrees},     {37, 38, misprint},
      {39, 39, agrees},      {40, 40, misprint},    {41, 55, agrees},     {56, 56, misprint},
      {57, 62, agrees},      {63, 63, misprint},    {64, 65, agrees},     {66, 66, misprint},
      {67, 91, agrees},      {92, 92, misprint},    {93, 98, agrees},     {99, 99, misprint},
      {100, 103, agrees},    {104, 104, misprint},  {105, 105, agrees},   {106, 106, ambiguous},
      {107, 107, misprint},  {108, 108, agrees},    {109, 110, misprint}, {111, 112, agrees},
      {113, 116, misprint},  {117, 117, ambiguous}, {118, 118, agrees},   {119, 119, ambiguous},
      {120, 120, agrees},    {121, 121, ambiguous}, {122, 122, misprint}, {123, 123, agrees},
      {124, 124, ambiguous}, {125, 127, agrees},    {128, 128, misprint}, {129, 129, agrees},
      {130, 130, misprint},  {131, 136, agrees},    {137, 138, misprint}, {139, 149, agrees},
      {150, 150, misprint},  {151, 154, agrees},    {155, 156, misprint}, {157, 163, agrees}};
  return rows;
}

Verdict verdict_of(int equation) {
  for (const VerdictRow& row : verdicts())
    if (row.first <= equation && equation <= row.last) return row.verdict;
  throw std::out_of_range("equation (" + std::to_string(equation) + ") has no verdict");
}

}  // namespace rockstack::paper
