#pragma once

#include <gtest/gtest.h>

#include "tests/analytic/scene/ground/records/layouts.hpp"

namespace rockstack {

/// A text that must be refused with a part of a message.
inline void expect_error(const std::string& text, const std::string& part) {
  EXPECT_NE(error_of_text(text).find(part), std::string::npos) << text << error_of_text(text);
}

}  // namespace rockstack
