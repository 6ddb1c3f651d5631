#pragma once

#include <string_view>

namespace rockstack::plots {

/// The report's page with {{places}} to fill, its style sheet and its script, as in plots/report/.
extern const std::string_view page_html;
extern const std::string_view page_css;
extern const std::string_view page_js;

/// A lesson's page, and what its style sheet has beyond the report's.
extern const std::string_view lesson_html;
extern const std::string_view lesson_css;

/// One player, to be filled in likewise, and the style sheet and script of all players on a page.
extern const std::string_view player_html;
extern const std::string_view player_css;
extern const std::string_view player_js;

}  // namespace rockstack::plots
