#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace rockstack::testing {

/// True where a browser is installed that can be asked about a page.
bool has_browser();

/// Opens a page in headless Chromium, from a file and without network, and runs `probe` in it once it has
/// loaded: the body of an async function, with `wait(ms)` and `player`, whose result is returned. What the
/// page complains of, errors that nobody catches or words to console.error, is in `complaints`.
/// @throws std::runtime_error where the browser gives no answer.
struct Answer {
  nlohmann::json result;
  nlohmann::json complaints;
};
Answer ask_browser(const std::string& page, const std::string& probe);

}  // namespace rockstack::testing
