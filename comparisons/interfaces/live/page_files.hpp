#pragma once

#include <string_view>

namespace rockstack::live {

// The files of comparisons/interfaces/live/page/, with {{places}} to fill.
extern const std::string_view live_html;
extern const std::string_view live_css;
extern const std::string_view live_js;
extern const std::string_view controls_js;
extern const std::string_view charts_js;

}  // namespace rockstack::live
