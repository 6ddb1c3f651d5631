#pragma once

#include <map>
#include <string>

#include "plots/data/results.hpp"

namespace rockstack::plots {

/// A question that is answered before the text goes on: `question` is as comparisons write it, `numbers` are
/// the lesson's. Its answer is told once a choice or a number has been committed to.
std::string prediction_part(const Json& question, std::map<std::string, std::string> numbers);

}  // namespace rockstack::plots
