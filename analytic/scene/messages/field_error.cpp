#include "analytic/scene/messages/field_error.hpp"

#include <cmath>
#include <utility>

#include "analytic/scene/messages/number_text.hpp"

namespace rockstack {

FieldError::FieldError(std::string field, const std::string& value, const std::string& allowed)
    : std::invalid_argument(field + " = " + value + ": must be " + allowed), key(std::move(field)) {}

void require_positive(const std::string& key, double value) {
  if (!(value > 0) || !std::isfinite(value)) throw FieldError(key, number_text(value), "a finite number > 0");
}

void require_finite(const std::string& key, double value) {
  if (!std::isfinite(value)) throw FieldError(key, number_text(value), "a finite number");
}

}  // namespace rockstack
