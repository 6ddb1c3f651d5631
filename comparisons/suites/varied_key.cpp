#include "comparisons/suites/varied_key.hpp"

#include <fmt/format.h>

#include "analytic/scene/messages/input_error.hpp"
#include "analytic/scene/messages/one_line.hpp"
#include "comparisons/measures/results/csv.hpp"

namespace rockstack {

VariedKey varied_key(const std::string& option, const std::string& text) {
  const std::size_t equals = text.find('='), colon = text.find(':', equals);
  if (equals != std::string::npos && equals > 0 && colon != std::string::npos) {
    const auto low = number_in(text.substr(equals + 1, colon - equals - 1));
    const auto high = number_in(text.substr(colon + 1));
    if (low && high && *low < *high) return {text.substr(0, equals), *low, *high};
  }
  throw InputError(fmt::format("{} {}: must be KEY=LOW:HIGH with LOW below HIGH", option, one_line(text)));
}

}  // namespace rockstack
