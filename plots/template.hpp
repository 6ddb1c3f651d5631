#pragma once

#include <string_view>

namespace rockstack::plots {

/// The report's page with {{places}} to fill, its style sheet and its script, as in plots/report/.
extern const std::string_view page_html;
extern const std::string_view page_css;
extern const std::string_view page_js;

}  // namespace rockstack::plots
