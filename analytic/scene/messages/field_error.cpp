#include "analytic/scene/messages/field_error.hpp"

#include <utility>

#include "analytic/scene/messages/number_text.hpp"

namespace rockstack {

FieldError::FieldError(std::string field, const std::string& value, const std::string& allowed)
    : std::invalid_argument(field + " = " + value + ": must be " + allowed), key(std::move(field)) {}

void require_between(const std::string& key, double value, double least) {
  if (!(value >= least && value <= largest_number))
    throw FieldError(key, number_text(value),
                     "a number from " + number_text(least) + " to " + number_text(largest_number));
}

void require_positive(const std::string& key, double value) {
  require_between(key, value, 1 / largest_number);
}

void require_signed(const std::string& key, double value) {
  require_between(key, value, -largest_number);
}

}  // namespace rockstack
