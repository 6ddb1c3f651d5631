#include "analytic/scene/messages/input_error.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "analytic/scene/messages/number_text.hpp"

namespace rockstack {
namespace {

/// Letters put in, left out, replaced or changed with neighbours (Damerau 1964), by a table of beginnings.
std::size_t letters_apart(std::string_view one, std::string_view other) {
  std::vector<std::vector<std::size_t>> table(one.size() + 1, std::vector<std::size_t>(other.size() + 1));
  std::iota(table[0].begin(), table[0].end(), 0);
  for (std::size_t i = 1; i <= one.size(); ++i) {
    table[i][0] = i;
    for (std::size_t k = 1; k <= other.size(); ++k) {
      const std::size_t replaced = table[i - 1][k - 1] + (one[i - 1] == other[k - 1] ? 0 : 1);
      table[i][k] = std::min({replaced, table[i - 1][k] + 1, table[i][k - 1] + 1});
      if (i > 1 && k > 1 && one[i - 1] == other[k - 2] && one[i - 2] == other[k - 1])
        table[i][k] = std::min(table[i][k], table[i - 2][k - 2] + 1);
    }
  }
  return table[one.size()][other.size()];
}

}  // namespace

FieldError::FieldError(std::string field, const std::string& value, const std::string& allowed)
    : std::invalid_argument(field + " = " + value + ": must be " + allowed), key(std::move(field)) {}

FieldError::FieldError(std::string field, double value, const std::string& allowed)
    : FieldError(std::move(field), number_text(value), allowed) {}

void require_between(const std::string& key, double value, double least, double most) {
  if (!(value >= least && value <= most))
    throw FieldError(key, value, "a number from " + number_text(least) + " to " + number_text(most));
}

void require_each_between(const std::string& array, const std::vector<double>& values, double least,
                          double most) {
  for (std::size_t k = 0; k < values.size(); ++k)
    if (!(values[k] >= least && values[k] <= most))
      require_between(entry_key(array, k), values[k], least, most);
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& names) {
  const std::string* nearest = nullptr;
  std::size_t least = 0;
  for (const std::string& name : names) {
    const std::size_t apart = letters_apart(word, name);
    if (3 * apart > name.size() || (nearest != nullptr && apart >= least)) continue;
    nearest = &name;
    least = apart;
  }
  return nearest == nullptr ? "" : "; did you mean " + *nearest + "?";
}

}  // namespace rockstack
