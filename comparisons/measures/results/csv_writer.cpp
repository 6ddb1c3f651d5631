#include "comparisons/measures/results/csv_writer.hpp"

#include <fmt/format.h>

#include <iterator>

#include "comparisons/measures/results/csv.hpp"

namespace rockstack {

void CsvWriter::end_line() {
  text_ += '\n';
  begun_ = false;
}

void CsvWriter::separate() {
  if (begun_) text_ += ',';
  begun_ = true;
}

void CsvWriter::write(double number) {
  separate();
  fmt::format_to(std::back_inserter(text_), "{}", number);
}

void CsvWriter::write(std::ptrdiff_t number) {
  separate();
  fmt::format_to(std::back_inserter(text_), "{}", number);
}

void CsvWriter::write(std::string_view text) {
  separate();
  const char* guard = needs_guard(text) ? "'" : "";
  if (text.find_first_of(",\"\n") == std::string_view::npos) {
    text_ += guard;
    text_ += text;
    return;
  }
  text_ += '"';
  text_ += guard;
  for (const char letter : text) {
    if (letter == '"') text_ += '"';
    text_ += letter == '\n' ? ' ' : letter;
  }
  text_ += '"';
}

}  // namespace rockstack
